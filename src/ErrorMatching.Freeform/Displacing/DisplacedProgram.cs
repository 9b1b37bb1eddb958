using ErrorMatching.Nc;

namespace ErrorMatching.Freeform;

/// <summary>A finishing program whose points follow the compensation, with its proof.</summary>
/// <param name="Program">The new program.</param>
/// <param name="Before">The original, interpreted.</param>
/// <param name="Wish">What was asked of it.</param>
/// <param name="Rewrite">What was changed.</param>
/// <param name="Proof">The comparison of both; it holds.</param>
/// <param name="Marker">The comment that was inserted, so that the error is not cut away twice; null where nothing was changed.</param>
/// <param name="OnSurface">Points at which the ball touches the surface.</param>
/// <param name="Followed">Points near the surface that went along: leads, links and positioning.</param>
/// <param name="LargestMoveMm">Largest displacement of a point, in millimetres.</param>
/// <param name="LargestMisfitMm">By how much, at most, a straight cut misses half way what its ends were given: the error field bends between two points, a line does not. In millimetres.</param>
public sealed record DisplacedProgram(NcProgram Program, NcPath Before, DisplacementWish Wish, Rewrite Rewrite, NcProof Proof, Marker? Marker, int OnSurface, int Followed, double LargestMoveMm, double LargestMisfitMm);
