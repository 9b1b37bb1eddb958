using ErrorMatching.Nc;

namespace ErrorMatching.Freeform;

/// <summary>A finishing program whose points follow the compensation, with its proof.</summary>
/// <param name="Program">The new program.</param>
/// <param name="Before">The interpreted original.</param>
/// <param name="Wish">The requested displacement.</param>
/// <param name="Rewrite">The changes.</param>
/// <param name="Proof">The comparison of both programs; it passed.</param>
/// <param name="Marker">The inserted comment, which prevents compensating the error twice; null if nothing was changed.</param>
/// <param name="OnSurface">Number of points at which the ball touches the surface.</param>
/// <param name="Followed">Number of points near the surface that moved along: leads, links and positioning.</param>
/// <param name="LargestMoveMm">Largest displacement of a point, in millimeters.</param>
/// <param name="LargestMisfitMm">Largest error of a straight cut at its midpoint, in millimeters: the error field bends between two
/// points, the line does not.</param>
public sealed record DisplacedProgram(
    NcProgram Program,
    NcPath Before,
    DisplacementWish Wish,
    Rewrite Rewrite,
    NcProof Proof,
    Marker? Marker,
    int OnSurface,
    int Followed,
    double LargestMoveMm,
    double LargestMisfitMm);
