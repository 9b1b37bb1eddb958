namespace ErrorMatching.Geometry;

/// <summary>A straight segment from a start to an end. If both coincide, it has no direction, but length 0 and a nearest point.</summary>
/// <param name="Start">First point.</param>
/// <param name="End">Last point.</param>
public readonly record struct Segment2(Point2 Start, Point2 End)
{
    /// <summary>Distance between the ends.</summary>
    public double Length => Start.DistanceTo(End);

    /// <summary>The midpoint.</summary>
    public Point2 Middle => Start.Lerp(End, 0.5);

    /// <summary>The infinite line of the segment.</summary>
    /// <exception cref="GeometryException">The ends coincide.</exception>
    public Line2 Line => Line2.Through(Start, End);

    /// <summary>The point at a fraction of the length, 0 to 1.</summary>
    public Point2 At(double fraction) => Start.Lerp(End, fraction);

    /// <summary>Fraction (0 to 1) at which the segment is nearest to a point; 0 if the length is zero.</summary>
    public double NearestFraction(Point2 point)
    {
        var d = End - Start;
        var squared = d.Dot(d);
        return squared > 0 ? Math.Clamp((point - Start).Dot(d) / squared, 0, 1) : 0;
    }

    /// <summary>Distance from a point to the nearest point of the segment.</summary>
    public double DistanceTo(Point2 point) => point.DistanceTo(At(NearestFraction(point)));
}
