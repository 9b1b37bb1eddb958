namespace ErrorMatching.Geometry;

/// <summary>
/// Where two elements of the plane meet: lines, segments, circles and arcs in every pairing. A degenerate case is named by its
/// <see cref="IntersectionKind"/>, never dropped and never thrown.
/// </summary>
/// <remarks>
/// <para>
/// The tolerance, in millimetres, says what touches: a line whose distance from a circle's center differs from the radius by no more is
/// tangent and meets it in one point, elements no further apart are coincident, and a piece is met at its end if the end comes that near.
/// A tangency found this way replaces two crossings up to <c>2 sqrt(2 r tolerance)</c> apart, 0.3 micrometres for a radius of 10 mm and the default.
/// </para>
/// <para>
/// Two points are in order along the first element: along a line's or segment's direction, along an arc's travel, counter-clockwise from the
/// first axis on a circle. The ends of a coincident stretch are its entry and its exit in that travel. Coordinates must be finite.
/// </para>
/// </remarks>
public static partial class Intersect
{
    /// <summary>The tolerance that is used where none is given, in millimetres: a thousandth of what rounding does to a coordinate of a program, and far above that of <c>double</c>.</summary>
    public const double DefaultTolerance = 1e-9;

    /// <summary>Sine of the angle up to which two infinite lines are parallel: they part by 1e-9 mm on a metre.</summary>
    private const double ParallelSine = 1e-12;

    private static Intersection2 One(IntersectionKind kind, Point2 point) => new(kind, point, default, 1);

    private static Intersection2 Two(IntersectionKind kind, Point2 first, Point2 second) => new(kind, first, second, 2);

    /// <summary>A point as a piece without length: it is met where it lies on the other element.</summary>
    private static Intersection2 AtPoint(Point2 point, double distance, double tolerance) =>
        distance <= tolerance ? One(IntersectionKind.Crossing, point) : Intersection2.Nowhere(IntersectionKind.None);

    /// <summary>
    /// What is left of the meeting of two carriers when each is cut down to its piece. A carrier's point beyond an end is replaced by an end that touches the
    /// other piece, so that a corner whose elements stop a rounding error short of each other is still a corner.
    /// </summary>
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

    /// <summary>What restriction needs to know of an element: how far a point is from it, where along it a point lies, and where it ends.</summary>
    private sealed record Piece(Func<Point2, double> DistanceTo, Func<Point2, double> Along, Point2[] Ends)
    {
        public static Piece Of(Line2 line) => new(p => Math.Abs(line.SignedDistance(p)), line.Along, []);

        public static Piece Of(Segment2 segment) => new(segment.DistanceTo, segment.Line.Along, [segment.Start, segment.End]);

        public static Piece Of(Circle2 circle) => new(p => Math.Abs(circle.SignedDistance(p)), p => TurnFromAxis(circle, p), []);

        public static Piece Of(Arc2 arc) => new(arc.DistanceTo, arc.FractionOf, [arc.Start, arc.End]);
    }
}
