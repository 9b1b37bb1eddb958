namespace ErrorMatching.Geometry;

/// <content>Circles and arcs.</content>
public static partial class Intersect
{
    /// <summary>Intersects two circles: two crossings, one tangency (external or internal), none, parallel (same center, different radii),
    /// or coincident without ends.</summary>
    /// <param name="a">The first circle.</param>
    /// <param name="b">The second circle.</param>
    /// <param name="tolerance">Tolerance for touching and for centers and radii of coincident circles, in millimeters.</param>
    public static Intersection2 Circles(Circle2 a, Circle2 b, double tolerance = DefaultTolerance)
    {
        var between = b.Center - a.Center;
        var (distance, difference) = (between.Length, Math.Abs(a.Radius - b.Radius));
        if (distance <= tolerance)
        {
            return Intersection2.Nowhere(difference <= tolerance ? IntersectionKind.Coincident : IntersectionKind.Parallel);
        }

        var toward = between / distance;
        if (Math.Abs(distance - a.Radius - b.Radius) <= tolerance)
        {
            return One(IntersectionKind.Tangent, a.Center + (toward * a.Radius));
        }

        if (Math.Abs(distance - difference) <= tolerance)
        {
            return One(IntersectionKind.Tangent, a.Center + (toward * (a.Radius > b.Radius ? a.Radius : -a.Radius)));
        }

        if (distance > a.Radius + b.Radius || distance < difference)
        {
            return Intersection2.Nowhere(IntersectionKind.None);
        }

        // Height of the triangle of the two centers and a crossing over the side "distance", by Heron's formula in factors.
        var along = (distance + ((a.Radius - b.Radius) * ((a.Radius + b.Radius) / distance))) / 2;
        var height = Math.Sqrt(
            (distance + a.Radius + b.Radius) * (a.Radius + b.Radius - distance) * (distance + difference) * (distance - difference))
            / (2 * distance);
        var foot = a.Center + (toward * along);
        var (right, left) = (foot - (toward.Left * height), foot + (toward.Left * height));
        return TurnFromAxis(a, right) <= TurnFromAxis(a, left)
            ? Two(IntersectionKind.Crossing, right, left)
            : Two(IntersectionKind.Crossing, left, right);
    }

    /// <summary>Intersects a circle and an arc; coincident with the arc's ends, or without ends if the arc is a full circle.</summary>
    /// <param name="a">The circle.</param>
    /// <param name="b">The arc.</param>
    /// <param name="tolerance">Tolerance for touching, in millimeters.</param>
    public static Intersection2 Circles(Circle2 a, Arc2 b, double tolerance = DefaultTolerance) =>
        Circles(Whole(a), Piece.Of(a), b, Piece.Of(b), tolerance);

    /// <summary>Intersects an arc and a circle; coincident with the arc's ends, or without ends if it is a full circle.</summary>
    /// <param name="a">The arc.</param>
    /// <param name="b">The circle.</param>
    /// <param name="tolerance">Tolerance for touching, in millimeters.</param>
    public static Intersection2 Circles(Arc2 a, Circle2 b, double tolerance = DefaultTolerance) =>
        Circles(a, Piece.Of(a), Whole(b), Piece.Of(b), tolerance);

    /// <summary>Intersects two arcs. On the same circle, they are coincident with the ends of the common stretch (the first one along the
    /// first arc if there are two), or tangent if they only meet end to end, in one or two points.</summary>
    /// <param name="a">The first arc.</param>
    /// <param name="b">The second arc.</param>
    /// <param name="tolerance">Tolerance for touching, in millimeters.</param>
    public static Intersection2 Circles(Arc2 a, Arc2 b, double tolerance = DefaultTolerance) =>
        Circles(a, Piece.Of(a), b, Piece.Of(b), tolerance);

    private static Intersection2 Circles(Arc2 a, Piece pieceOfA, Arc2 b, Piece pieceOfB, double tolerance)
    {
        var carriers = Circles(a.Circle, b.Circle, tolerance);
        return carriers.Kind == IntersectionKind.Coincident
            ? OnOneCircle(a, b, tolerance)
            : Restrict(carriers, pieceOfA, pieceOfB, tolerance);
    }

    private static Intersection2 OnOneCircle(Arc2 a, Arc2 b, double tolerance)
    {
        const double turn = 2 * Math.PI;
        var slack = a.Radius > 0 ? tolerance / a.Radius : turn;
        var (lengthA, lengthB) = (Math.Abs(a.Sweep.Radians), Math.Abs(b.Sweep.Radians));
        var (closedA, closedB) = (lengthA >= turn - slack, lengthB >= turn - slack);
        var sameWay = a.IsCounterClockwise == b.IsCounterClockwise;
        if (closedA)
        {
            return closedB ? Intersection2.Nowhere(IntersectionKind.Coincident)
                : lengthB <= slack ? One(IntersectionKind.Tangent, b.Start)
                : sameWay ? Two(IntersectionKind.Coincident, b.Start, b.End) : Two(IntersectionKind.Coincident, b.End, b.Start);
        }

        if (closedB)
        {
            return lengthA <= slack ? One(IntersectionKind.Tangent, a.Start) : Two(IntersectionKind.Coincident, a.Start, a.End);
        }

        // Both arcs as intervals of the angle traveled from the start of the first. The second is tried at two positions, one turn apart.
        var entryOfB = sameWay ? b.StartAngle : b.StartAngle + b.Sweep;
        var ahead = (entryOfB - a.StartAngle).Radians * (a.IsCounterClockwise ? 1 : -1);
        ahead -= turn * Math.Floor(ahead / turn);
        var touches = new List<Point2>();
        foreach (var from in (ReadOnlySpan<double>)[ahead - turn, ahead])
        {
            var (entry, exit) = (Math.Max(0, from), Math.Min(lengthA, from + lengthB));
            if (exit - entry > slack)
            {
                return Two(IntersectionKind.Coincident, a.At(entry / lengthA), a.At(exit / lengthA));
            }

            if (exit - entry >= -slack)
            {
                touches.Add(lengthA > 0 ? a.At(Math.Clamp(entry / lengthA, 0, 1)) : a.Start);
            }
        }

        return touches.Count switch
        {
            0 => Intersection2.Nowhere(IntersectionKind.None),
            1 => One(IntersectionKind.Tangent, touches[0]),
            _ => Two(IntersectionKind.Tangent, touches[0], touches[1]),
        };
    }

    private static Arc2 Whole(Circle2 circle) => new(circle.Center, circle.Radius, default, Angle.FromRadians(2 * Math.PI));

    /// <summary>Direction from the center to a point, in [0, 2 pi).</summary>
    private static double TurnFromAxis(Circle2 circle, Point2 point)
    {
        var turned = (point - circle.Center).Direction.Radians;
        return turned < 0 ? turned + (2 * Math.PI) : turned;
    }
}
