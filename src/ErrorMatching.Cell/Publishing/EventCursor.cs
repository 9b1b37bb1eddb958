
namespace ErrorMatching.Cell;

/// <summary>Remembers in the store how far the audit trail was published. The trail itself is the list of what is to be
/// published.</summary>
/// <param name="store">The store.</param>
/// <param name="cell">The cell, since several cells may share a store.</param>
internal sealed class EventCursor(CellStore store, string cell)
{
    /// <summary>Starts at the current end of the trail, unless the cell has published before: the plant hears of what happens from now
    /// on, not of years.</summary>
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
