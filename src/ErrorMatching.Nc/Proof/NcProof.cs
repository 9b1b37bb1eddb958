namespace ErrorMatching.Nc;

/// <summary>What the comparison of a displaced program with its original showed.</summary>
/// <param name="Holds">True if the wish was met and nothing else changed.</param>
/// <param name="Motions">Number of motions of the original.</param>
/// <param name="MovedMotions">Motions whose start, end or center differs.</param>
/// <param name="Neighbors">Motions that were not named but moved along, as they may.</param>
/// <param name="Marker">The marker comment that was inserted; null where none was.</param>
/// <param name="MaxDeviationFromWantedMm">Largest distance of a displaced element from where it was wanted;
/// the rounding of the program, if all is well.</param>
/// <param name="UntouchedBytesIdentical">True if every byte outside coordinate words of moved blocks is the same.</param>
/// <param name="Failures">What is wrong, in the order of the program; empty if the proof holds.</param>
public sealed record NcProof(
    bool Holds,
    int Motions,
    int MovedMotions,
    IReadOnlyList<ProofNeighbor> Neighbors,
    string? Marker,
    double MaxDeviationFromWantedMm,
    bool UntouchedBytesIdentical,
    IReadOnlyList<NcRefusal> Failures);
