namespace ErrorMatching.Cell;

/// <summary>An approved correction that is not sent, because undecided ones precede it in line.</summary>
/// <param name="Correction">The correction.</param>
/// <param name="Behind">The corrections that hold it up, in line order: proposed ones, and ones that failed at the machine. At least
/// one.</param>
public sealed record HeldUpCorrection(Correction Correction, IReadOnlyList<Correction> Behind);
