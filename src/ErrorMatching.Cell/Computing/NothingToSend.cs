namespace ErrorMatching.Cell;

/// <summary>A measurement that can be read and asks for no program: it is kept as evidence.</summary>
/// <param name="Basis">What it stands on.</param>
/// <param name="Code">Stable word: one of <see cref="CorrectionCodes"/>.</param>
/// <param name="Reason">Why nothing is sent, in a setter's words.</param>
public sealed record NothingToSend(CorrectionBasis Basis, string Code, string Reason) : Computation
{
    /// <summary>How well a counterpart fits its part, as JSON (<c>errormatch/verify/1</c>); null where nothing was compared.</summary>
    public ReadOnlyMemory<byte>? Report { get; init; }

    /// <summary>The same as a page.</summary>
    public ReadOnlyMemory<byte>? Page { get; init; }
}
