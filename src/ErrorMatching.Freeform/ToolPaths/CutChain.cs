using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform;

/// <summary>Pieces of the path that are cut one after another without leaving the surface.</summary>
/// <param name="Pieces">The pieces in order; each begins where the one before ends.</param>
/// <param name="LeadIn">From the first center to where the tool comes down, in millimetres.</param>
/// <param name="LeadOut">From the last center to where the tool goes up.</param>
internal sealed record CutChain(IReadOnlyList<CutPiece> Pieces, Vector3 LeadIn, Vector3 LeadOut);
