namespace ErrorMatching.Cell;

/// <summary>A measurement that can be read and asks for no program: it is kept as evidence.</summary>
/// <param name="Basis">What it stands on.</param>
/// <param name="Code">Stable word: one of <see cref="CorrectionCodes"/>.</param>
/// <param name="Reason">Why nothing is sent, in a setter's words.</param>
public sealed record NothingToSend(CorrectionBasis Basis, string Code, string Reason) : Computation;
