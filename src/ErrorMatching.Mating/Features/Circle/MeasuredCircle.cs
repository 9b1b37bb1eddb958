using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>The circle that represents points, by the method of the job.</summary>
/// <param name="Circle">The circle.</param>
/// <param name="CenterStandardError">Standard errors of its center in x and in y, mm.</param>
/// <param name="RadiusStandardError">Standard error of its radius, mm.</param>
/// <param name="Residuals">Signed distance of each point from it, positive outside, mm.</param>
internal sealed record MeasuredCircle(
    Circle2 Circle, Vector2 CenterStandardError, double RadiusStandardError, IReadOnlyList<double> Residuals)
{
    /// <summary>Difference between the largest and smallest distance of the points from the center, mm.</summary>
    public double RoundnessMm => Residuals.Max() - Residuals.Min();

    /// <summary>Fits it.</summary>
    /// <param name="method">The method.</param>
    /// <param name="points">The points.</param>
    /// <param name="u">Standard uncertainty of a point, mm.</param>
    /// <exception cref="GeometryException">The points determine no circle.</exception>
    public static MeasuredCircle Of(CircleMethod method, IReadOnlyList<Point2> points, double u)
    {
        if (method == CircleMethod.LeastSquares)
        {
            var fit = CircleFit.Fit(points, u);
            return new(fit.Circle, fit.CenterStandardError, fit.RadiusStandardError, fit.Residuals);
        }

        var extreme = method == CircleMethod.Inscribed ? ExtremeCircle.Inscribed(points, u) : ExtremeCircle.Circumscribed(points, u);
        return new(extreme.Circle, extreme.CenterStandardError, extreme.RadiusStandardError, extreme.Residuals);
    }
}
