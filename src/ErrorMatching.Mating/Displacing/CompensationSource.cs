namespace ErrorMatching.Mating;

/// <summary>The source of the compensation.</summary>
public enum CompensationSource
{
    /// <summary>Feed-forward: the nominal program is displaced by gain * (actual - theoretical) of the part.</summary>
    Part,

    /// <summary>Feedback: the program that cut the measured counterpart is displaced by gain * (part - counterpart).</summary>
    Counterpart,
}
