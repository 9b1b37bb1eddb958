namespace ErrorMatching.Geometry;

/// <summary>How two elements meet.</summary>
public enum IntersectionKind
{
    /// <summary>They do not meet.</summary>
    None,

    /// <summary>They cross in the given one or two points.</summary>
    Crossing,

    /// <summary>They touch in the given point with a common tangent; two arcs of one circle may do so at both of their ends.</summary>
    Tangent,

    /// <summary>They are parallel lines or concentric circles and never meet.</summary>
    Parallel,

    /// <summary>They lie on one another along a stretch; the given points are the ends of that stretch, none where it is endless or closed.</summary>
    Coincident,
}
