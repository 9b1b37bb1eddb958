namespace ErrorMatching.Cell;

/// <summary>The inputs of a correction, before it is computed.</summary>
/// <param name="Basis">The inputs that it is based on.</param>
public sealed record Identified(CorrectionBasis Basis) : Computation;
