namespace ErrorMatching.Nc;

/// <summary>How a motion that was not named follows those that were.</summary>
public enum NeighborRole
{
    /// <summary>Its end moved along its own line or circle.</summary>
    Slides,

    /// <summary>Its end took the displacement of the element beside it.</summary>
    Follows,

    /// <summary>A fillet between two displaced lines, still tangent to both.</summary>
    Fillet,

    /// <summary>Positioning that goes to, or comes from, the new place.</summary>
    Positioning,
}
