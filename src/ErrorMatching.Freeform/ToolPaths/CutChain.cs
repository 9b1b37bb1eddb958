using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Pieces of the path that are cut consecutively without leaving the surface.</summary>
/// <param name="Pieces">The pieces in order; each starts where the previous one ends.</param>
/// <param name="LeadIn">From the first center to the place where the tool descends, in millimeters.</param>
/// <param name="LeadOut">From the last center to the place where the tool retracts.</param>
internal sealed record CutChain(IReadOnlyList<CutPiece> Pieces, Vector3 LeadIn, Vector3 LeadOut);
