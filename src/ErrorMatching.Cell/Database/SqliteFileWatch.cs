using Microsoft.Data.Sqlite;

namespace ErrorMatching.Cell;

/// <summary>Watches the file of an open store. A removed file remains usable for a process that has it open, and anything written to it is
/// lost when the last one closes it. So the file's identity is checked before each use and after each change. A replacement file is used
/// only if it has everything that was seen here.</summary>
/// <param name="file">The store's file.</param>
/// <param name="seen">Returns the end of the audit trail when this process last saw it; null if it has not seen it.</param>
internal sealed class SqliteFileWatch(string file, Func<AuditHead?> seen)
{
    private volatile FileIdentity? _identity;
    private (FileIdentity Identity, StoreException Reason)? _refused;

    /// <summary>False if another file, or none, has the store's name meanwhile.</summary>
    public bool IsInPlace => FileIdentity.Of(file) == _identity;

    /// <summary>Ensures that the file with the store's name is the one in use, or may take its place.</summary>
    /// <param name="writing">The lock that serializes the writers.</param>
    /// <param name="close">Closes all connections to the file in use.</param>
    /// <exception cref="StoreException">With <see cref="StoreError.Away"/> or <see cref="StoreError.Replaced"/>.</exception>
    public void Demand(Lock writing, Action close)
    {
        var now = FileIdentity.Of(file);
        if (now is not null && now == _identity) return;
        lock (writing)
        {
            if (now is null)
            {
                close();
                throw new StoreException(
                    StoreError.Away,
                    $"The store {file} is gone. Nothing was changed. Bring its disk back; programs that have it open then continue by "
                        + $"themselves.");
            }

            if (now == _identity) return;
            if (_identity is not null)
            {
                if (_refused is not { } refused || refused.Identity != now)
                {
                    close();
                    _refused = WhyNotTheSame() is { } reason ? (now, reason) : null;
                }

                if (_refused is { } still) throw new StoreException(still.Reason.Error, still.Reason.Statement, still.Reason);
            }

            _identity = now;
        }
    }

    // Why the file that now has the store's name is not the store as last seen here; null if it is. The file is only read, never changed.
    private StoreException? WhyNotTheSame()
    {
        // The previous file's log would be read into this one.
        if (new FileInfo(file + "-wal") is { Exists: true, Length: > 0 }) return Replaced("the log beside it belongs to the file before");
        if (seen() is not { } last) return null;
        try
        {
            var how = new SqliteConnectionStringBuilder { DataSource = file, Mode = SqliteOpenMode.ReadOnly, Pooling = false };
            using var connection = new SqliteConnection(how.ConnectionString);
            connection.Open();
            if (connection.Value<int>("PRAGMA application_id") != SqliteDatabase.ApplicationId)
                return Replaced("it is no store of a cell");
            var head = AuditRow.Head(connection, null, "");
            var hash = connection.Value<string>("SELECT hash FROM audit WHERE seq = @Seq", [("Seq", last.Seq)]);
            return head.Seq < last.Seq
                ? Replaced(FormattableString.Invariant($"it lacks entries {head.Seq + 1} to {last.Seq} of the audit trail"))
                : hash != last.Hash ? Replaced(FormattableString.Invariant($"entry {last.Seq} of its audit trail is another one"))
                : null;
        }
        catch (SqliteException e)
        {
            return Replaced($"it cannot be read: {e.Message}");
        }
    }

    private StoreException Replaced(string why) => new(
        StoreError.Replaced,
        $"Another file replaced the store {file} while it was open: {why}. Nothing is written into it. Stop the cell and its stations, "
        + "bring the right file back or restore the latest backup (errormatch cell restore), then start them again.");
}
