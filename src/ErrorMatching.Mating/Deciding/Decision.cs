namespace ErrorMatching.Mating;

/// <summary>The decision on a whole feature.</summary>
public enum Decision
{
    /// <summary>Every point is within the tolerance; nothing is compensated.</summary>
    WithinTolerance,

    /// <summary>A point is outside the tolerance, but no deviation exceeds its uncertainty: reported, not compensated.</summary>
    NotSignificant,

    /// <summary>The counterpart's boundary is displaced.</summary>
    Compensated,
}
