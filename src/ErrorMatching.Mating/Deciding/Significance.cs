using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>Tells deviations from the noise of the gauge, with one threshold for all points of a job.</summary>
/// <remarks>
/// <para>A point alarms if its deviation is outside the acceptance limits and exceeds k times its standard uncertainty u. On a perfect
/// part it does so with the probability P(k), by the normal distribution. k is the smallest factor for which the points of the whole job
/// stay silent together with at least 95 %: the product of 1 - P(k) over all of them (Sidak 1967). A point whose limits alone keep it
/// silent costs nothing, so k is 0 if all limits are wide beside u. For N points with limits narrower than k u,
/// k = z((1 + 0.95^(1/N)) / 2): 2.24 for 2 points, 2.68 for 7, 2.95 for 16.</para>
/// <para>Errors that points have in common (temperature, clamping) make fewer alarms, not more: the product is a lower bound for any
/// correlation of normal errors if the limits are symmetric. For others, the alarms of a job stay below -ln 0.95 = 5.13 % (the sum of
/// P(k)). A sum of squares over a feature would need the independent share of u: with 10 points that share their whole error, 18 % of the
/// perfect parts exceed its 5 % limit. So there is none.</para>
/// <para>Against a single deviating point at an unknown place, no test of this size has a noticeably higher power (Neyman and Pearson's
/// for 3.5 u: 0.73 instead of 0.72 for 16 points).</para>
/// </remarks>
internal static class Significance
{
    /// <summary>Largest probability that a job is compensated although its part is perfect.</summary>
    public const double FalseAlarms = 0.05;

    // Beyond 9 u lie 2e-19 of all values: a threshold for any number of points.
    private const double MostFactor = 9;
    private const double Precision = 1e-9;

    /// <summary>The factor k.</summary>
    /// <param name="features">The acceptance limits of each feature and the number of its points.</param>
    /// <param name="standardUncertaintyMm">Standard uncertainty u of a deviation.</param>
    public static double Factor(IReadOnlyList<(ToleranceBand Acceptance, int Points)> features, double standardUncertaintyMm)
    {
        if (standardUncertaintyMm == 0 || IsSilent(features, standardUncertaintyMm, 0))
        {
            return 0;
        }

        var (loud, silent) = (0.0, MostFactor);
        while (silent - loud > Precision)
        {
            var middle = (loud + silent) / 2;
            (loud, silent) = IsSilent(features, standardUncertaintyMm, middle) ? (loud, middle) : (middle, silent);
        }

        return silent;
    }

    private static bool IsSilent(IReadOnlyList<(ToleranceBand Acceptance, int Points)> features, double u, double factor) =>
        features.Sum(f => f.Points * Elementary.Log(1 - Alarm(f.Acceptance.LowerMm / u, f.Acceptance.UpperMm / u, factor)))
            >= Elementary.Log(1 - FalseAlarms);

    // The probability of a standard normal value outside the limits and beyond the factor on either side.
    private static double Alarm(double lower, double upper, double factor) =>
        Beyond(factor, lower, upper) + Beyond(factor, -upper, -lower);

    // The part of it above the factor.
    private static double Beyond(double factor, double lower, double upper)
    {
        var beyond = NormalDistribution.Below(-factor);
        var from = Math.Max(lower, factor);
        return upper <= from ? beyond : beyond - NormalDistribution.Below(-from) + NormalDistribution.Below(-upper);
    }
}
