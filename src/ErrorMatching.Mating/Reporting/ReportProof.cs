using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>What was shown about the program that was written.</summary>
/// <param name="Holds">True if the new program moves as wanted and nothing else changed.</param>
/// <param name="Motions">Number of motions compared.</param>
/// <param name="MovedMotions">Number of motions that differ.</param>
/// <param name="Neighbors">Blocks beside the named ones that moved because they touch them, each with how it follows.</param>
/// <param name="Marker">The comment that was inserted; null if none was.</param>
/// <param name="MaxDeviationFromWantedMm">The largest distance of an end point or center from where it was wanted.</param>
/// <param name="UntouchedBytesIdentical">True if every byte outside the edits is the original one.</param>
public sealed record ReportProof(
    bool Holds,
    int Motions,
    int MovedMotions,
    IReadOnlyList<ProofNeighbor> Neighbors,
    string? Marker,
    double MaxDeviationFromWantedMm,
    bool UntouchedBytesIdentical);
