namespace ErrorMatching.Mating;

/// <summary>The direction in which a deviation is compensated.</summary>
public enum CompensationDirection
{
    /// <summary>The component along the boundary's normal, the only one that a probe can measure.</summary>
    Normal,

    /// <summary>The full difference vector of the points.</summary>
    Vector,
}
