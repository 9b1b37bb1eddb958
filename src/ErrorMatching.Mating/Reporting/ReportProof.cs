using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>The proof of the program that was written.</summary>
/// <param name="Holds">True if the new program moves as wanted and nothing else changed.</param>
/// <param name="Motions">Number of motions compared.</param>
/// <param name="MovedMotions">Number of motions that differ.</param>
/// <param name="Neighbors">Blocks next to the named ones that moved because they touch them, with their roles.</param>
/// <param name="Marker">The inserted comment, or null.</param>
/// <param name="MaxDeviationFromWantedMm">The largest distance of an end point or center from its wanted position.</param>
/// <param name="UntouchedBytesIdentical">True if every byte outside the edits is unchanged.</param>
public sealed record ReportProof(
    bool Holds,
    int Motions,
    int MovedMotions,
    IReadOnlyList<ProofNeighbor> Neighbors,
    string? Marker,
    double MaxDeviationFromWantedMm,
    bool UntouchedBytesIdentical);
