namespace ErrorMatching.Geometry;

/// <summary>How two elements meet.</summary>
public enum IntersectionKind
{
    /// <summary>They do not intersect.</summary>
    None,

    /// <summary>They cross in one or two points.</summary>
    Crossing,

    /// <summary>They touch in one point with a common tangent; two arcs of one circle may touch at both ends.</summary>
    Tangent,

    /// <summary>They are parallel lines or concentric circles.</summary>
    Parallel,

    /// <summary>They coincide along a stretch. The points are its ends; none if it is infinite or closed.</summary>
    Coincident,
}
