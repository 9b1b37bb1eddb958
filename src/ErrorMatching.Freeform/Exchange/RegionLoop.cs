using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Questions about a closed polygon of (u, v).</summary>
internal static class RegionLoop
{
    /// <summary>The area that it encloses, positive if it runs counter-clockwise (Gauss's formula of the trapezoids).</summary>
    public static double Area(IReadOnlyList<Point2> loop)
    {
        var sum = 0.0;
        for (var i = 0; i < loop.Count; i++)
        {
            var (a, b) = (loop[i], loop[(i + 1) % loop.Count]);
            sum += (a.X - loop[0].X) * (b.Y - loop[0].Y) - ((b.X - loop[0].X) * (a.Y - loop[0].Y));
        }

        return sum / 2;
    }
}
