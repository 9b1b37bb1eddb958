namespace ErrorMatching.Cell;

/// <summary>Reads the steps of a cell from the audit trail, in the order in which they were taken.</summary>
/// <param name="store">The store.</param>
/// <param name="settings">The cell.</param>
internal sealed class StepFeed(CellStore store, CellSettings settings)
{
    private readonly HashSet<string> _gauges = settings.Gauges.Select(g => g.Name).ToHashSet(StringComparer.Ordinal);

    /// <summary>The next steps.</summary>
    /// <param name="seq">Number of the audit entry after which they come.</param>
    /// <param name="most">Maximum number of audit entries to look at.</param>
    /// <returns>The steps, and the number of the last entry that was looked at; the given one if there is no more.</returns>
    /// <exception cref="StoreException">The store cannot be used.</exception>
    public (IReadOnlyList<StepEvent> Steps, long Last) After(long seq, int most)
    {
        var entries = store.AuditEntries(seq, most);
        return ([.. entries.Select(Step).OfType<StepEvent>()], entries is [.., var last] ? last.Seq : seq);
    }

    private StepEvent? Step(AuditEntry entry) =>
        CorrectionRow.StateOrNull(entry.What) is { } to
        && AuditReplay.SubjectOf(entry.Subject) is var (id, _, program)
        && store.Find(id) is { } correction
        && IsOwn(correction)
            ? new(entry, From(entry, id), to, program, correction)
            : null;

    // Cells that share a store have gauges of their own.
    private bool IsOwn(Correction correction) => !settings.Store.IsShared || _gauges.Contains(correction.Gauge);

    private CorrectionState? From(AuditEntry entry, long id) => store.Read(
        "SELECT from_state FROM step WHERE correction = @id AND at = @At AND to_state = @What ORDER BY id LIMIT 1",
        r => r.TextOrNull(0),
        [("id", id), ("At", StoredTime.Of(entry.At)), ("What", entry.What)]) is [{ } word] ? CorrectionRow.StateOrNull(word) : null;
}
