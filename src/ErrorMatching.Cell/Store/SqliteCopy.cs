using Dapper;
using Microsoft.Data.Sqlite;
using SQLitePCL;

namespace ErrorMatching.Cell;

/// <summary>A copy of a SQLite database as it is at one moment, made while others go on writing. Source: sqlite.org/backup.html.</summary>
internal static class SqliteCopy
{
    private const int PagesAtOnce = 256;

    /// <summary>Copies all pages.</summary>
    /// <exception cref="SqliteException">One of the two cannot be read or written.</exception>
    /// <exception cref="OperationCanceledException">The copy is of no use.</exception>
    public static void Copy(SqliteConnection from, SqliteConnection to, IProgress<CellProgress>? progress, CancellationToken cancellation)
    {
        // What others write meanwhile stays out of this view; without it, each of their changes would make the copy begin again.
        using var view = from.BeginTransaction(deferred: true);
        from.QuerySingle<long>("SELECT count(*) FROM sqlite_master", transaction: view);
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

    /// <summary>Looks at each page of a database.</summary>
    /// <returns>What is wrong; <c>ok</c> if nothing is.</returns>
    /// <exception cref="OperationCanceledException">It was not looked at whole.</exception>
    public static string Check(SqliteConnection database, CancellationToken cancellation)
    {
        using var interrupt = cancellation.UnsafeRegister(_ => raw.sqlite3_interrupt(database.Handle), null);
        try
        {
            return database.QueryFirst<string>("PRAGMA quick_check(1)");
        }
        catch (SqliteException) when (cancellation.IsCancellationRequested)
        {
            throw new OperationCanceledException(cancellation);
        }
    }
}
