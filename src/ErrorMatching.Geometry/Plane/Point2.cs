using System.Globalization;

namespace ErrorMatching.Geometry;

/// <summary>A point in the plane, in millimeters.</summary>
/// <param name="X">First coordinate.</param>
/// <param name="Y">Second coordinate.</param>
public readonly record struct Point2(double X, double Y)
{
    /// <summary>The origin of the plane.</summary>
    public static Point2 Origin => default;

    /// <summary>True if both coordinates are finite numbers.</summary>
    public bool IsFinite => double.IsFinite(X) && double.IsFinite(Y);

    /// <summary>Distance to another point.</summary>
    public double DistanceTo(Point2 other) => (other - this).Length;

    /// <summary>Interpolates towards another point: 0 here, 1 there.</summary>
    public Point2 Lerp(Point2 other, double fraction) => new(X + ((other.X - X) * fraction), Y + ((other.Y - Y) * fraction));

    /// <summary>The coordinates as culture-independent text.</summary>
    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"({X}, {Y})");

    /// <summary>The point displaced by a vector.</summary>
    public static Point2 operator +(Point2 p, Vector2 v) => new(p.X + v.X, p.Y + v.Y);

    /// <summary>The point displaced by a negated vector.</summary>
    public static Point2 operator -(Point2 p, Vector2 v) => new(p.X - v.X, p.Y - v.Y);

    /// <summary>The displacement from <paramref name="b"/> to <paramref name="a"/>.</summary>
    public static Vector2 operator -(Point2 a, Point2 b) => new(a.X - b.X, a.Y - b.Y);
}
