namespace ErrorMatching.Geometry;

/// <summary>Why a geometric calculation has no usable result.</summary>
public enum GeometryError
{
    /// <summary>Fewer points than the element has unknowns.</summary>
    TooFewPoints,

    /// <summary>Points that must differ coincide.</summary>
    CoincidentPoints,

    /// <summary>Points that must not be collinear are.</summary>
    CollinearPoints,

    /// <summary>Two lines that must meet are parallel or nearly so.</summary>
    NearParallel,

    /// <summary>The data of a fit cannot distinguish its unknowns.</summary>
    RankDeficient,

    /// <summary>An iteration did not reach its tolerance.</summary>
    NotConverged,

    /// <summary>A coordinate is NaN or infinite.</summary>
    NotFinite,

    /// <summary>A curve turns back over its chord, so that it is not a function of the position along the chord.</summary>
    FoldedCurve,

    /// <summary>Points that must be around a center leave half a turn or more open.</summary>
    NotAround,

    /// <summary>A degree or knots that are invalid for a B-spline.</summary>
    BadKnots,

    /// <summary>Poles or weights that do not match the knots, or weights that are not positive.</summary>
    BadPoles,

    /// <summary>Curves that should meet in a mesh are too far apart.</summary>
    OpenMesh,
}
