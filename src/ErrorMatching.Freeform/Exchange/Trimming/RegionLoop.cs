using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Area and bounds of closed polygons in (u, v).</summary>
internal static class RegionLoop
{
    /// <summary>The enclosed area, positive if the loop runs counterclockwise (shoelace formula).</summary>
    public static double Area(IReadOnlyList<Point2> loop)
    {
        var sum = 0.0;
        for (var i = 0; i < loop.Count; i++)
        {
            var (a, b) = (loop[i], loop[(i + 1) % loop.Count]);
            sum += ((a.X - loop[0].X) * (b.Y - loop[0].Y)) - ((b.X - loop[0].X) * (a.Y - loop[0].Y));
        }

        return sum / 2;
    }

    /// <summary>The smallest and the largest parameters of polygons.</summary>
    /// <exception cref="InputException">The polygons have no width or no height.</exception>
    public static (Point2 Least, Point2 Most) Bounds(
        IReadOnlyList<IReadOnlyList<Point2>> loops, Func<string, string, InputException> fail)
    {
        var (least, most) = (
            new Point2(double.PositiveInfinity, double.PositiveInfinity), new Point2(double.NegativeInfinity, double.NegativeInfinity));
        foreach (var q in loops.SelectMany(l => l))
        {
            least = new(Math.Min(least.X, q.X), Math.Min(least.Y, q.Y));
            most = new(Math.Max(most.X, q.X), Math.Max(most.Y, q.Y));
        }

        return most.X > least.X && most.Y > least.Y
            ? (least, most)
            : throw fail("bad-loop", "the curves that limit the surface enclose nothing");
    }
}
