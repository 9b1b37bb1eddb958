namespace ErrorMatching.Geometry;

/// <content>Round with round.</content>
public static partial class Intersect
{
    /// <summary>
    /// Where two circles meet: two crossings, one tangency (from outside or inside), none, parallel (one center, different radii) or coincident without ends.
    /// </summary>
    /// <param name="a">The first circle.</param>
    /// <param name="b">The second circle.</param>
    /// <param name="tolerance">What touches, and how far centers and radii of one circle may differ, in millimetres.</param>
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

        // Height of the triangle of the two centers and a crossing over its side "distance", by Heron's formula in factors.
        var along = (distance + ((a.Radius - b.Radius) * ((a.Radius + b.Radius) / distance))) / 2;
        var height = Math.Sqrt((distance + a.Radius + b.Radius) * (a.Radius + b.Radius - distance) * (distance + difference) * (distance - difference)) / (2 * distance);
        var foot = a.Center + (toward * along);
        var (right, left) = (foot - (toward.Left * height), foot + (toward.Left * height));
        return TurnFromAxis(a, right) <= TurnFromAxis(a, left) ? Two(IntersectionKind.Crossing, right, left) : Two(IntersectionKind.Crossing, left, right);
    }

    /// <summary>Where a circle meets an arc; coincident with the arc's ends, none if the arc is a whole circle.</summary>
    /// <param name="a">The circle.</param>
    /// <param name="b">The arc.</param>
    /// <param name="tolerance">What touches, in millimetres.</param>
    public static Intersection2 Circles(Circle2 a, Arc2 b, double tolerance = DefaultTolerance) => Circles(Whole(a), Piece.Of(a), b, Piece.Of(b), tolerance);

    /// <summary>Where an arc meets a circle; coincident with the arc's own ends, none if it is a whole circle.</summary>
    /// <param name="a">The arc.</param>
    /// <param name="b">The circle.</param>
    /// <param name="tolerance">What touches, in millimetres.</param>
    public static Intersection2 Circles(Arc2 a, Circle2 b, double tolerance = DefaultTolerance) => Circles(a, Piece.Of(a), Whole(b), Piece.Of(b), tolerance);

    /// <summary>
    /// Where two arcs meet. On one circle: coincident with the ends of the common stretch (the first in the first arc's travel where there are two of them),
    /// tangent where they only meet end to end, in one or two points.
    /// </summary>
    /// <param name="a">The first arc.</param>
    /// <param name="b">The second arc.</param>
    /// <param name="tolerance">What touches, in millimetres.</param>
    public static Intersection2 Circles(Arc2 a, Arc2 b, double tolerance = DefaultTolerance) => Circles(a, Piece.Of(a), b, Piece.Of(b), tolerance);

    private static Intersection2 Circles(Arc2 a, Piece pieceOfA, Arc2 b, Piece pieceOfB, double tolerance)
    {
        var carriers = Circles(a.Circle, b.Circle, tolerance);
        return carriers.Kind == IntersectionKind.Coincident ? OnOneCircle(a, b, tolerance) : Restrict(carriers, pieceOfA, pieceOfB, tolerance);
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

        // Both arcs as intervals of the angle travelled from the start of the first; the second may be met twice, a turn apart.
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
