namespace ErrorMatching.Mating;

/// <summary>What is done about a feature as a whole.</summary>
public enum Decision
{
    /// <summary>Every point lies within the tolerance: nothing is compensated.</summary>
    WithinTolerance,

    /// <summary>A point lies outside the tolerance, but no deviation is larger than its uncertainty:
    /// it is reported, not compensated.</summary>
    NotSignificant,

    /// <summary>The counterpart follows.</summary>
    Compensated,
}
