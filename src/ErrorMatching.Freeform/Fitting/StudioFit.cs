using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Studio surface: a bicubic smoothed by the bending energy of a thin plate, with one pole per point up to a limit.</summary>
internal static class StudioFit
{
    /// <summary>Maximum number of poles along a direction. Smoothing leaves no finer detail, and time grows with the 4th power.</summary>
    private const int MostPoles = 20;

    /// <summary>The smoothed surface.</summary>
    /// <param name="grid">The points.</param>
    /// <param name="weight">Weight of the energy in mm^2; null for the one that predicts left-out points best.</param>
    public static SmoothedSurface Fit(FitGrid grid, double? weight)
    {
        var (points, us, vs) = grid.Scattered();
        // The shortest curve of a ragged grid limits the poles. Otherwise the energy alone would determine some of them.
        return SplineSurfaceFit.Smooth(
            points,
            us,
            vs,
            Knots(grid.Us, grid.Curves.Min(c => c.Length)),
            Knots(grid.Vs, grid.Vs.Length),
            grid.LengthU,
            grid.LengthV,
            weight);
    }

    // The energy determines poles that the points do not, so a cubic works for two points too.
    private static KnotVector Knots(double[] parameters, int poles) => poles < 4
        ? KnotVector.Clamped(3, [0, 1])
        : FittingKnots.ForLeastSquares(3, parameters, Math.Min(poles, MostPoles));
}
