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

/// <summary>The source of the compensation.</summary>
public enum CompensationSource
{
    /// <summary>Feed-forward: the nominal program is displaced by gain * (actual - theoretical) of the part.</summary>
    Part,

    /// <summary>Feedback: the program that cut the measured counterpart is displaced by gain * (part - counterpart).</summary>
    Counterpart,
}

/// <summary>How much of a deviation outside its tolerance is compensated.</summary>
public enum CompensationAmount
{
    /// <summary>All of it.</summary>
    Whole,

    /// <summary>At each point, the part beyond the limit.</summary>
    Excess,
}

/// <summary>The direction in which a deviation is compensated.</summary>
public enum CompensationDirection
{
    /// <summary>The component along the boundary's normal, the only one that a probe can measure.</summary>
    Normal,

    /// <summary>The full difference vector of the points.</summary>
    Vector,
}
