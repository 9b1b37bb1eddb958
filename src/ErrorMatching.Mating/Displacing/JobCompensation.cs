namespace ErrorMatching.Mating;

/// <summary>How deviations are compensated.</summary>
/// <param name="From">The source of the compensation.</param>
/// <param name="Gain">Fraction of a deviation to compensate, more than 0 and at most 2.</param>
/// <param name="Amount">The whole deviation, or its excess over the tolerance.</param>
/// <param name="Along">Along the normal, or along the full difference vector of the points.</param>
/// <param name="LimitMm">A larger deviation is implausible and stops the job.</param>
public sealed record JobCompensation(
    CompensationSource From, double Gain, CompensationAmount Amount, CompensationDirection Along, double LimitMm)
{
    /// <summary>Feed-forward of the whole deviation along the normal, plausible up to 1 mm.</summary>
    public static JobCompensation Default { get; } = new(
        CompensationSource.Part, 1, CompensationAmount.Whole, CompensationDirection.Normal, 1);
}
