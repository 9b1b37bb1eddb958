using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Neighboring curves that share the lowest degree, and then the fewest poles, for which the mean distance from the points is
/// below a tolerance on every curve (Lee 2019, section 2.3).</summary>
/// <param name="Degree">Degree of the curves; lower if a curve has too few points for it.</param>
/// <param name="Poles">Poles of each curve; fewer if a curve has fewer points.</param>
internal sealed record CurveFamily(int Degree, int Poles)
{
    private const int HighestDegree = 3;

    /// <summary>Selects degree and poles.</summary>
    /// <param name="points">The points of each curve, at least two.</param>
    /// <param name="parameters">Ascending parameters of the points of each curve, all over the same range.</param>
    /// <param name="toleranceMm">Largest mean distance in millimeters.</param>
    public static CurveFamily Choose(Point3[][] points, double[][] parameters, double toleranceMm)
    {
        var most = points.Max(p => p.Length);
        for (var degree = 1; degree <= Math.Min(HighestDegree, most - 1); degree++)
        {
            var family = new CurveFamily(degree, degree + 1);
            if (family.IsNear(points, parameters, toleranceMm))
            {
                return family;
            }
        }

        // Cubics with more pieces. With one pole per point, they pass through all points.
        var (tooFew, enough) = (Math.Min(HighestDegree + 1, most - 1), most);
        while (enough - tooFew > 1)
        {
            var middle = (tooFew + enough) / 2;
            var isNear = new CurveFamily(HighestDegree, middle).IsNear(points, parameters, toleranceMm);
            (tooFew, enough) = isNear ? (tooFew, middle) : (middle, enough);
        }

        return new(Math.Min(HighestDegree, most - 1), enough);
    }

    /// <summary>Fits the curves, with common knots if all have the same parameters.</summary>
    /// <param name="points">The points of each curve, at least two.</param>
    /// <param name="parameters">Ascending parameters of the points of each curve, all over the same range.</param>
    public SplineCurve[] Fit(Point3[][] points, double[][] parameters)
    {
        if (parameters.All(p => ReferenceEquals(p, parameters[0])))
        {
            return [.. SplineCurveFit.LeastSquaresFamily(points, parameters[0], KnotsOf(parameters[0]))];
        }

        return [.. points.Select((p, j) => SplineCurveFit.LeastSquares(p, parameters[j], KnotsOf(parameters[j])))];
    }

    /// <summary>The knots for points with given parameters.</summary>
    public KnotVector KnotsOf(double[] parameters)
    {
        var poles = Math.Min(Poles, parameters.Length);
        return FittingKnots.ForLeastSquares(Math.Min(Degree, poles - 1), parameters, poles);
    }

    private bool IsNear(Point3[][] points, double[][] parameters, double toleranceMm)
    {
        var curves = Fit(points, parameters);
        for (var j = 0; j < curves.Length; j++)
        {
            var sum = 0.0;
            for (var i = 0; i < points[j].Length; i++)
            {
                sum += Distance(curves[j], parameters[j][i], points[j][i]);
            }

            if (!(sum < toleranceMm * points[j].Length))
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>First-order distance from the curve: the residual across its direction at the point's parameter.</summary>
    private static double Distance(SplineCurve curve, double t, Point3 point)
    {
        Span<Vector3> d = stackalloc Vector3[2];
        curve.Derivatives(t, d);
        var rest = point - new Point3(d[0].X, d[0].Y, d[0].Z);
        var square = d[1].Dot(d[1]);
        return square > 0 ? (rest - (d[1] * (rest.Dot(d[1]) / square))).Length : rest.Length;
    }
}
