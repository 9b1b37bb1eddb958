namespace ErrorMatching.Geometry;

/// <summary>Probabilities of conformance: how likely a true value is within its limits, given a measured value and its standard
/// uncertainty (JCGM 106:2012, section 7).</summary>
/// <remarks>The true value is normally distributed about the measured one; nothing is known about it in advance. The same formula serves
/// before and after a compensation: before with the measured deviation and the limits of the part, after with what is left over, its
/// own uncertainty and <see cref="ToleranceBand.Opposite()"/>.</remarks>
public static class Conformance
{
    /// <summary>The probability that the true value is within the limits.</summary>
    /// <param name="limits">The limits.</param>
    /// <param name="measuredMm">The measured value.</param>
    /// <param name="standardUncertaintyMm">Its standard uncertainty, zero or more.</param>
    /// <returns>From 0 to 1; null for limits without width, which ask for a correction and not for conformance.</returns>
    /// <exception cref="ArgumentOutOfRangeException">The uncertainty is negative or not a number.</exception>
    public static double? Probability(ToleranceBand limits, double measuredMm, double standardUncertaintyMm)
    {
        if (!(standardUncertaintyMm >= 0))
        {
            throw new ArgumentOutOfRangeException(
                nameof(standardUncertaintyMm), standardUncertaintyMm, "A standard uncertainty is zero or more.");
        }

        if (limits.WidthMm == 0)
        {
            return null;
        }

        if (standardUncertaintyMm == 0)
        {
            return limits.Contains(measuredMm) ? 1 : 0;
        }

        var (lower, upper) = ((limits.LowerMm - measuredMm) / standardUncertaintyMm, (limits.UpperMm - measuredMm) / standardUncertaintyMm);

        // Both limits on one side: subtract the small tails, not numbers close to 1.
        return lower > 0
            ? NormalDistribution.Below(-lower) - NormalDistribution.Below(-upper)
            : NormalDistribution.Below(upper) - NormalDistribution.Below(lower);
    }

    /// <summary>The probability that all of several values are within their limits if their errors are independent: the product.</summary>
    /// <param name="probabilities">Their probabilities; null for a value without limits.</param>
    /// <returns>The product; null if no value has limits.</returns>
    public static double? OfIndependent(IEnumerable<double?> probabilities)
    {
        ArgumentNullException.ThrowIfNull(probabilities);
        return probabilities.Aggregate((double?)null, (all, one) => one is null ? all : (all ?? 1) * one);
    }
}
