namespace ErrorMatching.Geometry;

/// <content>Straight with straight.</content>
public static partial class Intersect
{
    /// <summary>Where two infinite lines meet: one crossing, parallel (within 1e-12 of the sine of their angle), or coincident without ends.</summary>
    /// <param name="a">The first line.</param>
    /// <param name="b">The second line.</param>
    /// <param name="tolerance">How far apart parallel lines may be and still be one, in millimetres.</param>
    public static Intersection2 Lines(Line2 a, Line2 b, double tolerance = DefaultTolerance)
    {
        var sine = a.Direction.Cross(b.Direction);
        if (Math.Abs(sine) <= ParallelSine)
        {
            return Intersection2.Nowhere(Math.Abs(a.SignedDistance(b.Origin)) <= tolerance ? IntersectionKind.Coincident : IntersectionKind.Parallel);
        }

        return One(IntersectionKind.Crossing, a.At((b.Origin - a.Origin).Cross(b.Direction) / sine));
    }

    /// <summary>Where an infinite line meets a segment; coincident with the segment's ends, in order along the line.</summary>
    /// <param name="a">The line.</param>
    /// <param name="b">The segment. Without length it is a point, which is crossed if it lies on the line.</param>
    /// <param name="tolerance">What touches, in millimetres.</param>
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

    /// <summary>Where a segment meets an infinite line; coincident with the segment's own ends.</summary>
    /// <param name="a">The segment. Without length it is a point, which is crossed if it lies on the line.</param>
    /// <param name="b">The line.</param>
    /// <param name="tolerance">What touches, in millimetres.</param>
    public static Intersection2 Lines(Segment2 a, Line2 b, double tolerance = DefaultTolerance)
    {
        var met = Lines(b, a, tolerance);
        return met.Kind == IntersectionKind.Coincident ? Two(met.Kind, a.Start, a.End) : met;
    }

    /// <summary>
    /// Where two segments meet: a crossing, a common stretch (coincident, with its ends), end to end on one line (tangent, one point),
    /// on one line but apart (none), or parallel.
    /// </summary>
    /// <param name="a">The first segment. Without length it is a point, which is crossed if it lies on the other.</param>
    /// <param name="b">The second segment, likewise.</param>
    /// <param name="tolerance">What touches, in millimetres.</param>
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

        // The shorter segment on the longer one's line is enough: where they overlap they are within the tolerance.
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
