namespace ErrorMatching.Freeform;

/// <summary>What the finished surface is expected to show when it is measured like the one before, if nothing but the compensation changes.</summary>
/// <remarks>
/// At each measured point the compensation takes its part off the systematic error; what the field does not explain (cutting and probing do not repeat) comes again, with the same spread. The expected error is therefore
/// the systematic error that is left, and its uncertainty is that of the field; scatter is added to the spread by root sum of squares.
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

    /// <summary>Predicts what is left.</summary>
    /// <param name="method">Name of the compensation.</param>
    /// <param name="samples">The measured errors.</param>
    /// <param name="systematic">What is systematic in them.</param>
    /// <param name="compensation">What is compensated, before the gain.</param>
    /// <param name="gain">Share that is compensated.</param>
    internal static SurfacePrediction Of(string method, IReadOnlyList<ErrorSample> samples, ErrorField systematic, ErrorField compensation, double gain)
    {
        double[] left = [.. samples.Select(s => systematic.At(s.U, s.V) - (gain * compensation.At(s.U, s.V)))];
        double[] scatter = [.. samples.Select(s => s.ErrorMm - systematic.At(s.U, s.V))];
        var spread = Math.Sqrt(scatter.Sum(r => r * r) / Math.Max(1, scatter.Length - 1));
        var field = Math.Sqrt(samples.Sum(s => Square(systematic.StandardUncertaintyAt(s.U, s.V))) / samples.Count);
        var statistics = DeviationStatistics.Of(left);
        var outermost = spread * NormalQuantile((samples.Count - BlomShift) / (samples.Count + 1 - (2 * BlomShift)));
        return new(
            method,
            left,
            statistics with
            {
                StandardDeviationMm = Hypot(statistics.StandardDeviationMm, spread),
                ProfileIsoMm = 2 * Hypot(statistics.ProfileIsoMm / 2, outermost),
                ProfileRangeMm = Hypot(statistics.ProfileRangeMm, 2 * outermost),
            },
            Hypot(field, spread / Math.Sqrt(samples.Count)),
            Hypot(field, spread));
    }

    private static double Hypot(double a, double b) => Math.Sqrt((a * a) + (b * b));

    private static double Square(double x) => x * x;

    // Beasley and Springer with Moro's tails are not needed here: a rational approximation of the middle (Abramowitz and Stegun, 26.2.23, error below 4.5e-4) is far finer than what is predicted.
    private static double NormalQuantile(double p)
    {
        var t = Math.Sqrt(-2 * Math.Log(1 - p));
        return Math.Max(0, t - ((2.515517 + (0.802853 * t) + (0.010328 * t * t)) / (1 + (1.432788 * t) + (0.189269 * t * t) + (0.001308 * t * t * t))));
    }
}
