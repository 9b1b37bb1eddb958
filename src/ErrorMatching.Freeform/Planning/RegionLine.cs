namespace ErrorMatching.Freeform;

/// <summary>A line of constant u or v with its precomputed crossings of a region's edges, because many places are tested and edges can be
/// long.</summary>
internal sealed class RegionLine
{
    // Null for the whole surface.
    private readonly double[]? _crossings;

    /// <summary>Calculates the crossings of a line.</summary>
    /// <param name="region">The region.</param>
    /// <param name="alongU">True if u varies.</param>
    /// <param name="at">The fixed parameter.</param>
    public RegionLine(SurfaceRegion region, bool alongU, double at)
    {
        if (region.IsWhole)
        {
            return;
        }

        var crossings = new List<double>();
        foreach (var loop in region.Loops)
        {
            for (var i = 0; i < loop.Count; i++)
            {
                var (a, b) = (loop[i], loop[i + 1 < loop.Count ? i + 1 : 0]);
                var (a1, a2, b1, b2) = alongU ? (a.X, a.Y, b.X, b.Y) : (a.Y, a.X, b.Y, b.X);
                if (a2 > at != b2 > at)
                {
                    crossings.Add(a1 + ((b1 - a1) * ((at - a2) / (b2 - a2))));
                }
            }
        }

        crossings.Sort();
        _crossings = [.. crossings];
    }

    /// <summary>True if a place on the line belongs to the region: an odd number of crossings follows it, as in
    /// <see cref="SurfaceRegion.Contains"/>.</summary>
    public bool IsInside(double t)
    {
        if (_crossings is null)
        {
            return true;
        }

        var (low, high) = (0, _crossings.Length);
        while (low < high)
        {
            var middle = (low + high) / 2;
            (low, high) = _crossings[middle] > t ? (low, middle) : (middle + 1, high);
        }

        return ((_crossings.Length - low) & 1) == 1;
    }
}
