using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Divides the sides of a polygon in the parameters until the chords follow the surface. A straight side is a curve on a curved
/// surface.</summary>
internal static class LoopOnSurface
{
    /// <summary>Largest distance between a chord and the surface at the same share of its length: as for boundaries read.</summary>
    private const double ToleranceMm = RegionTracer.ToleranceMm;

    /// <summary>Maximum number of halvings of one side.</summary>
    private const int MaxDepth = 12;

    /// <summary>Returns one side of a polygon from corner to corner, with the intermediate points that it needs.</summary>
    public static IReadOnlyList<Point2> Side(SplineSurface surface, Point2 from, Point2 to)
    {
        List<Point2> points = [from];
        Add(surface, points, from, to, 0);
        return points;
    }

    // Tested at a quarter, a half and three quarters. An S-shaped curve crosses its chord at no more than one of them.
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
