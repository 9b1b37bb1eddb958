namespace ErrorMatching.Geometry;

/// <summary>A box aligned with the axes, in millimeters.</summary>
/// <param name="Min">The corner with the smallest coordinates.</param>
/// <param name="Max">The corner with the largest coordinates.</param>
public readonly record struct Box3(Point3 Min, Point3 Max)
{
    /// <summary>Length of the diagonal.</summary>
    public double Diagonal => (Max - Min).Length;

    /// <summary>The smallest box around points.</summary>
    /// <param name="points">At least one.</param>
    /// <exception cref="GeometryException">There are no points.</exception>
    public static Box3 Around(ReadOnlySpan<Point3> points)
    {
        if (points.Length == 0)
        {
            throw new GeometryException(GeometryError.TooFewPoints, "a box around no points; at least one is expected");
        }

        var (low, high) = (points[0], points[0]);
        foreach (var p in points)
        {
            low = new(Math.Min(low.X, p.X), Math.Min(low.Y, p.Y), Math.Min(low.Z, p.Z));
            high = new(Math.Max(high.X, p.X), Math.Max(high.Y, p.Y), Math.Max(high.Z, p.Z));
        }

        return new(low, high);
    }

    /// <summary>Distance of a point from the box, 0 inside.</summary>
    public double DistanceTo(Point3 p) =>
        new Vector3(Outside(p.X, Min.X, Max.X), Outside(p.Y, Min.Y, Max.Y), Outside(p.Z, Min.Z, Max.Z)).Length;

    /// <summary>Distance from another box, 0 if they touch.</summary>
    /// <param name="other">The other box.</param>
    public double DistanceTo(Box3 other) => new Vector3(
        Math.Max(0, Math.Max(other.Min.X - Max.X, Min.X - other.Max.X)),
        Math.Max(0, Math.Max(other.Min.Y - Max.Y, Min.Y - other.Max.Y)),
        Math.Max(0, Math.Max(other.Min.Z - Max.Z, Min.Z - other.Max.Z))).Length;

    private static double Outside(double x, double low, double high) => Math.Max(0, Math.Max(low - x, x - high));
}
