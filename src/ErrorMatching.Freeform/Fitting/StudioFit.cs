using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Studio surface: a bicubic smoothed by the bending energy of a thin plate, with a pole a point up to a limit.</summary>
internal static class StudioFit
{
    /// <summary>The most poles along a direction: smoothing leaves no more detail, and its time grows with the fourth power.</summary>
    private const int MostPoles = 20;

    /// <summary>The smoothed surface.</summary>
    /// <param name="grid">The points.</param>
    /// <param name="weight">Weight of the energy in mm^2; null for the one that predicts left-out points best.</param>
    public static SmoothedSurface Fit(FitGrid grid, double? weight)
    {
        var (points, us, vs) = grid.Scattered();
        // A ragged grid is as good as its shortest curve: poles that its points leave open would be the energy's alone.
        return SplineSurfaceFit.Smooth(points, us, vs, Knots(grid.Us, grid.Curves.Min(c => c.Length)), Knots(grid.Vs, grid.Vs.Length), grid.LengthU, grid.LengthV, weight);
    }

    // The energy determines poles that points alone would not, so a cubic serves for two points as well.
    private static KnotVector Knots(double[] parameters, int poles) => poles < 4
        ? KnotVector.Clamped(3, [0, 1])
        : FittingKnots.ForLeastSquares(3, parameters, Math.Min(poles, MostPoles));
}
