using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>A surface through every point of a grid: how a grid of points becomes a nominal surface.</summary>
public static class GridSurface
{
    private const int Degree = 3;

    /// <summary>
    /// The bicubic through every point, of a lower degree where a direction has fewer than four: a tensor product for a rectangular grid, the skin of the curves along u for a ragged one.
    /// u runs from 0 to 1 along the curves, v from 0 to 1 across them, in proportion to the mean chords; curvature is continuous, as far as the points say.
    /// </summary>
    /// <param name="grid">At least two curves of at least two points each; neighbors differ. The points may form any smooth surface, not only a height over x and y.</param>
    /// <exception cref="GeometryException">The points determine no surface.</exception>
    public static SplineSurface Interpolate(PointGrid grid)
    {
        ArgumentNullException.ThrowIfNull(grid);
        return Interpolate(FitGrid.Of(grid));
    }

    internal static SplineSurface Interpolate(FitGrid grid) => grid.IsRectangular
        ? SplineSurfaceFit.Interpolate(grid.ByV(), grid.Us, grid.Vs, Degree, Degree)
        : SplineSurfaceFit.Skin([.. grid.Curves.Select((c, j) => SplineCurveFit.Interpolate(c, grid.CurveUs[j], Degree))], grid.Vs, Degree);
}
