using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Lays a surface through or near a grid of points by a method of one's choice.</summary>
public static class SurfaceFitter
{
    /// <summary>The surface, with its error when whole grid lines are left out.</summary>
    /// <param name="grid">At least two curves of at least two points each; neighbors differ.</param>
    /// <param name="method">The way of fitting.</param>
    /// <param name="curveToleranceMm">Mean distance in millimetres that decides on the degree and the poles of the curves of <see cref="FitMethod.ThroughCurves"/> and <see cref="FitMethod.ThroughCurveMesh"/>: the lowest degree that stays under it.</param>
    /// <exception cref="GeometryException">The points determine no surface.</exception>
    /// <exception cref="FreeformException">As for <see cref="BestSurface.Fit"/>.</exception>
    public static FittedSurface Fit(PointGrid grid, FitMethod method, double curveToleranceMm)
    {
        ArgumentNullException.ThrowIfNull(grid);
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(curveToleranceMm);
        if (method == FitMethod.Best)
        {
            return Best(grid, curveToleranceMm);
        }

        var points = FitGrid.Of(grid);
        var (surface, again) = Lay(points, method, curveToleranceMm);
        return new(method, surface, [], [], LineOutError.Mean(grid, points, g => again(FitGrid.Of(g))));
    }

    /// <summary>The rule of <see cref="BestSurface"/>, unless the curve mesh misses left-out lines by less: it has the fewest poles of all, which on quadratics leaves the noise the least to bend.</summary>
    private static FittedSurface Best(PointGrid grid, double curveToleranceMm)
    {
        BestSurface.Check(grid);
        var mesh = Task.Run(() => Fit(grid, FitMethod.ThroughCurveMesh, curveToleranceMm));
        var best = BestSurface.Fit(grid);
        var through = mesh.GetAwaiter().GetResult();
        return through.LeaveLineOutMm < best.LeaveLineOutMm ? through with { Method = FitMethod.Best } : best;
    }

    /// <summary>The surface, and how to lay one through a part of the points: with the degree, poles or weight that all points have chosen.</summary>
    private static (SplineSurface Surface, Func<FitGrid, SplineSurface> Again) Lay(FitGrid grid, FitMethod method, double toleranceMm)
    {
        Func<FitGrid, SplineSurface> lay;
        switch (method)
        {
            case FitMethod.ThroughCurveMesh:
                lay = CurveMeshFit.Choose(grid, toleranceMm).Fit;
                break;
            case FitMethod.ThroughCurves:
                var family = CurveFamily.Choose(grid.Curves, grid.CurveUs, toleranceMm);
                lay = g => SplineSurfaceFit.Skin(family.Fit(g.Curves, g.CurveUs), g.Vs);
                break;
            case FitMethod.FitSurface:
                lay = NetFit.Fit;
                break;
            case FitMethod.StudioSurface:
                var smoothed = StudioFit.Fit(grid, null);
                return (smoothed.Surface, g => StudioFit.Fit(g, smoothed.Weight).Surface);
            case FitMethod.Tensor:
                lay = GridSurface.Interpolate;
                break;
            default:
                throw new ArgumentOutOfRangeException(nameof(method), method, "A way of fitting that has a name.");
        }

        return (lay(grid), lay);
    }
}
