using System.Data.Common;

namespace ErrorMatching.Cell;

/// <summary>Rows of the audit trail.</summary>
internal static class AuditRow
{
    public const string Select = "SELECT seq, at, who, what, subject, basis, previous, hash, row_codes FROM audit";

    public static AuditEntry Read(DbDataReader row) => new(
        row.GetInt64(0), StoredTime.From(row.GetInt64(1)), row.GetString(2), row.GetString(3), row.StatementOrNull(4),
            Recorded.Read(row.GetString(5)),
            row.GetString(6), row.GetString(7))
    {
        RowCodes = row.TextOrNull(8),
    };

    /// <summary>Reads a row that somebody else may have written: one that cannot be read becomes an entry without a hash.</summary>
    public static AuditEntry ReadOrUnreadable(DbDataReader row)
    {
        try
        {
            return Read(row);
        }
        catch (Exception e) when (
            e is InvalidCastException or FormatException or ArgumentException or OverflowException or InvalidOperationException)
        {
            return new(row.GetInt64(0), DateTimeOffset.UnixEpoch, "", "", null, "", "", "");
        }
    }

    public static AuditHead Head(DbConnection connection, DbTransaction? transaction, string forUpdate)
    {
        var found = Rows.Query(
            connection,
            "SELECT seq, at, hash, seal FROM audit_head WHERE only_row = 1" + forUpdate,
            r => new AuditHead(r.GetInt64(0), StoredTime.From(r.GetInt64(1)), r.GetString(2), r.TextOrNull(3)),
            transaction: transaction);
        return found.Count == 1
            ? found[0]
            : throw new StoreException(
                StoreError.Damaged, "The store has lost the row that says where its audit trail ends. Restore the latest backup.");
    }
}
