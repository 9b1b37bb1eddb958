using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Everything that the store keeps of one correction, read once: for looking at it as it was, and as it is.</summary>
/// <param name="Correction">The correction.</param>
/// <param name="Steps">What became of it, step by step.</param>
/// <param name="Report">The report of the match; null if there is none, or it is of another kind.</param>
/// <param name="Lines">The original program and the new one, which is its own original where it was made anew; null before it is computed.</param>
public sealed record KeptCorrection(Correction Correction, IReadOnlyList<CorrectionStep> Steps, KeptReport? Report, ProgramLines? Lines)
{
    /// <summary>The report of a surface; null if there is none.</summary>
    public KeptSurface? Surface { get; init; }

    /// <summary>Reads it. This takes its time: not to be called on the screen's thread.</summary>
    /// <param name="store">The store.</param>
    /// <param name="correction">The correction.</param>
    /// <exception cref="StoreException">The store cannot be read.</exception>
    public static KeptCorrection Read(CellStore store, Correction correction)
    {
        ArgumentNullException.ThrowIfNull(store);
        ArgumentNullException.ThrowIfNull(correction);
        var json = correction.ReportSha256 is { } sha ? store.Content(sha) : null;
        var (report, surface) = json is null ? (null, null) : (KeptReport.Read(json), KeptSurface.Read(json));
        var program = correction.ProgramSha256 is { } made ? store.Content(made) : null;
        var lines = program is null ? null
            : correction.BaseSha256 is { } was ? new ProgramLines(store.Content(was), program, report?.Blocks ?? [])
            : surface is not null ? new ProgramLines(program, program, [])
            : null;
        return new(correction, store.StepsOf(correction.Id), report, lines) { Surface = surface };
    }
}
