namespace ErrorMatching.Freeform;

/// <summary>The way of fitting that chooses.</summary>
internal static class BestFit
{
    /// <summary>
    /// The rule of <see cref="BestSurface"/>, unless the curve mesh misses left-out lines by less: it has the fewest poles of all, which on
    /// quadratics leaves the noise the least to bend.
    /// </summary>
    public static FittedSurface Of(PointGrid grid, double curveToleranceMm)
    {
        BestSurface.Check(grid);
        var mesh = Task.Run(() => SurfaceFitter.Fit(grid, FitMethod.ThroughCurveMesh, curveToleranceMm));
        var best = BestSurface.Fit(grid);
        var through = mesh.GetAwaiter().GetResult();
        return through.LeaveLineOutMm < best.LeaveLineOutMm ? through with { Method = FitMethod.Best } : best;
    }
}
