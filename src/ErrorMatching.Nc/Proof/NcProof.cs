using ErrorMatching.Refusals;

namespace ErrorMatching.Nc;

/// <summary>Result of comparing a displaced program with its original.</summary>
/// <param name="Holds">True if the wish was met and nothing else changed.</param>
/// <param name="Motions">Number of motions of the original.</param>
/// <param name="MovedMotions">Motions whose start, end or center differs.</param>
/// <param name="Neighbors">Unnamed motions that moved along, as allowed.</param>
/// <param name="Marker">The inserted marker comment; null if there is none.</param>
/// <param name="MaxDeviationFromWantedMm">Largest distance of a displaced element from its wished place, mm; in a valid result, only
/// rounding.</param>
/// <param name="UntouchedBytesIdentical">True if every byte outside coordinate words of moved blocks is the same.</param>
/// <param name="Failures">What is wrong, in program order; empty if the proof holds.</param>
public sealed record NcProof(
    bool Holds,
    int Motions,
    int MovedMotions,
    IReadOnlyList<ProofNeighbor> Neighbors,
    string? Marker,
    double MaxDeviationFromWantedMm,
    bool UntouchedBytesIdentical,
    IReadOnlyList<Refusal> Failures);

/// <summary>An unnamed motion that moved along with the named ones, as allowed.</summary>
/// <param name="Block">Name of its block, as the setter knows it.</param>
/// <param name="Line">Its line in the original, from 1.</param>
/// <param name="Role">How it follows.</param>
/// <param name="DisplacementMm">How far it moved at most, at its ends and between them, mm.</param>
public sealed record ProofNeighbor(string Block, int Line, NeighborRole Role, double DisplacementMm);

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
