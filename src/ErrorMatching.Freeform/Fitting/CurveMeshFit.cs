using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>
/// Through curve mesh: the Gordon surface through the fitted curves of both directions, then on the smallest net of poles that keeps it within the curves' tolerance on average. The Gordon sum itself carries
/// the knots of three surfaces, more poles than there are points, and with them the noise of each.
/// </summary>
/// <param name="AlongU">What the curves along u need.</param>
/// <param name="AlongV">What the curves along v need.</param>
/// <param name="ToleranceMm">Largest mean distance in millimetres between the Gordon surface and the one on the smaller net.</param>
internal sealed record CurveMeshFit(CurveFamily AlongU, CurveFamily AlongV, double ToleranceMm)
{
    /// <summary>Nets between that of the curves and one pole a point.</summary>
    private const int Nets = 4;

    /// <summary>The curves that keep the tolerance.</summary>
    public static CurveMeshFit Choose(FitGrid grid, double toleranceMm)
    {
        var alongU = CurveFamily.Choose(grid.Curves, grid.CurveUs, toleranceMm);
        var across = Across(grid, alongU.Fit(grid.Curves, grid.CurveUs));
        return new(alongU, CurveFamily.Choose(across, VsOf(across, grid), toleranceMm), toleranceMm);
    }

    /// <summary>The surface.</summary>
    public SplineSurface Fit(FitGrid grid)
    {
        var alongU = AlongU.Fit(grid.Curves, grid.CurveUs);
        var across = Across(grid, alongU);
        var alongV = AlongV.Fit(across, VsOf(across, grid));
        // Both families are fits of the same points: where they should meet, they pass within what the fits leave.
        return Compact(SplineSurfaceFit.Gordon(alongU, grid.Vs, alongV, grid.Us, double.PositiveInfinity), grid.Us, grid.Vs);
    }

    /// <summary>The points of each curve along v. Across a ragged grid no points face each other: the curves along u do.</summary>
    private static Point3[][] Across(FitGrid grid, SplineCurve[] alongU) =>
        [.. grid.Us.Select((u, i) => grid.IsRectangular ? Array.ConvertAll(grid.Curves, c => c[i]) : Array.ConvertAll(alongU, c => c.PointAt(u)))];

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

    /// <summary>The parameters and the middles between them.</summary>
    private static double[] Halved(double[] parameters) =>
        [.. Enumerable.Range(0, (2 * parameters.Length) - 1).Select(k => (parameters[k / 2] + parameters[(k + 1) / 2]) / 2)];
}
