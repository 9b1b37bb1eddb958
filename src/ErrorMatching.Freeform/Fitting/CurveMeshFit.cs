using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>
/// Through curve mesh: the Gordon surface through the fitted curves of both directions, then on the smallest net of poles that keeps it within the curves' tolerance on average. The Gordon sum itself carries
/// the knots of three surfaces, more poles than there are points, and with them the noise of each.
/// </summary>
internal static class CurveMeshFit
{
    /// <summary>Nets between that of the curves and one pole a point.</summary>
    private const int Nets = 4;

    public static SplineSurface Fit(FitGrid grid, double toleranceMm)
    {
        var alongU = CurveFamily.Fit(grid.Curves, grid.CurveUs, toleranceMm);
        var us = grid.Us;
        // Across a ragged grid no points face each other: the curves along u do.
        Point3[][] across = [.. us.Select((u, i) => grid.IsRectangular ? grid.Curves.Select(c => c[i]).ToArray() : alongU.Select(c => c.PointAt(u)).ToArray())];
        var alongV = CurveFamily.Fit(across, [.. us.Select(_ => grid.Vs)], toleranceMm);
        // Both families are fits of the same points: where they should meet, they pass within what the fits leave.
        var mesh = SplineSurfaceFit.Gordon(alongU, grid.Vs, alongV, us, double.PositiveInfinity);
        return Compact(mesh, us, grid.Vs, Least(alongU), Least(alongV), toleranceMm);
    }

    /// <summary>The degree and poles that the curves of a family need.</summary>
    private static (int Degree, int Poles) Least(SplineCurve[] family) => (family.Max(c => c.Knots.Degree), family.Max(c => c.Knots.PoleCount));

    private static SplineSurface Compact(SplineSurface mesh, double[] us, double[] vs, (int Degree, int Poles) leastU, (int Degree, int Poles) leastV, double toleranceMm)
    {
        var (sampleUs, sampleVs) = (Halved(us), Halved(vs));
        var samples = mesh.PointsAt(sampleUs, sampleVs);
        SplineSurface? compact = null;
        for (var net = 0; net <= Nets; net++)
        {
            compact = SplineSurfaceFit.LeastSquares(samples, sampleUs, sampleVs, Knots(leastU, us, net), Knots(leastV, vs, net));
            if (MeanDistance(compact.PointsAt(sampleUs, sampleVs), samples) <= toleranceMm)
            {
                break;
            }
        }

        return compact!;
    }

    private static KnotVector Knots((int Degree, int Poles) least, double[] parameters, int net)
    {
        var poles = least.Poles + ((parameters.Length - least.Poles) * net / Nets);
        return FittingKnots.ForLeastSquares(net == 0 ? least.Degree : Math.Min(3, poles - 1), parameters, poles);
    }

    private static double MeanDistance(Point3[] a, Point3[] b) => a.Zip(b, (p, q) => (p - q).Length).Average();

    /// <summary>The parameters and the middles between them.</summary>
    private static double[] Halved(double[] parameters) =>
        [.. Enumerable.Range(0, (2 * parameters.Length) - 1).Select(k => (parameters[k / 2] + parameters[(k + 1) / 2]) / 2)];
}
