using System.Globalization;

namespace ErrorMatching.Geometry;

/// <summary>A displacement in the plane, in millimeters if it is a length.</summary>
/// <param name="X">Component along the first axis of the plane.</param>
/// <param name="Y">Component along the second axis of the plane.</param>
public readonly record struct Vector2(double X, double Y)
{
    /// <summary>The zero displacement.</summary>
    public static Vector2 Zero => default;

    /// <summary>Euclidean length.</summary>
    public double Length => Math.Sqrt((X * X) + (Y * Y));

    /// <summary>This vector rotated a quarter turn to the left (counterclockwise).</summary>
    public Vector2 Left => new(-Y, X);

    /// <summary>The direction, counterclockwise from the first axis, in (-180, 180] degrees; zero for the zero vector.</summary>
    public Angle Direction => Angle.FromRadians(Elementary.Atan2(Y, X));

    /// <summary>The unit vector at an angle, counterclockwise from the first axis.</summary>
    public static Vector2 FromDirection(Angle angle) => new(Elementary.Cos(angle.Radians), Elementary.Sin(angle.Radians));

    /// <summary>Scalar product.</summary>
    public double Dot(Vector2 other) => (X * other.X) + (Y * other.Y);

    /// <summary>Third component of the cross product: positive if <paramref name="other"/> points to the left of this vector.</summary>
    public double Cross(Vector2 other) => (X * other.Y) - (Y * other.X);

    /// <summary>The unit vector in the same direction.</summary>
    /// <exception cref="GeometryException">The vector is zero (<see cref="GeometryError.CoincidentPoints"/>).</exception>
    public Vector2 Normalize()
    {
        var length = Length;
        return length > 0
            ? this / length
            : throw new GeometryException(GeometryError.CoincidentPoints, "A direction was asked of two points that coincide.");
    }

    /// <summary>The components as culture-independent text.</summary>
    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"({X}, {Y})");

    /// <summary>The sum of two displacements.</summary>
    public static Vector2 operator +(Vector2 a, Vector2 b) => new(a.X + b.X, a.Y + b.Y);

    /// <summary>The difference of two displacements.</summary>
    public static Vector2 operator -(Vector2 a, Vector2 b) => new(a.X - b.X, a.Y - b.Y);

    /// <summary>The negated displacement.</summary>
    public static Vector2 operator -(Vector2 a) => new(-a.X, -a.Y);

    /// <summary>A multiple of a displacement.</summary>
    public static Vector2 operator *(Vector2 a, double factor) => new(a.X * factor, a.Y * factor);

    /// <summary>A multiple of a displacement.</summary>
    public static Vector2 operator *(double factor, Vector2 a) => a * factor;

    /// <summary>A fraction of a displacement.</summary>
    public static Vector2 operator /(Vector2 a, double divisor) => new(a.X / divisor, a.Y / divisor);
}
