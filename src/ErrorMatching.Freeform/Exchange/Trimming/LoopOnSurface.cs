using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A polygon of the parameters in space: a straight side is a curve on a curved surface, so it is divided until its chords lie on the surface.</summary>
internal static class LoopOnSurface
{
    /// <summary>How far a chord may be from the surface at the same share of its length: that of limits that are read.</summary>
    private const double ToleranceMm = RegionTracer.ToleranceMm;

    /// <summary>Halvings of one side.</summary>
    private const int MaxDepth = 12;

    /// <summary>One side of a polygon from corner to corner, with as many points between as it takes.</summary>
    public static IReadOnlyList<Point2> Side(SplineSurface surface, Point2 from, Point2 to)
    {
        List<Point2> points = [from];
        Add(surface, points, from, to, 0);
        return points;
    }

    // At a quarter, a half and three quarters: a curve that turns back crosses its chord at one of them at most.
    private static void Add(SplineSurface surface, List<Point2> points, Point2 from, Point2 to, int depth)
    {
        var (start, end) = (surface.PointAt(from.X, from.Y), surface.PointAt(to.X, to.Y));
        if (depth < MaxDepth && (Off(0.25) > ToleranceMm || Off(0.5) > ToleranceMm || Off(0.75) > ToleranceMm))
        {
            var middle = from + ((to - from) * 0.5);
            Add(surface, points, from, middle, depth + 1);
            Add(surface, points, middle, to, depth + 1);
            return;
        }

        points.Add(to);

        double Off(double t)
        {
            var p = from + ((to - from) * t);
            return (surface.PointAt(p.X, p.Y) - (start + ((end - start) * t))).Length;
        }
    }
}
