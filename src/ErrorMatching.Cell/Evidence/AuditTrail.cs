using System.Data.Common;
using System.Globalization;

namespace ErrorMatching.Cell;

/// <summary>The audit trail of a store, as evidence: looked at and handed out.</summary>
/// <param name="store">The store.</param>
/// <param name="keysFolder">The folder of the keys that sealed it. It is not made here.</param>
/// <remarks>Failures of the store are a <see cref="StoreException"/>, those of the keys a <see cref="PeopleException"/>.</remarks>
public sealed class AuditTrail(CellStore store, string keysFolder)
{
    private static readonly string[] Columns = ["number", "time", "who", "what", "subject", "basis", "previous", "hash"];

    /// <summary>Looks at every entry. What was found whole is remembered beside the keys, if they are there.</summary>
    public AuditFinding Verify()
    {
        var (key, witness) = (AuditKey.Find(keysFolder), AuditWitness.Find(keysFolder));
        var finding = store.Database.Snapshot((connection, transaction) =>
            new AuditVerifier(() => Rows.Stream(connection, AuditRow.Select + " ORDER BY seq", ReadOrNull, null, transaction), AuditRow.Head(connection, transaction, ""), key, witness).Verify());
        if (finding.Holds && key is not null && finding.Entries > (witness?.Seq ?? 0))
        {
            new AuditWitness(finding.Entries, finding.Hash).Keep(keysFolder);
        }

        return finding;
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

    /// <summary>Writes all entries as CSV by RFC 4180 that no spreadsheet executes: times in UTC, texts as they are but for an apostrophe in front of what looks like a formula.</summary>
    /// <returns>How many entries.</returns>
    public long Export(TextWriter writer) => store.Database.Snapshot((connection, transaction) =>
    {
        SpreadsheetCsv.Write(writer, Columns);
        var count = 0L;
        foreach (var e in Rows.Stream(connection, AuditRow.Select + " ORDER BY seq", AuditRow.Read, null, transaction))
        {
            SpreadsheetCsv.Write(
                writer, e.Seq.ToString(CultureInfo.InvariantCulture), e.At.UtcDateTime.ToString("yyyy-MM-dd'T'HH:mm:ss.ffffff'Z'", CultureInfo.InvariantCulture), e.Who, e.What, e.Subject ?? "", e.Basis, e.Previous, e.Hash);
            count++;
        }

        return count;
    });

    // A row that somebody changed may be none any more.
    private static (long Seq, AuditEntry? Entry) ReadOrNull(DbDataReader row)
    {
        var seq = row.GetInt64(0);
        try
        {
            return (seq, AuditRow.Read(row));
        }
        catch (Exception e) when (e is InvalidCastException or FormatException or ArgumentException or OverflowException or InvalidOperationException)
        {
            return (seq, null);
        }
    }
}
