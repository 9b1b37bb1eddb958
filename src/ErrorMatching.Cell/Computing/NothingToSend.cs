using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>A readable measurement that needs no program: it is kept as evidence.</summary>
/// <param name="Basis">The inputs that it is based on.</param>
/// <param name="Code">Stable code: one of <see cref="CorrectionCodes"/>.</param>
/// <param name="Reason">Why nothing is sent, in a setter's terms.</param>
public sealed record NothingToSend(CorrectionBasis Basis, string Code, Statement Reason) : Computation
{
    /// <summary>How well a counterpart fits its part, as JSON (<c>errormatch/verify/1</c>); null if nothing was compared.</summary>
    public ReadOnlyMemory<byte>? Report { get; init; }

    /// <summary>The same as a page.</summary>
    public ReadOnlyMemory<byte>? Page { get; init; }
}
