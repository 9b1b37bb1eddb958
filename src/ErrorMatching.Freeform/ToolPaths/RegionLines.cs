namespace ErrorMatching.Freeform;

/// <summary>Finds where lines of constant v are inside the region of a surface.</summary>
internal sealed class RegionLines
{
    // How far inside the region, as a share of its width, its first and last line are looked for:
    // an edge of the region that is such a line belongs to it.
    private const double Inside = 1e-9;

    private readonly SurfaceRegion _region;
    private readonly double _startU;
    private readonly double _endU;

    public RegionLines(PartSurface surface)
    {
        var (u, v) = (surface.Spline.KnotsU, surface.Spline.KnotsV);
        (_region, _startU, _endU) = (surface.Region, u.Start, u.End);
        First = _region.IsWhole ? v.Start : Math.Clamp(_region.Loops.SelectMany(l => l).Min(p => p.Y), v.Start, v.End);
        Last = _region.IsWhole ? v.End : Math.Clamp(_region.Loops.SelectMany(l => l).Max(p => p.Y), v.Start, v.End);
    }

    public double First { get; }

    public double Last { get; }

    /// <summary>The parts of a line inside the region, from low to high.</summary>
    public List<(double From, double To)> On(double v)
    {
        if (_region.IsWhole)
        {
            return [(_startU, _endU)];
        }

        var width = Last - First;
        var at = Math.Clamp(v, First + (Inside * width), Last - (Inside * width));
        var crossings = new List<double>();
        foreach (var loop in _region.Loops)
        {
            for (var i = 0; i < loop.Count; i++)
            {
                var (a, b) = (loop[i], loop[(i + 1) % loop.Count]);
                if (a.Y > at != b.Y > at)
                {
                    crossings.Add(Math.Clamp(a.X + ((b.X - a.X) * ((at - a.Y) / (b.Y - a.Y))), _startU, _endU));
                }
            }
        }

        crossings.Sort();
        var pieces = new List<(double, double)>();
        for (var i = 0; i + 1 < crossings.Count; i += 2)
        {
            if (crossings[i + 1] - crossings[i] > Inside * (_endU - _startU))
            {
                pieces.Add((crossings[i], crossings[i + 1]));
            }
        }

        return pieces;
    }
}
