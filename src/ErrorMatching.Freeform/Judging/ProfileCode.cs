namespace ErrorMatching.Freeform;

/// <summary>How a surface is judged by its profile tolerance, in one word.</summary>
public enum ProfileCode
{
    /// <summary>In tolerance.</summary>
    Within,

    /// <summary>No point is outside the zone, but the decision rule does not accept the surface: a measured point is inside a guard band,
    /// or a predicted surface is not probable enough.</summary>
    NotAccepted,

    /// <summary>The predicted points are in the zone, but a place between them is expected to be outside.</summary>
    OutsideBetween,

    /// <summary>A point is outside the zone.</summary>
    Outside,
}
