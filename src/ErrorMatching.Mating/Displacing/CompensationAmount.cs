namespace ErrorMatching.Mating;

/// <summary>How much of a deviation outside its tolerance is compensated.</summary>
public enum CompensationAmount
{
    /// <summary>All of it.</summary>
    Whole,

    /// <summary>At each point, the part beyond the limit.</summary>
    Excess,
}
