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
