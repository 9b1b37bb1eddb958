namespace ErrorMatching.Geometry;

/// <summary>A circle. A radius of zero is a point circle and allowed; a negative radius is not.</summary>
public readonly record struct Circle2
{
    /// <summary>Creates a circle about a center.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The radius is negative or not a number.</exception>
    public Circle2(Point2 center, double radius)
    {
        if (!(radius >= 0))
        {
            throw new ArgumentOutOfRangeException(nameof(radius), radius, "A radius is zero or more.");
        }

        Center = center;
        Radius = radius;
    }

    /// <summary>The center.</summary>
    public Point2 Center { get; }

    /// <summary>The nonnegative radius in millimeters.</summary>
    public double Radius { get; }

    /// <summary>The circle through three points.</summary>
    /// <exception cref="GeometryException">The points are collinear, or two of them coincide
    /// (<see cref="GeometryError.CollinearPoints"/>).</exception>
    public static Circle2 Through(Point2 a, Point2 b, Point2 c)
    {
        var (u, v) = (b - a, c - a);
        var doubledArea = u.Cross(v);
        var scale = u.Length * v.Length;
        if (!(Math.Abs(doubledArea) > 1e-12 * scale))
        {
            throw new GeometryException(GeometryError.CollinearPoints, "No circle runs through three points of one line.");
        }

        var toCenter = ((v.Left * -u.Dot(u)) + (u.Left * v.Dot(v))) / (2 * doubledArea);
        return new(a + toCenter, toCenter.Length);
    }

    /// <summary>Signed distance of a point: positive outside.</summary>
    public double SignedDistance(Point2 point) => Center.DistanceTo(point) - Radius;

    /// <summary>The point of the circle at an angle.</summary>
    public Point2 At(Angle angle) => Center + (Vector2.FromDirection(angle) * Radius);

    /// <summary>The nearest point of the circle.</summary>
    /// <exception cref="GeometryException">The point is the center, from which all points of the circle are equally far.</exception>
    public Point2 Foot(Point2 point) => Center + ((point - Center).Normalize() * Radius);
}
