namespace ErrorMatching.Geometry;

/// <summary>A circular arc: center, radius, start direction and signed sweep (positive counterclockwise). A sweep of 360 degrees is a full
/// circle; more means several turns.</summary>
/// <param name="Center">Center of the circle.</param>
/// <param name="Radius">Nonnegative radius.</param>
/// <param name="StartAngle">Direction from the center to the start.</param>
/// <param name="Sweep">Signed angle traveled, positive counterclockwise.</param>
public readonly record struct Arc2(Point2 Center, double Radius, Angle StartAngle, Angle Sweep)
{
    /// <summary>The circle of the arc.</summary>
    public Circle2 Circle => new(Center, Radius);

    /// <summary>First point.</summary>
    public Point2 Start => At(0);

    /// <summary>Point halfway along the arc.</summary>
    public Point2 Middle => At(0.5);

    /// <summary>Last point.</summary>
    public Point2 End => At(1);

    /// <summary>Length along the arc.</summary>
    public double Length => Radius * Math.Abs(Sweep.Radians);

    /// <summary>True for counterclockwise travel.</summary>
    public bool IsCounterClockwise => Sweep.Radians >= 0;

    /// <summary>The arc between two points about a center, with the radius of the start. Coincident ends give a full circle, as on every
    /// control.</summary>
    public static Arc2 Between(Point2 start, Point2 end, Point2 center, bool counterClockwise)
    {
        var from = (start - center).Direction;
        var sweep = ((end - center).Direction - from).Radians;
        if (counterClockwise && sweep <= 0)
        {
            sweep += 2 * Math.PI;
        }
        else if (!counterClockwise && sweep >= 0)
        {
            sweep -= 2 * Math.PI;
        }

        return new(center, start.DistanceTo(center), from, Angle.FromRadians(sweep));
    }

    /// <summary>The point at a fraction of the sweep, 0 to 1.</summary>
    public Point2 At(double fraction) => Center + (Vector2.FromDirection(StartAngle + (Sweep * fraction)) * Radius);

    /// <summary>Unit direction of travel at a fraction of the sweep.</summary>
    public Vector2 TangentAt(double fraction)
    {
        var outward = Vector2.FromDirection(StartAngle + (Sweep * fraction));
        return IsCounterClockwise ? outward.Left : -outward.Left;
    }

    /// <summary>Fraction of the sweep in the direction of a point from the center; outside 0 to 1 if the point is beyond an end (the
    /// nearer end decides the sign).</summary>
    public double FractionOf(Point2 point)
    {
        var fromMiddle = ((point - Center).Direction - (StartAngle + (Sweep * 0.5))).Normalized.Radians;
        return Sweep.Radians == 0 ? 0 : 0.5 + (fromMiddle / Sweep.Radians);
    }

    /// <summary>Fraction (0 to 1) at which the arc is nearest to a point.</summary>
    public double NearestFraction(Point2 point)
    {
        var fraction = FractionOf(point);
        return fraction is >= 0 and <= 1 ? fraction : point.DistanceTo(Start) <= point.DistanceTo(End) ? 0 : 1;
    }

    /// <summary>The largest distance of any of the arc's points from a circle. Along the arc, the distance from the other center is extreme
    /// at the ends and where the line of both centers crosses the arc.</summary>
    public double FurthestFrom(Circle2 circle)
    {
        var furthest = Math.Max(Math.Abs(circle.SignedDistance(Start)), Math.Abs(circle.SignedDistance(End)));
        var between = Center - circle.Center;
        var length = between.Length;
        if (length == 0)
        {
            return furthest;
        }

        foreach (var toward in (ReadOnlySpan<Vector2>)[between * (Radius / length), between * (-Radius / length)])
        {
            if (Math.Abs(Sweep.Degrees) >= 360 || FractionOf(Center + toward) is >= 0 and <= 1)
            {
                furthest = Math.Max(furthest, Math.Abs(circle.SignedDistance(Center + toward)));
            }
        }

        return furthest;
    }

    /// <summary>Distance from a point to the nearest point of the arc.</summary>
    public double DistanceTo(Point2 point) => point.DistanceTo(At(NearestFraction(point)));
}
