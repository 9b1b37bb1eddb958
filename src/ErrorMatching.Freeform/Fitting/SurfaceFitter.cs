using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Lays a surface through or near a grid of points by a method of one's choice.</summary>
public static class SurfaceFitter
{
    /// <summary>The surface, with its error when whole grid lines are left out.</summary>
    /// <param name="grid">At least two curves of at least two points each; neighbors differ.</param>
    /// <param name="method">The way of fitting.</param>
    /// <param name="curveToleranceMm">
    /// Mean distance in millimeters that decides on the degree and the poles of the curves of <see cref="FitMethod.ThroughCurves"/> and
    /// <see cref="FitMethod.ThroughCurveMesh"/>: the lowest degree that stays under it.
    /// </param>
    /// <exception cref="GeometryException">The points determine no surface.</exception>
    /// <exception cref="FreeformException">As for <see cref="BestSurface.Fit"/>.</exception>
    public static FittedSurface Fit(PointGrid grid, FitMethod method, double curveToleranceMm)
    {
        ArgumentNullException.ThrowIfNull(grid);
        ArgumentNullException.ThrowIfNull(method);
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(curveToleranceMm);
        return method.Fit(grid, curveToleranceMm, method);
    }
}
