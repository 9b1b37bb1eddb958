namespace ErrorMatching.Nc;

/// <summary>How an unnamed motion follows the named ones.</summary>
public enum NeighborRole
{
    /// <summary>Its end moved along its own line or circle.</summary>
    Slides,

    /// <summary>Its end moved by the displacement of the adjacent element.</summary>
    Follows,

    /// <summary>A fillet between two displaced lines, still tangent to both.</summary>
    Fillet,

    /// <summary>Positioning to or from the new place.</summary>
    Positioning,
}
