namespace ErrorMatching.Cell;

/// <summary>A correction that is approved and not sent, since others stand before it in line about which nobody has decided.</summary>
/// <param name="Correction">The correction.</param>
/// <param name="Behind">Those others, in the order of the line: proposed ones and ones that failed at the machine. At least one.</param>
public sealed record HeldUpCorrection(Correction Correction, IReadOnlyList<Correction> Behind);
