using Dapper;
using Microsoft.Data.Sqlite;

namespace ErrorMatching.Cell;

/// <content>The identity of the store's file.</content>
internal sealed partial class SqliteDatabase
{
    private volatile FileIdentity? _identity;
    private (FileIdentity Identity, StoreException Reason)? _refused;

    // A removed file remains usable for a process that has it open, and anything written to it is lost when the last one closes it. So the
    // file's identity is checked before each use and after each change. A replacement file is used only if it has everything that was seen
    // here.
    private void DemandFile()
    {
        var now = FileIdentity.Of(_file);
        if (now is not null && now == _identity) return;
        lock (_writing)
        {
            if (now is null)
            {
                Close();
                throw new StoreException(
                    StoreError.Away,
                    $"The store {_file} is gone. Nothing was changed. Bring its disk back; programs that have it open then continue by "
                        + $"themselves.");
            }

            if (now == _identity) return;
            if (_identity is not null)
            {
                if (_refused is not { } refused || refused.Identity != now)
                {
                    Close();
                    _refused = WhyNotTheSame() is { } reason ? (now, reason) : null;
                }

                if (_refused is { } still) throw new StoreException(still.Reason.Error, still.Reason.Statement, still.Reason);
            }

            _identity = now;
        }
    }

    private void Close()
    {
        Interlocked.Increment(ref _losses);
        while (_readers.TryTake(out var reader)) reader.Dispose();
        _writer?.Dispose();
        _writer = null;
    }

    // Why the file that now has the store's name is not the store as last seen here; null if it is. The file is only read, never changed.
    private StoreException? WhyNotTheSame()
    {
        // The previous file's log would be read into this one.
        if (new FileInfo(_file + "-wal") is { Exists: true, Length: > 0 }) return Replaced("the log beside it belongs to the file before");
        if (Seen is not { } seen) return null;
        try
        {
            var how = new SqliteConnectionStringBuilder { DataSource = _file, Mode = SqliteOpenMode.ReadOnly, Pooling = false };
            using var connection = new SqliteConnection(how.ConnectionString);
            connection.Open();
            if (connection.QuerySingle<int>("PRAGMA application_id") != ApplicationId) return Replaced("it is no store of a cell");
            var head = AuditRow.Head(connection, null, "");
            var hash = connection.QueryFirstOrDefault<string>("SELECT hash FROM audit WHERE seq = @Seq", new { seen.Seq });
            return head.Seq < seen.Seq
                ? Replaced(FormattableString.Invariant($"it lacks entries {head.Seq + 1} to {seen.Seq} of the audit trail"))
                : hash != seen.Hash ? Replaced(FormattableString.Invariant($"entry {seen.Seq} of its audit trail is another one"))
                : null;
        }
        catch (SqliteException e)
        {
            return Replaced($"it cannot be read: {e.Message}");
        }
    }

    private StoreException Replaced(string why) => new(
        StoreError.Replaced,
        $"Another file replaced the store {_file} while it was open: {why}. Nothing is written into it. Stop the cell and its stations, "
        + "bring the right file back or restore the latest backup (errormatch cell restore), then start them again.");
}
