using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Curves side by side, all of the lowest degree, and then of the fewest poles, whose mean distance from the points is under a tolerance on every curve (Lee 2019, section 2.3).</summary>
internal static class CurveFamily
{
    private const int HighestDegree = 3;

    /// <summary>The curves.</summary>
    /// <param name="points">The points of each curve, at least two.</param>
    /// <param name="parameters">Rising parameters of the points of each curve, all over the same range.</param>
    /// <param name="toleranceMm">Largest mean distance in millimetres.</param>
    /// <returns>Curves of one degree; where all have the same parameters, over the same knots.</returns>
    public static SplineCurve[] Fit(Point3[][] points, double[][] parameters, double toleranceMm)
    {
        var most = points.Max(p => p.Length);
        for (var degree = 1; degree <= Math.Min(HighestDegree, most - 1); degree++)
        {
            var curves = With(points, parameters, degree, degree + 1);
            if (IsNear(curves, points, parameters, toleranceMm))
            {
                return curves;
            }
        }

        // Cubics with more pieces. With one pole a point they go through all points.
        var (tooFew, enough) = (Math.Min(HighestDegree + 1, most - 1), most);
        var best = With(points, parameters, HighestDegree, most);
        while (enough - tooFew > 1)
        {
            var middle = (tooFew + enough) / 2;
            var curves = With(points, parameters, HighestDegree, middle);
            if (IsNear(curves, points, parameters, toleranceMm))
            {
                (enough, best) = (middle, curves);
            }
            else
            {
                tooFew = middle;
            }
        }

        return best;
    }

    private static SplineCurve[] With(Point3[][] points, double[][] parameters, int degree, int poles)
    {
        var curves = new SplineCurve[points.Length];
        for (var j = 0; j < curves.Length; j++)
        {
            var own = Math.Min(poles, points[j].Length);
            curves[j] = SplineCurveFit.LeastSquares(points[j], parameters[j], FittingKnots.ForLeastSquares(Math.Min(degree, own - 1), parameters[j], own));
        }

        return curves;
    }

    private static bool IsNear(SplineCurve[] curves, Point3[][] points, double[][] parameters, double toleranceMm)
    {
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

    /// <summary>Distance from the curve to first order: what is left across its direction at the point's parameter.</summary>
    private static double Distance(SplineCurve curve, double t, Point3 point)
    {
        Span<Vector3> d = stackalloc Vector3[2];
        curve.Derivatives(t, d);
        var rest = point - new Point3(d[0].X, d[0].Y, d[0].Z);
        var square = d[1].Dot(d[1]);
        return square > 0 ? (rest - (d[1] * (rest.Dot(d[1]) / square))).Length : rest.Length;
    }
}
