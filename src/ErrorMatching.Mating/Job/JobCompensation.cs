namespace ErrorMatching.Mating;

/// <summary>What is made of the deviations.</summary>
/// <param name="From">What is compensated.</param>
/// <param name="Gain">How much of a deviation is compensated, more than 0 and at most 2.</param>
/// <param name="Amount">The whole deviation, or what exceeds its tolerance.</param>
/// <param name="Along">Along the normal, or along the literal difference of the points.</param>
/// <param name="LimitMm">A larger deviation is not plausible and stops the job.</param>
public sealed record JobCompensation(
    CompensationSource From, double Gain, CompensationAmount Amount, CompensationDirection Along, double LimitMm)
{
    /// <summary>Feed-forward of the whole deviation along the normal, plausible up to 1 mm.</summary>
    public static JobCompensation Default { get; } = new(
        CompensationSource.Part, 1, CompensationAmount.Whole, CompensationDirection.Normal, 1);
}
