namespace ErrorMatching.Cell;

/// <summary>Corrections that have not ended and wait for the same thing.</summary>
/// <param name="State">Their state.</param>
/// <param name="Gauge">The gauge that they came from.</param>
/// <param name="Job">Their job; null before they are recognized.</param>
/// <param name="Machine">Their machine; null before they are recognized.</param>
/// <param name="Slot">Its slot; null before they are recognized.</param>
/// <param name="Count">How many.</param>
/// <param name="First">Number of the first.</param>
internal sealed record WaitingCorrections(
    CorrectionState State, string Gauge, string? Job, string? Machine, string? Slot, long Count, long First);
