namespace ErrorMatching.Mating;

/// <summary>Along what a deviation is compensated.</summary>
public enum CompensationDirection
{
    /// <summary>Its component along the normal of the boundary, the only one that a probe can know.</summary>
    Normal,

    /// <summary>The literal difference of the points.</summary>
    Vector,
}
