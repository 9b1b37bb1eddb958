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

/// <summary>Remembers in the store how far the audit trail was published. The trail itself is the list of what is to be
/// published.</summary>
/// <param name="store">The store.</param>
/// <param name="cell">The cell, since several cells may share a store.</param>
internal sealed class EventCursor(CellStore store, string cell)
{
    /// <summary>Starts at the current end of the trail, unless the cell has published before: steps of the past are not
    /// published.</summary>
    /// <exception cref="StoreException">The store cannot be used.</exception>
    public void Begin() => Change(
        "INSERT INTO event_cursor (cell, seq) VALUES (@cell, @seq) ON CONFLICT (cell) DO NOTHING", store.AuditHead().Seq);

    /// <summary>Number of the last entry that needs not be published again; 0 for none.</summary>
    /// <exception cref="StoreException">The store cannot be used.</exception>
    public long Read() =>
        store.Read("SELECT seq FROM event_cursor WHERE cell = @cell", r => r.GetInt64(0), [("cell", cell)]) is [var seq] ? seq : 0;

    /// <summary>Records that nothing up to an entry needs to be published again.</summary>
    /// <exception cref="StoreException">The store cannot be used.</exception>
    public void Advance(long seq) => Change("UPDATE event_cursor SET seq = @seq WHERE cell = @cell AND seq < @seq", seq);

    private void Change(string sql, long seq) =>
        store.Database.Change((connection, transaction) => connection.Execute(sql, [("cell", cell), ("seq", seq)], transaction));
}
