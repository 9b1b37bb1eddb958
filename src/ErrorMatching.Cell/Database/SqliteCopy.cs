using Microsoft.Data.Sqlite;
using SQLitePCL;

namespace ErrorMatching.Cell;

/// <summary>Copies a SQLite database as of one moment, while others continue to write. Source: sqlite.org/backup.html.</summary>
internal static class SqliteCopy
{
    private const int PagesAtOnce = 256;

    /// <summary>Copies all pages.</summary>
    /// <exception cref="SqliteException">Either database cannot be read or written.</exception>
    /// <exception cref="OperationCanceledException">Canceled; the copy is unusable.</exception>
    public static void Copy(SqliteConnection from, SqliteConnection to, IProgress<CellProgress>? progress, CancellationToken cancellation)
    {
        // This view excludes concurrent changes. Without it, each of them would restart the copy.
        using var view = from.BeginTransaction(deferred: true);
        from.Value<long>("SELECT count(*) FROM sqlite_master", transaction: view);
        using var copy = raw.sqlite3_backup_init(to.Handle, "main", from.Handle, "main");
        if (copy.IsInvalid)
        {
            SqliteException.ThrowExceptionForRC(raw.sqlite3_errcode(to.Handle), to.Handle);
        }

        int result;
        do
        {
            cancellation.ThrowIfCancellationRequested();
            result = raw.sqlite3_backup_step(copy, PagesAtOnce);
            long of = raw.sqlite3_backup_pagecount(copy);
            progress?.Report(new("copying the store", of - raw.sqlite3_backup_remaining(copy), of));
        }
        while (result == raw.SQLITE_OK);
        if (result != raw.SQLITE_DONE)
        {
            SqliteException.ThrowExceptionForRC(result, to.Handle);
        }
    }

    /// <summary>Checks each page of a database.</summary>
    /// <returns>The problem; <c>ok</c> if there is none.</returns>
    /// <exception cref="OperationCanceledException">Canceled before all of it was checked.</exception>
    public static string Check(SqliteConnection database, CancellationToken cancellation)
    {
        using var interrupt = cancellation.UnsafeRegister(_ => raw.sqlite3_interrupt(database.Handle), null);
        try
        {
            return database.Value<string>("PRAGMA quick_check(1)")!;
        }
        catch (SqliteException) when (cancellation.IsCancellationRequested)
        {
            throw new OperationCanceledException(cancellation);
        }
    }
}
