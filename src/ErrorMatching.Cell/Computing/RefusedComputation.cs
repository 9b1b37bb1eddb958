namespace ErrorMatching.Cell;

/// <summary>Why no program may be made of a measurement.</summary>
/// <param name="Code">Stable word: one of <see cref="CorrectionCodes"/>, or what the console says to the same inputs.</param>
/// <param name="Reason">What was found and what is to be done, in a setter's words.</param>
public sealed record RefusedComputation(string Code, string Reason) : Computation
{
    /// <summary>The block concerned as the setter knows it, such as <c>N110</c>; null if none is.</summary>
    public string? Block { get; init; }

    /// <summary>True if not the measurement is to blame but a file of the job that cannot be opened now: the same may succeed later.</summary>
    public bool MayPass { get; init; }
}
