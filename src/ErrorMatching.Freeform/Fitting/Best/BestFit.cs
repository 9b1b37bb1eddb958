namespace ErrorMatching.Freeform;

/// <summary>Selects the better of two fits.</summary>
internal static class BestFit
{
    /// <summary>Uses <see cref="BestSurface"/> unless the curve mesh has a smaller line-out error. The mesh has the fewest poles, so that
    /// noise bends it least on quadratics. It does not replace a surface through the points if it misses as much as what that
    /// replaced.</summary>
    public static FittedSurface Fit(PointGrid grid, double curveToleranceMm)
    {
        BestSurface.Check(grid);
        var mesh = Task.Run(() => SurfaceFitter.Fit(grid, FitMethod.ThroughCurveMesh, curveToleranceMm));
        var best = BestSurface.Fit(grid);
        var through = mesh.GetAwaiter().GetResult();
        return through.LeaveLineOutMm < best.LeaveLineOutMm && !(best.IsThroughPoints && Misses(through, grid))
            ? through with { Method = FitMethod.Best }
            : best;
    }

    /// <summary>True if the points lie off a surface by more than noise.</summary>
    private static bool Misses(FittedSurface fit, PointGrid grid)
    {
        var (distance, laid) = (new SurfaceDistance(fit.Surface), FitGrid.Of(grid).Scattered());
        return LeftStructure.IsIn(new(
            [.. grid.Points.Select(p => p.I)],
            [.. grid.Points.Select(p => p.J)],
            laid.Us,
            laid.Vs,
            Array.ConvertAll(laid.Points, distance.To)));
    }
}
