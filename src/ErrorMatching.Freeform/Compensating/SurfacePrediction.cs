namespace ErrorMatching.Freeform;

/// <summary>What the finished surface is expected to show when it is measured like the one before, if nothing but the compensation changes.</summary>
/// <remarks>
/// At each measured point the compensation takes its part off the systematic error. Two things come on top, independent of each other and of what is left, and are added to the spread by root sum of squares: what the field does
/// not explain (cutting and probing do not repeat) comes again, drawn anew; and the field is itself off by its uncertainty, which was cut into the surface. The residuals of a fit tell less than the first, because it follows
/// part of the noise: they count by the degrees of freedom that it left, where it knows them. A fit that goes through every point has no residuals at all; its uncertainty is then all there is:
/// the error of left-out lines is no measure of its noise, for it is that of a grid half as dense. Where errors of short waves were measured without noise it was 0.3 to 1 um, and nothing was left at the points.
/// Where a surface was fitted to the compensation points, its own distance from the nominal one is what the compensation takes off: at the points, with the noise that it follows, and between them, where it may go its own way.
/// </remarks>
/// <param name="Method">Name of the compensation: <c>mirror</c> or <c>tool-radius</c>.</param>
/// <param name="Errors">Expected systematic error at each measured point, in the order of the samples, in millimetres.</param>
/// <param name="Statistics">What they come to, with the scatter.</param>
/// <param name="MeanUncertaintyMm">Standard uncertainty of the expected mean.</param>
/// <param name="PointUncertaintyMm">Root mean square of the standard uncertainty of the expected error at a point, the scatter included.</param>
public sealed record SurfacePrediction(string Method, IReadOnlyList<double> Errors, DeviationStatistics Statistics, double MeanUncertaintyMm, double PointUncertaintyMm)
{
    // A normal quantile: of n points the largest is expected about here. Blom, "Statistical Estimates and Transformed Beta-Variables", 1958.
    private const double BlomShift = 0.375;

    /// <summary>Predicts what is left of a field where another one is compensated.</summary>
    /// <param name="method">Name of the compensation.</param>
    /// <param name="samples">The measured errors.</param>
    /// <param name="systematic">What is systematic in them.</param>
    /// <param name="compensation">What is compensated, before the gain.</param>
    /// <param name="gain">Share that is compensated.</param>
    internal static SurfacePrediction Of(string method, IReadOnlyList<ErrorSample> samples, ErrorField systematic, ErrorField compensation, double gain) =>
        Of(method, samples, systematic, [.. samples.Select(s => systematic.At(s.U, s.V) - (gain * compensation.At(s.U, s.V)))], []);

    /// <summary>Predicts what is left.</summary>
    /// <param name="method">Name of the compensation.</param>
    /// <param name="samples">The measured errors.</param>
    /// <param name="systematic">What is systematic in them.</param>
    /// <param name="left">What is left of it at each of them.</param>
    /// <param name="between">What is left of it at places between them, where that does not follow from the points: who measures elsewhere finds it, so the larger of both is expected.</param>
    internal static SurfacePrediction Of(string method, IReadOnlyList<ErrorSample> samples, ErrorField systematic, double[] left, double[] between)
    {
        var noise = systematic is FittedField { ResidualStandardDeviationMm: >= 0 } fitted ? fitted.ResidualStandardDeviationMm : Math.Sqrt(samples.Sum(s => Square(s.ErrorMm - systematic.At(s.U, s.V))) / Math.Max(1, samples.Count - 1));
        var field = Math.Sqrt(samples.Sum(s => Square(systematic.StandardUncertaintyAt(s.U, s.V))) / samples.Count);
        var spread = Hypot(noise, field);
        var statistics = DeviationStatistics.Of(left);
        var everywhere = between.Length == 0 ? statistics : DeviationStatistics.Of(between);
        return new(
            method,
            left,
            statistics with
            {
                StandardDeviationMm = Hypot(Math.Max(statistics.StandardDeviationMm, everywhere.StandardDeviationMm), spread),
                // The largest on either side is the largest of twice as many on one.
                ProfileIsoMm = 2 * Hypot(Math.Max(statistics.ProfileIsoMm, everywhere.ProfileIsoMm) / 2, spread * Outermost(2 * samples.Count)),
                ProfileRangeMm = Hypot(Math.Max(statistics.ProfileRangeMm, everywhere.ProfileRangeMm), 2 * spread * Outermost(samples.Count)),
            },
            Hypot(field, noise / Math.Sqrt(samples.Count)),
            spread);
    }

    private static double Outermost(int count) => NormalQuantile((count - BlomShift) / (count + 1 - (2 * BlomShift)));

    private static double Hypot(double a, double b) => Math.Sqrt((a * a) + (b * b));

    private static double Square(double x) => x * x;

    // Beasley and Springer with Moro's tails are not needed here: a rational approximation of the middle (Abramowitz and Stegun, 26.2.23, error below 4.5e-4) is far finer than what is predicted.
    private static double NormalQuantile(double p)
    {
        var t = Math.Sqrt(-2 * Math.Log(1 - p));
        return Math.Max(0, t - ((2.515517 + (0.802853 * t) + (0.010328 * t * t)) / (1 + (1.432788 * t) + (0.189269 * t * t) + (0.001308 * t * t * t))));
    }
}
