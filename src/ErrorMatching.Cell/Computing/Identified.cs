namespace ErrorMatching.Cell;

/// <summary>What a correction will stand on, before it is computed.</summary>
/// <param name="Basis">What it stands on.</param>
public sealed record Identified(CorrectionBasis Basis) : Computation;
