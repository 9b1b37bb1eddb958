namespace ErrorMatching.Geometry;

/// <content>Lines and segments.</content>
public static partial class Intersect
{
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
}
