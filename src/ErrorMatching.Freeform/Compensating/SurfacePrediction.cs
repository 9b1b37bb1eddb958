using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>The expected measurement of the finished surface, if nothing changes except the compensation.</summary>
/// <remarks>The compensation removes its share of the systematic error at each point. Two independent contributions are added to the spread
/// by root sum of squares: new random scatter, since cutting and probing do not repeat, and the uncertainty of the field, which was cut
/// into the surface. The residuals of a fit understate the scatter because the fit follows part of the noise. If the fit knows its degrees
/// of freedom, the residuals are scaled by them. A fit through every point has no residuals, so only its uncertainty is used. The error of
/// left-out lines does not measure its noise: it is the error of a grid half as dense. With short-wave errors measured without noise, it
/// was 0.3 to 1 um, while nothing remained at the points. If a surface was fitted to the compensation points, its own distance from the
/// nominal surface is the compensation. At the points, it includes the noise that it follows; between them, it may deviate.</remarks>
/// <param name="Method">Name of the compensation: <c>mirror</c> or <c>tool-radius</c>.</param>
/// <param name="Errors">Expected systematic error at each measured point, in the order of the samples, in millimeters.</param>
/// <param name="Statistics">Their statistics, including the scatter.</param>
/// <param name="MeanUncertaintyMm">Standard uncertainty of the expected mean.</param>
/// <param name="PointUncertaintyMm">Root mean square standard uncertainty of the expected error at a point, with the scatter.</param>
public sealed record SurfacePrediction(
    string Method, IReadOnlyList<double> Errors, DeviationStatistics Statistics, double MeanUncertaintyMm, double PointUncertaintyMm)
{
    // Shift of the normal quantile expected of the largest of n points. Blom, "Statistical Estimates and Transformed Beta-Variables", 1958.
    private const double BlomShift = 0.375;

    /// <summary>Predicts the remaining error.</summary>
    /// <param name="method">Name of the compensation.</param>
    /// <param name="scatter">What is uncertain about the points, whatever is compensated.</param>
    /// <param name="left">The remaining systematic error at each sample.</param>
    /// <param name="between">The remaining systematic error between the samples, if it does not follow from them. A measurement elsewhere
    /// would find it, so the larger of the two is expected.</param>
    internal static SurfacePrediction Of(string method, PointScatter scatter, double[] left, double[] between)
    {
        var (noise, field) = (scatter.NoiseMm, scatter.FieldMm);
        var spread = Hypot(noise, field);
        var statistics = DeviationStatistics.Of(left);
        var everywhere = between.Length == 0 ? statistics : DeviationStatistics.Of(between);
        return new(
            method,
            left,
            statistics with
            {
                StandardDeviationMm = Hypot(Math.Max(statistics.StandardDeviationMm, everywhere.StandardDeviationMm), spread),
                // The largest absolute value of n points is the largest of 2n one-sided values.
                ProfileIsoMm = 2 * Hypot(
                    Math.Max(statistics.ProfileIsoMm, everywhere.ProfileIsoMm) / 2, spread * Outermost(2 * left.Length)),
                ProfileRangeMm = Hypot(
                    Math.Max(statistics.ProfileRangeMm, everywhere.ProfileRangeMm), 2 * spread * Outermost(left.Length)),
            },
            Hypot(field, noise / Math.Sqrt(left.Length)),
            spread);
    }

    private static double Outermost(int count) => NormalQuantile((count - BlomShift) / (count + 1 - (2 * BlomShift)));

    private static double Hypot(double a, double b) => Math.Sqrt((a * a) + (b * b));

    // This approximation (Abramowitz and Stegun, 26.2.23, error below 4.5e-4) is far finer than the prediction, so this suffices.
    private static double NormalQuantile(double p)
    {
        var t = Math.Sqrt(-2 * Elementary.Log(1 - p));
        return Math.Max(
            0, t - ((2.515517 + (0.802853 * t) + (0.010328 * t * t)) / (1 + (1.432788 * t) + (0.189269 * t * t) + (0.001308 * t * t * t))));
    }
}
