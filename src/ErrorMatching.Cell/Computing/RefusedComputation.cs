using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

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
