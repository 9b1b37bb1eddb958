using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>The result of a measurement: <see cref="Identified"/> before it is computed, then a <see cref="ComputedProgram"/> or
/// <see cref="NothingToSend"/>; at any time a <see cref="RefusedComputation"/>.</summary>
public abstract record Computation;

/// <summary>The inputs of a correction, before it is computed.</summary>
/// <param name="Basis">The inputs that it is based on.</param>
internal sealed record Identified(CorrectionBasis Basis) : Computation;

/// <summary>A readable measurement that needs no program: it is kept as evidence.</summary>
/// <param name="Basis">The inputs that it is based on.</param>
/// <param name="Code">Stable code: one of <see cref="CorrectionCodes"/>.</param>
/// <param name="Reason">Why nothing is sent, in a setter's terms.</param>
internal sealed record NothingToSend(CorrectionBasis Basis, string Code, Statement Reason) : Computation
{
    /// <summary>How well a counterpart fits its part, as JSON (<c>errormatch/verify/1</c>); null if nothing was compared.</summary>
    public ReadOnlyMemory<byte>? Report { get; init; }

    /// <summary>The same as a page.</summary>
    public ReadOnlyMemory<byte>? Page { get; init; }

    /// <summary>True if the page was drawn from the report alone.</summary>
    public bool IsPageOfReport { get; init; }
}

/// <summary>Why no program may be made from a measurement.</summary>
/// <param name="Code">Stable code: one of <see cref="CorrectionCodes"/>, or the console's code for the same inputs.</param>
/// <param name="Reason">The problem and what to do, in a setter's terms.</param>
public sealed record RefusedComputation(string Code, Statement Reason) : Computation
{
    /// <summary>The block concerned as the setter knows it, such as <c>N110</c>; null for none.</summary>
    public string? Block { get; init; }

    /// <summary>True if the cause is not the measurement but a file of the job that cannot be opened now: a later attempt may
    /// succeed.</summary>
    public bool MayPass { get; init; }
}
