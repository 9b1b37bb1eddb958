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
public static partial class Intersect
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
}
