using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Interpolates a grid of points to obtain a nominal surface.</summary>
internal static class GridSurface
{
    private const int Degree = 3;

    /// <summary>Returns the bicubic through every point, with a lower degree in a direction with fewer than four points: a tensor product
    /// for a rectangular grid, a skin of the curves along u for a ragged one. u runs from 0 to 1 along the curves, v from 0 to 1 across
    /// them, in proportion to the mean chords. The curvature is continuous, as far as the points allow.</summary>
    /// <param name="grid">At least two curves of at least two points each; neighbors differ. The points may form any smooth surface, not
    /// only a height over x and y.</param>
    /// <exception cref="GeometryException">The points do not determine a surface.</exception>
    public static SplineSurface Interpolate(PointGrid grid)
    {
        ArgumentNullException.ThrowIfNull(grid);
        return Interpolate(FitGrid.Of(grid));
    }

    internal static SplineSurface Interpolate(FitGrid grid) => grid.IsRectangular
        ? SplineSurfaceFit.Interpolate(grid.ByV(), grid.Us, grid.Vs, Degree, Degree)
        : SplineSurfaceFit.Skin([.. grid.Curves.Select((c, j) => SplineCurveFit.Interpolate(c, grid.CurveUs[j], Degree))], grid.Vs, Degree);
}
