using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Everything that the store keeps of one correction, read once: for looking at it as it was, and as it is.</summary>
/// <param name="Correction">The correction.</param>
/// <param name="Steps">What became of it, step by step.</param>
/// <param name="Report">The report of the match; null if there is none, or it is of another kind.</param>
/// <param name="Lines">The original program and the new one; null before it is computed.</param>
public sealed record KeptCorrection(Correction Correction, IReadOnlyList<CorrectionStep> Steps, KeptReport? Report, ProgramLines? Lines)
{
    /// <summary>Reads it. This takes its time: not to be called on the screen's thread.</summary>
    /// <param name="store">The store.</param>
    /// <param name="correction">The correction.</param>
    /// <exception cref="StoreException">The store cannot be read.</exception>
    public static KeptCorrection Read(CellStore store, Correction correction)
    {
        ArgumentNullException.ThrowIfNull(store);
        ArgumentNullException.ThrowIfNull(correction);
        var report = correction.ReportSha256 is { } sha ? KeptReport.Read(store.Content(sha)) : null;
        var lines = correction is { BaseSha256: { } was, ProgramSha256: { } now } ? new ProgramLines(store.Content(was), store.Content(now), report?.Blocks ?? []) : null;
        return new(correction, store.StepsOf(correction.Id), report, lines);
    }
}
