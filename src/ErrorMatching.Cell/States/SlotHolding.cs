namespace ErrorMatching.Cell;

/// <summary>What a machine's slot holds, as far as the cell knows.</summary>
/// <param name="Machine">The machine.</param>
/// <param name="Slot">Its slot.</param>
/// <param name="Correction">The correction that has the slot, from uploading until it is released, reverted or given back; null if the slot
/// is free.</param>
/// <param name="ProgramSha256">The last program verified there; null if the cell has sent none.</param>
/// <param name="PreviousSha256">The program before it; null if there was none.</param>
public sealed record SlotHolding(string Machine, string Slot, long? Correction, string? ProgramSha256, string? PreviousSha256);
