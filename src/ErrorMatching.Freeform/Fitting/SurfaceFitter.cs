using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform;

/// <summary>Fits a surface to a grid of points by a selected method.</summary>
public static class SurfaceFitter
{
    /// <summary>Returns the surface with its line-out error.</summary>
    /// <param name="grid">At least two curves of at least two points each; neighbors differ.</param>
    /// <param name="method">The way of fitting.</param>
    /// <param name="curveToleranceMm">Mean distance in millimeters that determines the degree and poles of the curves of
    /// <see cref="FitMethod.ThroughCurves"/> and <see cref="FitMethod.ThroughCurveMesh"/>: the lowest degree that stays below it.</param>
    /// <exception cref="GeometryException">The points do not determine a surface.</exception>
    /// <exception cref="InputException">As for <see cref="BestSurface.Fit"/>.</exception>
    public static FittedSurface Fit(PointGrid grid, FitMethod method, double curveToleranceMm)
    {
        ArgumentNullException.ThrowIfNull(grid);
        ArgumentNullException.ThrowIfNull(method);
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(curveToleranceMm);
        return method.Fit(grid, curveToleranceMm, method);
    }
}
