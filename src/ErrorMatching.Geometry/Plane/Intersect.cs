namespace ErrorMatching.Geometry;

/// <summary>Intersects two elements of the plane: lines, segments, circles and arcs in every combination. Degenerate cases are reported by
/// <see cref="IntersectionKind"/>, never dropped or thrown.</summary>
/// <remarks>
/// <para>
/// The tolerance, in millimeters, defines touching. A line whose distance from a circle's center differs from the radius by no more is
/// tangent and meets it in one point; elements no farther apart are coincident; and an arc or segment is met at its end if the end is that
/// close.
/// A tangency within the tolerance replaces two crossings up to <c>2 sqrt(2 r tolerance)</c> apart: 0.3 micrometers for a radius of 10 mm
/// and the default.
/// </para>
/// <para>
/// Two points are in order along the first element: in the direction of a line or segment, along an arc's travel, counterclockwise from
/// the first axis on a circle. The ends of a coincident stretch are its entry and exit in that direction. Coordinates must be finite.
/// </para>
/// </remarks>
public static class Intersect
{
    /// <summary>The default tolerance in millimeters: far below the rounding in a program, and far above that of <c>double</c>.</summary>
    public const double DefaultTolerance = 1e-9;

    /// <summary>Sine of the largest angle between parallel lines: they diverge by 1e-9 mm per meter.</summary>
    private const double ParallelSine = 1e-12;

    private static Intersection2 One(IntersectionKind kind, Point2 point) => new(kind, point, default, 1);

    private static Intersection2 Two(IntersectionKind kind, Point2 first, Point2 second) => new(kind, first, second, 2);

    /// <summary>A point as an element of length zero, which is met if it is on the other element.</summary>
    private static Intersection2 AtPoint(Point2 point, double distance, double tolerance) =>
        distance <= tolerance ? One(IntersectionKind.Crossing, point) : Intersection2.Nowhere(IntersectionKind.None);

    /// <summary>Restricts the intersection of two carriers to their parts. A carrier's point beyond an end is replaced by an end that
    /// touches the other part, so that elements that stop a rounding error short of a corner still meet.</summary>
    private static Intersection2 Restrict(Intersection2 carriers, Piece a, Piece b, double tolerance)
    {
        if (carriers.Count == 0)
        {
            return carriers;
        }

        var first = OnBoth(carriers, carriers.First, a, b, tolerance);
        var second = carriers.Count == 2 ? OnBoth(carriers, carriers.Second, a, b, tolerance) : null;
        return (first, second) switch
        {
            (null, null) => Intersection2.Nowhere(IntersectionKind.None),
            ({ } p, null) => One(carriers.Kind, p),
            (null, { } p) => One(carriers.Kind, p),
            ({ } p, { } q) => a.Along(p) <= a.Along(q) ? Two(carriers.Kind, p, q) : Two(carriers.Kind, q, p),
        };
    }

    private static Point2? OnBoth(Intersection2 carriers, Point2 point, Piece a, Piece b, double tolerance)
    {
        if (a.DistanceTo(point) <= tolerance && b.DistanceTo(point) <= tolerance)
        {
            return point;
        }

        Point2? nearest = null;
        foreach (var (ends, other) in ((Point2[], Piece)[])[(a.Ends, b), (b.Ends, a)])
        {
            foreach (var end in ends)
            {
                if (other.DistanceTo(end) <= tolerance
                    && carriers.Nearest(end) == point
                    && (nearest is not { } known || point.DistanceTo(end) < point.DistanceTo(known)))
                {
                    nearest = end;
                }
            }
        }

        return nearest;
    }

    /// <summary>The properties of an element needed for the restriction: point distance, position along the element, and ends.</summary>
    private sealed record Piece(Func<Point2, double> DistanceTo, Func<Point2, double> Along, Point2[] Ends)
    {
        public static Piece Of(Line2 line) => new(p => Math.Abs(line.SignedDistance(p)), line.Along, []);

        public static Piece Of(Segment2 segment) => new(segment.DistanceTo, segment.Line.Along, [segment.Start, segment.End]);

        public static Piece Of(Circle2 circle) => new(p => Math.Abs(circle.SignedDistance(p)), p => TurnFromAxis(circle, p), []);

        public static Piece Of(Arc2 arc) => new(arc.DistanceTo, arc.FractionOf, [arc.Start, arc.End]);
    }

    // Lines and segments.

    /// <summary>Intersects two infinite lines: one crossing, parallel (sine of the angle to 1e-12), or coincident without ends.</summary>
    /// <param name="a">The first line.</param>
    /// <param name="b">The second line.</param>
    /// <param name="tolerance">Maximum distance between parallel lines that coincide, in millimeters.</param>
    public static Intersection2 Lines(Line2 a, Line2 b, double tolerance = DefaultTolerance)
    {
        var sine = a.Direction.Cross(b.Direction);
        if (Math.Abs(sine) <= ParallelSine)
        {
            return Intersection2.Nowhere(
                Math.Abs(a.SignedDistance(b.Origin)) <= tolerance ? IntersectionKind.Coincident : IntersectionKind.Parallel);
        }

        return One(IntersectionKind.Crossing, a.At((b.Origin - a.Origin).Cross(b.Direction) / sine));
    }

    /// <summary>Intersects an infinite line and a segment; coincident with the segment's ends, in order along the line.</summary>
    /// <param name="a">The line.</param>
    /// <param name="b">The segment. If its length is zero, it is a point, which crosses the line if it is on it.</param>
    /// <param name="tolerance">Tolerance for touching, in millimeters.</param>
    public static Intersection2 Lines(Line2 a, Segment2 b, double tolerance = DefaultTolerance)
    {
        var (atStart, atEnd) = (Math.Abs(a.SignedDistance(b.Start)), Math.Abs(a.SignedDistance(b.End)));
        if (b.Length == 0)
        {
            return AtPoint(b.Start, atStart, tolerance);
        }

        if (atStart <= tolerance && atEnd <= tolerance)
        {
            return a.Along(b.Start) <= a.Along(b.End)
                ? Two(IntersectionKind.Coincident, b.Start, b.End)
                : Two(IntersectionKind.Coincident, b.End, b.Start);
        }

        var carriers = Lines(a, b.Line, tolerance);
        return carriers.Kind == IntersectionKind.Crossing
            ? Restrict(carriers, Piece.Of(a), Piece.Of(b), tolerance)
            : Intersection2.Nowhere(IntersectionKind.Parallel);
    }

    /// <summary>Intersects a segment and an infinite line; coincident with the segment's ends.</summary>
    /// <param name="a">The segment. If its length is zero, it is a point, which crosses the line if it is on it.</param>
    /// <param name="b">The line.</param>
    /// <param name="tolerance">Tolerance for touching, in millimeters.</param>
    public static Intersection2 Lines(Segment2 a, Line2 b, double tolerance = DefaultTolerance)
    {
        var met = Lines(b, a, tolerance);
        return met.Kind == IntersectionKind.Coincident ? Two(met.Kind, a.Start, a.End) : met;
    }

    /// <summary>Intersects two segments: a crossing, a common stretch (coincident, with its ends), end to end on one line (tangent, one
    /// point), separate on one line (none), or parallel.</summary>
    /// <param name="a">The first segment. If its length is zero, it is a point, which crosses the other segment if it is on it.</param>
    /// <param name="b">The second segment, with the same rule.</param>
    /// <param name="tolerance">Tolerance for touching, in millimeters.</param>
    public static Intersection2 Lines(Segment2 a, Segment2 b, double tolerance = DefaultTolerance)
    {
        if (a.Length == 0)
        {
            return AtPoint(a.Start, b.DistanceTo(a.Start), tolerance);
        }

        if (b.Length == 0)
        {
            return AtPoint(b.Start, a.DistanceTo(b.Start), tolerance);
        }

        // Testing the shorter segment against the longer one's line is sufficient: overlapping parts are then within the tolerance.
        var (longer, shorter) = a.Length >= b.Length ? (a.Line, b) : (b.Line, a);
        if (Math.Abs(longer.SignedDistance(shorter.Start)) <= tolerance && Math.Abs(longer.SignedDistance(shorter.End)) <= tolerance)
        {
            return OnOneLine(a, b, tolerance);
        }

        var carriers = Lines(a.Line, b.Line, tolerance);
        return carriers.Kind == IntersectionKind.Crossing
            ? Restrict(carriers, Piece.Of(a), Piece.Of(b), tolerance)
            : Intersection2.Nowhere(IntersectionKind.Parallel);
    }

    private static Intersection2 OnOneLine(Segment2 a, Segment2 b, double tolerance)
    {
        var line = a.Line;
        var (from, to) = line.Along(b.Start) <= line.Along(b.End) ? (b.Start, b.End) : (b.End, b.Start);
        var entry = line.Along(from) > 0 ? from : a.Start;
        var exit = line.Along(to) < a.Length ? to : a.End;
        var common = line.Along(exit) - line.Along(entry);
        return common > tolerance ? Two(IntersectionKind.Coincident, entry, exit)
            : common >= -tolerance ? One(IntersectionKind.Tangent, entry)
            : Intersection2.Nowhere(IntersectionKind.None);
    }

    // Lines with circles; the straight element is always first.

    /// <summary>Intersects a line and a circle: two crossings, one tangency at the foot of the center, or none. A circle of radius zero is
    /// touched, never crossed.</summary>
    /// <param name="a">The line.</param>
    /// <param name="b">The circle.</param>
    /// <param name="tolerance">Maximum difference between center distance and radius for a tangency, in millimeters.</param>
    public static Intersection2 LineCircle(Line2 a, Circle2 b, double tolerance = DefaultTolerance)
    {
        var (foot, distance) = (a.Along(b.Center), Math.Abs(a.SignedDistance(b.Center)));
        if (Math.Abs(distance - b.Radius) <= tolerance)
        {
            return One(IntersectionKind.Tangent, a.At(foot));
        }

        if (distance > b.Radius)
        {
            return Intersection2.Nowhere(IntersectionKind.None);
        }

        // The product keeps digits near a tangency that a difference of squares would lose.
        var half = Math.Sqrt((b.Radius - distance) * (b.Radius + distance));
        return Two(IntersectionKind.Crossing, a.At(foot - half), a.At(foot + half));
    }

    /// <summary>Intersects a line and an arc.</summary>
    /// <param name="a">The line.</param>
    /// <param name="b">The arc.</param>
    /// <param name="tolerance">Tolerance for touching, in millimeters.</param>
    public static Intersection2 LineCircle(Line2 a, Arc2 b, double tolerance = DefaultTolerance) =>
        Restrict(LineCircle(a, b.Circle, tolerance), Piece.Of(a), Piece.Of(b), tolerance);

    /// <summary>Intersects a segment and a circle.</summary>
    /// <param name="a">The segment. If its length is zero, it is a point, which crosses the circle if it is on it.</param>
    /// <param name="b">The circle.</param>
    /// <param name="tolerance">Tolerance for touching, in millimeters.</param>
    public static Intersection2 LineCircle(Segment2 a, Circle2 b, double tolerance = DefaultTolerance) =>
        a.Length == 0
            ? AtPoint(a.Start, Math.Abs(b.SignedDistance(a.Start)), tolerance)
            : Restrict(LineCircle(a.Line, b, tolerance), Piece.Of(a), Piece.Of(b), tolerance);

    /// <summary>Intersects a segment and an arc.</summary>
    /// <param name="a">The segment. If its length is zero, it is a point, which crosses the arc if it is on it.</param>
    /// <param name="b">The arc.</param>
    /// <param name="tolerance">Tolerance for touching, in millimeters.</param>
    public static Intersection2 LineCircle(Segment2 a, Arc2 b, double tolerance = DefaultTolerance) =>
        a.Length == 0
            ? AtPoint(a.Start, b.DistanceTo(a.Start), tolerance)
            : Restrict(LineCircle(a.Line, b.Circle, tolerance), Piece.Of(a), Piece.Of(b), tolerance);

    // Circles and arcs.

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
