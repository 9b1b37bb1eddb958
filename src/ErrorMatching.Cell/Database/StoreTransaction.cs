using System.Data.Common;
using System.Globalization;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>A change of the store in progress, with its audit entries. The writers of all processes are serialized.</summary>
internal sealed class StoreTransaction
{
    private static readonly TimeSpan ClockTolerance = TimeSpan.FromSeconds(1);
    private readonly byte[]? _auditKey;
    private readonly DbTransaction _transaction;
    private readonly AuditHead _before;
    private readonly Dictionary<string, string> _rowCodes = new(StringComparer.Ordinal);
    private AuditHead _head;

    private StoreTransaction(DbConnection connection, DbTransaction transaction, AuditHead head, DateTimeOffset now, byte[]? auditKey)
    {
        Connection = connection;
        _transaction = transaction;
        _head = _before = head;
        Now = now;
        _auditKey = auditKey;
    }

    /// <summary>The time of everything in this change.</summary>
    public DateTimeOffset Now { get; }

    /// <summary>The current end of the audit trail.</summary>
    public AuditHead Head => _head;

    /// <summary>The database's own transaction.</summary>
    public DbTransaction Transaction => _transaction;

    /// <summary>The connection; statements on it belong to this change.</summary>
    public DbConnection Connection { get; }

    public static StoreTransaction Begin(
        DbConnection connection, DbTransaction transaction, string forUpdate, TimeProvider clock, byte[]? auditKey)
    {
        var head = AuditRow.Head(connection, transaction, forUpdate);
        return new StoreTransaction(connection, transaction, head, StoredTime.Rounded(clock.GetUtcNow()), auditKey);
    }

    /// <summary>Runs a statement; its parameters are the properties of an object.</summary>
    /// <returns>How many rows it changed.</returns>
    public int Execute(string sql, SqlArguments? parameters = null) => Connection.Execute(sql, parameters, _transaction);

    /// <summary>The first column of the first row; the type's default if there is no row.</summary>
    public T? Value<T>(string sql, SqlArguments? parameters = null) => Connection.Value<T>(sql, parameters, _transaction);

    /// <summary>The rows that a statement finds.</summary>
    public IReadOnlyList<T> Query<T>(string sql, Func<DbDataReader, T> row, SqlArguments? parameters = null) =>
        Rows.Query(Connection, sql, row, parameters, _transaction);

    /// <summary>The first row that a statement finds; null if it finds none.</summary>
    public T? First<T>(string sql, Func<DbDataReader, T> row, SqlArguments? parameters = null)
        where T : class => Rows.First(Connection, sql, row, parameters, _transaction);

    /// <summary>The key that codes rows and seals the end of the trail; null for none.</summary>
    public byte[]? Key => _auditKey;

    /// <summary>Codes a row as it is now being written; the next audit entry names the code.</summary>
    /// <returns>Null without a key.</returns>
    public string? CodeOf(CodedRow row) => _auditKey is null ? null : _rowCodes[row.Name] = row.Code(_auditKey);

    /// <summary>Appends an entry to the audit trail.</summary>
    public void Audit(string who, string what, Statement? subject, Statement basis)
    {
        if (_head == _before && _head.Seq > 0 && _head.At - Now > ClockTolerance)
        {
            Append(AuditEntry.ByCell, "clock", null, string.Create(
                CultureInfo.InvariantCulture,
                $"The clock says {Now:yyyy-MM-dd HH:mm:ss.ffffff} UTC and said {_head.At:yyyy-MM-dd HH:mm:ss.ffffff} before; entries are "
                    + $"in order of their numbers."));
        }

        var rows = _rowCodes.Count == 0 ? null : CodedRow.Lines(_rowCodes.Select(r => (r.Key, r.Value)));
        _rowCodes.Clear();
        Append(StoredText.Name(who), StoredText.Name(what), StoredText.NameOrNull(subject), StoredText.Of(basis), rows);
    }

    /// <summary>Stores the current end of the audit trail.</summary>
    /// <returns>The end of the trail.</returns>
    /// <exception cref="InvalidOperationException">A row was coded, but no audit entry named its code.</exception>
    public AuditHead Finish()
    {
        if (_rowCodes.Count > 0) throw new InvalidOperationException($"No audit entry names the code of {_rowCodes.First().Key}.");
        if (_head != _before)
        {
            Execute(
                "UPDATE audit_head SET seq = @Seq, at = @At, hash = @Hash, seal = @Seal WHERE only_row = 1",
                [("Seq", _head.Seq), ("At", StoredTime.Of(_head.At)), ("Hash", _head.Hash), ("Seal", _head.Seal)]);
        }

        return _head;
    }

    private void Append(string who, string what, Statement? subject, Statement basis, string? rowCodes = null)
    {
        var entry = AuditEntry.After(_head.Hash, _head.Seq + 1, Now, who, what, subject, basis, rowCodes);

        // The first entry of a store is written while its schema has no row codes yet.
        var (column, value) = entry.RowCodes is null ? ("", "") : (", row_codes", ", @RowCodes");
        Execute(
            $"INSERT INTO audit (seq, at, who, what, subject, basis, previous, hash{column}) VALUES (@Seq, @At, @Who, @What, @Subject, "
                + $"@Basis, @Previous, @Hash{value})",
            [
                ("Seq", entry.Seq),
                ("At", StoredTime.Of(Now)),
                ("Who", entry.Who),
                ("What", entry.What),
                ("Subject", entry.Subject?.Text),
                ("Basis", entry.Basis.Text),
                ("Previous", entry.Previous),
                ("Hash", entry.Hash),
                ("RowCodes", entry.RowCodes),
            ]);
        _head = _head.With(entry, _auditKey, begins: what == "created" && _head.Seq == 0);
    }
}
