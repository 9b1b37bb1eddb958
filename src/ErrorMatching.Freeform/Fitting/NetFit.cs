using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Fit surface: least squares on the fixed net of poles of one bicubic patch.</summary>
internal static class NetFit
{
    private const int Poles = 4;

    public static SplineSurface Fit(FitGrid grid)
    {
        // The shortest curve of a ragged grid limits the poles.
        var (knotsU, knotsV) = (Knots(grid.Curves.Min(c => c.Length)), Knots(grid.Vs.Length));
        if (grid.IsRectangular)
        {
            return SplineSurfaceFit.LeastSquares(grid.ByV(), grid.Us, grid.Vs, knotsU, knotsV);
        }

        var (points, us, vs) = grid.Scattered();
        return SplineSurfaceFit.LeastSquaresScattered(points, us, vs, knotsU, knotsV);
    }

    private static KnotVector Knots(int points) => KnotVector.Clamped(Math.Min(Poles, points) - 1, [0, 1]);
}
