using System.Runtime.CompilerServices;

namespace ErrorMatching.Geometry;

/// <summary>A displacement in space, in millimeters if it is a length.</summary>
/// <param name="X">Component along X.</param>
/// <param name="Y">Component along Y.</param>
/// <param name="Z">Component along Z.</param>
public readonly record struct Vector3(double X, double Y, double Z)
{
    /// <summary>The zero displacement.</summary>
    public static Vector3 Zero => default;

    /// <summary>Euclidean length.</summary>
    public double Length
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Math.Sqrt((X * X) + (Y * Y) + (Z * Z));
    }

    /// <summary>The sum of two displacements.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 operator +(Vector3 a, Vector3 b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    /// <summary>The difference of two displacements.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 operator -(Vector3 a, Vector3 b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    /// <summary>A multiple of a displacement.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 operator *(Vector3 a, double factor) => new(a.X * factor, a.Y * factor, a.Z * factor);

    /// <summary>The negated displacement.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 operator -(Vector3 v) => new(-v.X, -v.Y, -v.Z);

    /// <summary>Scalar product.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public double Dot(Vector3 other) => (X * other.X) + (Y * other.Y) + (Z * other.Z);

    /// <summary>Vector product: perpendicular to both vectors, with a counterclockwise turn from this to the other.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector3 Cross(Vector3 other) => new((Y * other.Z) - (Z * other.Y), (Z * other.X) - (X * other.Z), (X * other.Y) - (Y * other.X));

    /// <summary>The unit vector in the same direction.</summary>
    /// <exception cref="GeometryException">The vector has no direction.</exception>
    public Vector3 Normalize()
    {
        var length = Length;
        return length > 0 && double.IsFinite(length)
            ? this * (1 / length)
            : throw new GeometryException(GeometryError.CoincidentPoints, "a direction of length zero");
    }
}
