namespace ErrorMatching.Freeform;

/// <summary>Selects the better of two fits.</summary>
internal static class BestFit
{
    /// <summary>Uses <see cref="BestSurface"/> unless the curve mesh has a smaller line-out error. The mesh has the fewest poles, so that
    /// noise bends it least on quadratics.</summary>
    public static FittedSurface Of(PointGrid grid, double curveToleranceMm)
    {
        BestSurface.Check(grid);
        var mesh = Task.Run(() => SurfaceFitter.Fit(grid, FitMethod.ThroughCurveMesh, curveToleranceMm));
        var best = BestSurface.Fit(grid);
        var through = mesh.GetAwaiter().GetResult();
        return through.LeaveLineOutMm < best.LeaveLineOutMm ? through with { Method = FitMethod.Best } : best;
    }
}
