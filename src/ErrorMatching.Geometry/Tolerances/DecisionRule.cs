namespace ErrorMatching.Geometry;

/// <summary>How measured values are accepted near their limits (JCGM 106:2012, section 8; ISO 14253-1).</summary>
/// <remarks>A guard band moves both limits inward by g = u z, where u is the standard uncertainty of the measured value and z the normal
/// quantile of 1 - risk. A value on such a limit is outside the tolerance with that risk at most, if the other limit is far away.</remarks>
public sealed record DecisionRule
{
    /// <summary>The risk of a guard band if the job states none: 5 %, the default of ISO 14253-1.</summary>
    public const double DefaultRiskPercent = 5;

    private DecisionRule(double? riskPercent) => RiskPercent = riskPercent;

    /// <summary>A value is accepted up to its limits. Near a limit, the risk is nearly 50 %.</summary>
    public static DecisionRule Simple { get; } = new((double?)null);

    /// <summary>True if limits have a guard band.</summary>
    public bool IsGuarded => RiskPercent is not null;

    /// <summary>Largest accepted probability, in percent, that a value on an acceptance limit is outside the tolerance; null without a
    /// guard band.</summary>
    public double? RiskPercent { get; }

    /// <summary>A rule with a guard band.</summary>
    /// <param name="riskPercent">The risk, from 0.01 to 50.</param>
    /// <exception cref="ArgumentOutOfRangeException">The risk is not in this range.</exception>
    public static DecisionRule GuardBand(double riskPercent) => riskPercent is >= 0.01 and <= 50
        ? new(riskPercent)
        : throw new ArgumentOutOfRangeException(nameof(riskPercent), riskPercent, "A risk is from 0.01 to 50 %.");

    /// <summary>The distance by which the limits move inward; 0 without a guard band.</summary>
    /// <param name="standardUncertaintyMm">Standard uncertainty of a measured value.</param>
    public double GuardMm(double standardUncertaintyMm) =>
        RiskPercent is { } risk ? -standardUncertaintyMm * NormalDistribution.Quantile(risk / 100) : 0;

    /// <summary>The limits up to which a measured value is accepted.</summary>
    /// <param name="limits">The limits of the tolerance. Limits without width have no guard band: nothing lies between them.</param>
    /// <param name="standardUncertaintyMm">Standard uncertainty of a measured value.</param>
    /// <returns>The acceptance limits; null if the guard bands overlap, so that no value could be accepted.</returns>
    public ToleranceBand? AcceptanceLimits(ToleranceBand limits, double standardUncertaintyMm)
    {
        var guard = limits.WidthMm == 0 ? 0 : GuardMm(standardUncertaintyMm);
        var (lower, upper) = (limits.LowerMm + guard, limits.UpperMm - guard);
        return lower <= upper ? new(lower, upper) : null;
    }
}
