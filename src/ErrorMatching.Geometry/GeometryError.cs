namespace ErrorMatching.Geometry;

/// <summary>Why a geometric question has no usable answer.</summary>
public enum GeometryError
{
    /// <summary>Fewer points than the element has unknowns.</summary>
    TooFewPoints,

    /// <summary>Points that must differ lie on one another.</summary>
    CoincidentPoints,

    /// <summary>Points that must not lie on one line do.</summary>
    CollinearPoints,

    /// <summary>Two lines that must meet are parallel or nearly so.</summary>
    NearParallel,

    /// <summary>The design of a fit cannot tell its unknowns apart.</summary>
    RankDeficient,

    /// <summary>An iteration did not reach its tolerance.</summary>
    NotConverged,

    /// <summary>A coordinate is NaN or infinite.</summary>
    NotFinite,

    /// <summary>A curve turns back over its chord, so that it is no function of the place along the chord.</summary>
    FoldedCurve,

    /// <summary>Points that must lie around a center leave half a turn or more open.</summary>
    NotAround,

    /// <summary>A degree or knots that no B-spline can have.</summary>
    BadKnots,

    /// <summary>Poles or weights that do not fit the knots, or weights that are not positive.</summary>
    BadPoles,

    /// <summary>Curves that should meet in a mesh pass each other too far apart.</summary>
    OpenMesh,
}
