using System.Data.Common;
using System.Globalization;

namespace ErrorMatching.Cell;

/// <summary>The audit trail of a store, as evidence: looked at and handed out.</summary>
/// <param name="store">The store.</param>
/// <param name="keysFolder">The folder of the keys that sealed it. It is not made here.</param>
/// <remarks>Failures of the store are a <see cref="StoreException"/>, those of the keys a <see cref="PeopleException"/>.</remarks>
public sealed class AuditTrail(CellStore store, string keysFolder)
{
    private static readonly string[] Columns = ["number", "time", "who", "what", "subject", "basis", "previous", "hash", "rows"];

    /// <summary>Looks at every entry, as the trail is at one moment. What was found whole is remembered beside the keys, if they are there.</summary>
    public AuditFinding Verify() => Verify(null, CancellationToken.None);

    /// <summary>The same, for somebody who waits for it.</summary>
    /// <param name="progress">Told how far it is; null if nobody asks.</param>
    /// <param name="cancellation">Gives it up.</param>
    public AuditFinding Verify(IProgress<CellProgress>? progress, CancellationToken cancellation)
    {
        var (key, witness) = (AuditKey.Find(keysFolder), AuditWitness.Find(keysFolder));
        var finding = store.Database.Snapshot((connection, transaction) =>
        {
            var head = AuditRow.Head(connection, transaction, "");
            var count = Count(connection, transaction);
            var meaning = new RecordedMeaning();
            var fault = AuditChain.Verify(meaning.Replay.Added(
                Told(Rows.Stream(connection, AuditRow.Select + " ORDER BY seq", ReadOrUnreadable, null, transaction), "looking at entries",
                count, progress, cancellation)), head, key);
            var seen = Rows.Query(connection, AuditRow.Select + " WHERE seq = @Seq", ReadOrUnreadable, new { Seq = witness?.Seq ?? 0 }, transaction);
            return new AuditFinding(count, head.Hash, fault ?? witness?.Fault(head, seen)
                ?? meaning.Fault(store.Database, connection, transaction, key), key is not null);
        });
        if (finding.Holds && key is not null && finding.Entries > (witness?.Seq ?? 0))
        {
            Keep(new AuditWitness(finding.Entries, finding.Hash));
        }

        return finding;
    }

    // What was found stands, though a disk that cannot be written keeps it from being remembered.
    private void Keep(AuditWitness witness)
    {
        try
        {
            witness.Keep(keysFolder);
        }
        catch (PeopleException e) when (e.InnerException is IOException or UnauthorizedAccessException)
        {
        }
    }

    /// <summary>Remembers beside the keys how far the trail goes, without looking at more than its end: the more often, the less can be cut off unseen. Nothing happens where the end is not the one that was sealed.</summary>
    public void Remember()
    {
        var (key, witness, head) = (AuditKey.Find(keysFolder), AuditWitness.Find(keysFolder), store.AuditHead());
        if (key is not null && head.IsSealedBy(key) && head.Seq > (witness?.Seq ?? 0) && (witness is null || store.AuditEntries(witness.Seq - 1, 1) is [var seen] && seen.Seq == witness.Seq && seen.Hash == witness.Hash))
        {
            new AuditWitness(head.Seq, head.Hash).Keep(keysFolder);
        }
    }

    /// <summary>
    /// Takes over the end of a store that was set back on purpose, as by a restored backup, and puts on record how far the trail had gone. Nothing happens where it goes on from what was seen last, or where its end is not the one that was sealed.
    /// </summary>
    /// <param name="by">Who did it.</param>
    /// <param name="basis">What was done.</param>
    public void TakeOver(string by, string basis)
    {
        var (key, witness, head) = (AuditKey.Find(keysFolder), AuditWitness.Find(keysFolder), store.AuditHead());
        if (key is null || witness is null || !head.IsSealedBy(key) || witness.Fault(head, store.AuditEntries(witness.Seq - 1, 1)) is null)
        {
            return;
        }

        store.Audit(by, "trail-set-back", Recorded.SetBack.With(basis, witness.Seq, witness.Hash));
        head = store.AuditHead();
        new AuditWitness(head.Seq, head.Hash).Keep(keysFolder);
    }

    /// <summary>Writes all entries as CSV by RFC 4180 that no spreadsheet executes: times in UTC, texts as they are but for an apostrophe in front of what looks like a formula.</summary>
    /// <param name="writer">Where to.</param>
    /// <returns>How many entries.</returns>
    public long Export(TextWriter writer) => Export(writer, null, CancellationToken.None);

    /// <summary>The same, for somebody who waits for it.</summary>
    /// <param name="writer">Where to.</param>
    /// <param name="progress">Told how far it is; null if nobody asks.</param>
    /// <param name="cancellation">Gives it up.</param>
    /// <returns>How many entries.</returns>
    public long Export(TextWriter writer, IProgress<CellProgress>? progress, CancellationToken cancellation) => store.Database.Snapshot((connection, transaction) =>
    {
        SpreadsheetCsv.Write(writer, Columns);
        var count = 0L;
        foreach (var e in Told(Rows.Stream(connection, AuditRow.Select + " ORDER BY seq", AuditRow.Read, null, transaction), "writing entries", Count(connection, transaction), progress, cancellation))
        {
            SpreadsheetCsv.Write(
                writer,
                e.Seq.ToString(CultureInfo.InvariantCulture),
                e.At.UtcDateTime.ToString("yyyy-MM-dd'T'HH:mm:ss.ffffff'Z'", CultureInfo.InvariantCulture),
                e.Who,
                e.What,
                e.Subject ?? "",
                e.Basis,
                e.Previous,
                e.Hash,
                e.RowCodes ?? "");
            count++;
        }

        return count;
    });

    private static long Count(DbConnection connection, DbTransaction transaction) => Rows.Query(connection, "SELECT count(*) FROM audit", r => r.GetInt64(0), null, transaction)[0];

    private static IEnumerable<AuditEntry> Told(IEnumerable<AuditEntry> entries, string doing, long of, IProgress<CellProgress>? progress, CancellationToken cancellation)
    {
        var (done, each) = (0L, Math.Max(1, of / 100));
        foreach (var entry in entries)
        {
            if (done++ % each == 0)
            {
                cancellation.ThrowIfCancellationRequested();
                progress?.Report(new(doing, done, of));
            }

            yield return entry;
        }
    }

    // What somebody changed may be no entry any more: then it is one that has no hash.
    private static AuditEntry ReadOrUnreadable(DbDataReader row)
    {
        try
        {
            return AuditRow.Read(row);
        }
        catch (Exception e) when (e is InvalidCastException or FormatException or ArgumentException or OverflowException or InvalidOperationException)
        {
            return new(row.GetInt64(0), DateTimeOffset.UnixEpoch, "", "", null, "", "", "");
        }
    }
}
