using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Through curve mesh: the Gordon surface through the fitted curves of both directions, reduced to the smallest net of poles that
/// keeps it within the curves' tolerance on average. The Gordon sum itself has the knots of three surfaces: more poles than points, and
/// the noise of each.</summary>
/// <param name="AlongU">Degree and poles of the curves along u.</param>
/// <param name="AlongV">Degree and poles of the curves along v.</param>
/// <param name="ToleranceMm">Largest mean distance in millimeters between the Gordon surface and the reduced one.</param>
internal sealed record CurveMeshFit(CurveFamily AlongU, CurveFamily AlongV, double ToleranceMm)
{
    /// <summary>Number of nets between that of the curves and one pole per point.</summary>
    private const int Nets = 4;

    /// <summary>Selects curves within the tolerance.</summary>
    public static CurveMeshFit Choose(FitGrid grid, double toleranceMm)
    {
        var alongU = CurveFamily.Choose(grid.Curves, grid.CurveUs, toleranceMm);
        var across = Across(grid, alongU.Fit(grid.Curves, grid.CurveUs));
        return new(alongU, CurveFamily.Choose(across, VsOf(across, grid), toleranceMm), toleranceMm);
    }

    public SplineSurface Fit(FitGrid grid)
    {
        var alongU = AlongU.Fit(grid.Curves, grid.CurveUs);
        var across = Across(grid, alongU);
        var alongV = AlongV.Fit(across, VsOf(across, grid));
        // Both families fit the same points. They miss each other at the crossings only by the residuals of the fits.
        return Compact(SplineSurfaceFit.Gordon(alongU, grid.Vs, alongV, grid.Us, double.PositiveInfinity), grid.Us, grid.Vs);
    }

    /// <summary>The points of each curve along v. In a ragged grid, they are taken from the curves along u.</summary>
    private static Point3[][] Across(FitGrid grid, SplineCurve[] alongU) =>
        [
            .. grid.Us.Select(
                (u, i) => grid.IsRectangular ? Array.ConvertAll(grid.Curves, c => c[i]) : Array.ConvertAll(alongU, c => c.PointAt(u)))];

    private static double[][] VsOf(Point3[][] across, FitGrid grid) => Array.ConvertAll(across, _ => grid.Vs);

    private SplineSurface Compact(SplineSurface mesh, double[] us, double[] vs)
    {
        var (sampleUs, sampleVs) = (Halved(us), Halved(vs));
        var samples = mesh.PointsAt(sampleUs, sampleVs);
        for (var net = 0; ; net++)
        {
            var compact = SplineSurfaceFit.LeastSquares(samples, sampleUs, sampleVs, Knots(AlongU, us, net), Knots(AlongV, vs, net));
            if (net == Nets || MeanDistance(compact.PointsAt(sampleUs, sampleVs), samples) <= ToleranceMm)
            {
                return compact;
            }
        }
    }

    private static KnotVector Knots(CurveFamily family, double[] parameters, int net)
    {
        var own = Math.Min(family.Poles, parameters.Length);
        var poles = own + ((parameters.Length - own) * net / Nets);
        return new CurveFamily(net == 0 ? family.Degree : Math.Min(3, poles - 1), poles).KnotsOf(parameters);
    }

    private static double MeanDistance(Point3[] a, Point3[] b) => a.Zip(b, (p, q) => (p - q).Length).Average();

    /// <summary>The parameters and their midpoints.</summary>
    private static double[] Halved(double[] parameters) =>
        [.. Enumerable.Range(0, (2 * parameters.Length) - 1).Select(k => (parameters[k / 2] + parameters[(k + 1) / 2]) / 2)];
}
