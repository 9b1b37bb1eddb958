using System.Data.Common;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>What an audit trail says as of one of its entries, in the store and coded with the trail's key. The hash of an entry covers all
/// entries before it, so a checkpoint whose entry is in a trail belongs to that trail and to no other.</summary>
/// <param name="Seq">Number of the last entry that it covers.</param>
/// <param name="Hash">Hash of that entry.</param>
/// <param name="State">The state, as <see cref="ReplayState"/> writes it.</param>
internal sealed record AuditCheckpoint(long Seq, string Hash, string State)
{
    /// <summary>The most characters of a state: some 50,000 corrections that have not ended.</summary>
    public const int MostLength = 16 << 20;

    private const string Name = "audit checkpoint";

    /// <summary>Finds the checkpoint of a store and checks that it holds.</summary>
    /// <returns>The checkpoint; or null, with the reason.</returns>
    public static (AuditCheckpoint? Found, Statement? Problem) Find(DbConnection connection, DbTransaction transaction, byte[] key)
    {
        if (Kept(connection, transaction) is not { } row) return (null, RecordedCheckpoint.Missing.With());
        if (Problem(connection, transaction, row, key) is { } problem) return (null, problem);
        return ReplayState.IsOfThisBuild(row.Value.State) ? (row.Value, null) : (null, RecordedCheckpoint.OfOtherBuild.With());
    }

    /// <summary>What somebody else changed about the checkpoint; null if nothing, or if there is none.</summary>
    public static AuditFault? Fault(DbConnection connection, DbTransaction transaction, byte[] key) =>
        Kept(connection, transaction) is { } row && Problem(connection, transaction, row, key) is { } problem
            ? new(AuditFaultKind.RowDiffers, row.Value.Seq, problem) : null;

    /// <summary>Stores it in place of the one before.</summary>
    public void Keep(CellDatabase database, byte[] key) => database.Change((connection, transaction) => connection.Execute(
        "INSERT INTO audit_checkpoint (only_row, seq, hash, state, row_code) VALUES (1, @Seq, @Hash, @State, @Code) ON CONFLICT (only_row) "
            + "DO UPDATE SET seq = excluded.seq, hash = excluded.hash, state = excluded.state, row_code = excluded.row_code",
        [("Seq", Seq), ("Hash", Hash), ("State", State), ("Code", Coded(this).Code(key))],
        transaction));

    /// <summary>Removes the checkpoint of a store, so that the next process reads the whole trail.</summary>
    public static void Remove(CellDatabase database) =>
        database.Change((connection, transaction) => connection.Execute("DELETE FROM audit_checkpoint", transaction: transaction));

    // A row that cannot be read is one that somebody else wrote.
    private static StoredRow<AuditCheckpoint>? Kept(DbConnection connection, DbTransaction transaction) => Rows.Query(
        connection,
        $"SELECT seq, hash, CASE WHEN length(state) <= {CodedRow.Number(MostLength)} THEN state ELSE '' END, row_code FROM "
            + "audit_checkpoint WHERE only_row = 1",
        r => RecordedRows.Read(
            r,
            c => new StoredRow<AuditCheckpoint>(new(c.GetInt64(0), c.GetString(1), c.GetString(2)), Coded, c.TextOrNull(3)),
            Name).Row ?? new(new(0, "", ""), Coded, null),
        null,
        transaction) is [var row] ? row : null;

    private static Statement? Problem(
        DbConnection connection, DbTransaction transaction, StoredRow<AuditCheckpoint> row, byte[] key)
    {
        if (!row.Holds(key)) return RecordedCheckpoint.Foreign.With(row.Value.Seq);
        var at = Rows.First(
            connection, AuditRow.Select + " WHERE seq = @Seq", AuditRow.ReadOrUnreadable, [("Seq", row.Value.Seq)], transaction);
        return at is not null && at.Hash == row.Value.Hash && at.IsWrittenAs(at.Seq) ? null : RecordedCheckpoint.Astray.With(row.Value.Seq);
    }

    private static CodedRow Coded(AuditCheckpoint checkpoint) =>
        new(Name, [CodedRow.Number(checkpoint.Seq), checkpoint.Hash, checkpoint.State]);
}
