using System.Collections.Concurrent;
using System.Data.Common;
using System.Globalization;
using ErrorMatching.Json;
using Microsoft.Data.Sqlite;

namespace ErrorMatching.Cell;

/// <summary>A store in its own SQLite file, with a write-ahead log; every change is on disk before it is reported.</summary>
internal sealed class SqliteDatabase : CellDatabase
{
    internal const int ApplicationId = 0x45724D43;
    private const long WholeCheckBytes = 256 << 20;
    private const long QuickCheckBytes = 1L << 30;

    // What a cell acts on at once. The rest is in the audit trail, which is checked before anything is sent.
    private static readonly string[] Acting =
        ["slot", "person", "machine_secret", "audit_head", "audit_checkpoint", "migration", "sign_in_failure"];

    private readonly string _file;
    private readonly SqliteFileWatch _watch;
    private readonly Lock _writing = new();
    private readonly ConcurrentBag<SqliteConnection> _readers = [];
    private SqliteConnection? _writer;
    private bool _disposed;
    private int _losses;
    private StoreException? _readOnly;

    static SqliteDatabase() => SQLitePCL.Batteries_V2.Init();

    private SqliteDatabase(string file) => (_file, _watch) = (file, new(file, () => Seen));

    public override string Place => $"The store {_file}";

    protected override string ForUpdate => "";

    /// <summary>Opens a store, or creates it under another name first, so that it exists completely or not at all.</summary>
    /// <param name="file">Its file.</param>
    /// <param name="prepare">Checks its integrity and migrates it to the current schema.</param>
    /// <param name="toRead">True if the store need not be writable.</param>
    public static SqliteDatabase Open(string file, Action<CellDatabase> prepare, bool toRead = false)
    {
        var database = new SqliteDatabase(file);
        if (!File.Exists(file)) database.Make(prepare);
        return Prepared(database, d =>
        {
            d.Prove(toRead);
            prepare(d);
        });
    }

    public override string Like => "LIKE";

    public override string Word(string token, string argument) => WordOf(token, argument);

    public override AuditFault? FormFault(DbConnection connection, DbTransaction transaction) =>
        DatabaseForm.FaultOfFile(connection, transaction);

    /// <summary>Translates a migration's tokens for SQLite.</summary>
    internal static string WordOf(string token, string argument) => token switch
    {
        "blob" => "BLOB",
        "identity" => "INTEGER PRIMARY KEY AUTOINCREMENT",
        "append_only" => $"""
            CREATE TRIGGER {argument}_update BEFORE UPDATE ON {argument} BEGIN SELECT RAISE(ABORT, '{argument} is append-only'); END;
            CREATE TRIGGER {argument}_delete BEFORE DELETE ON {argument} BEGIN SELECT RAISE(ABORT, '{argument} is append-only'); END;
            """,
        _ => throw new ArgumentOutOfRangeException(nameof(token), token, "No such token of migrations."),
    };

    public override void Inspect() => Read(connection =>
    {
        var length = new FileInfo(_file).Length;
        foreach (var check in length <= WholeCheckBytes ? ["integrity_check(1)"]
            : length <= QuickCheckBytes ? ["quick_check(1)"]
            : Acting.Where(t => HasTable(connection, t)).Select(t => $"quick_check({t})"))
        {
            var found = connection.Value<string>($"PRAGMA {check}")!;
            if (found != "ok") throw SqliteFailure.Damaged(_file, found, null);
        }

        return true;
    });

    public override bool HasTable(DbConnection connection, string name) =>
        connection.Value<long>("SELECT count(*) FROM sqlite_master WHERE type = 'table' AND name = @name", [("name", name)]) == 1;

    public override void WaitForMigration(DbConnection connection, DbTransaction transaction)
    {
        // The writer's transaction is the lock.
    }

    public override ISlotLock? TryLock(string name)
    {
        var hash = ContentHash.Sha256OfText(name)[..16];
        return FileLock.TryTake(FileLock.NameBeside(_file, hash));
    }

    public override void Backup(string file, IProgress<CellProgress>? progress, CancellationToken cancellation)
    {
        if (Path.GetFullPath(file) == Path.GetFullPath(_file))
            throw new StoreException(StoreError.Denied, $"{file} is the store itself: name another file for its backup.");
        SqliteBackup.Write(file, temporary => Read(connection =>
        {
            using var copy = new SqliteConnection(ConnectionString(temporary));
            copy.Open();
            SqliteCopy.Copy((SqliteConnection)connection, copy, progress, cancellation);

            // A single file without a separate log.
            copy.Execute("PRAGMA journal_mode = DELETE");
            progress?.Report(new("looking at each page of the copy", 0, 0));
            var found = SqliteCopy.Check(copy, cancellation);
            return found == "ok" ? true : throw SqliteFailure.Damaged(_file, found, null);
        }));
    }

    public override void Dispose()
    {
        lock (_writing)
        {
            if (_disposed) return;
            _disposed = true;
            while (_readers.TryTake(out var reader)) reader.Dispose();
            try
            {
                _writer?.Execute("PRAGMA wal_checkpoint(TRUNCATE)");
            }
            catch (SqliteException)
            {
                // The log stays next to the file, and the next process that opens it continues from there.
            }

            _writer?.Dispose();
            _writer = null;
        }
    }

    protected override StoreException Name(DbException failure) =>
        failure is SqliteException sqlite
            ? SqliteFailure.Of(_file, sqlite)
            : new StoreException(StoreError.Unknown, $"{Place}: {failure.Message}", failure);

    protected override T InTransaction<T>(Func<DbConnection, DbTransaction, T> change)
    {
        lock (_writing)
        {
            ObjectDisposedException.ThrowIf(_disposed, this);
            if (_readOnly is not null) throw new StoreException(StoreError.ReadOnly, _readOnly.Message, _readOnly);
            _watch.Demand(_writing, Close);
            var writer = _writer ??= Connect();
            try
            {
                using var transaction = writer.BeginTransaction(deferred: false);
                var result = change(writer, transaction);
                transaction.Commit();

                // A change written to a file that has lost its name meanwhile is lost: the caller must not treat it as stored.
                if (!_watch.IsInPlace)
                {
                    throw new StoreException(
                        StoreError.Away, $"The store {_file} was taken away while a change was kept. Look again whether it was.");
                }

                return result;
            }
            catch (SqliteException)
            {
                // Its state is unknown: the next change opens a new one.
                _writer = null;
                writer.Dispose();
                throw;
            }
        }
    }

    protected override T OnReader<T>(Func<DbConnection, T> read)
    {
        ObjectDisposedException.ThrowIf(_disposed, this);
        _watch.Demand(_writing, Close);
        var losses = Volatile.Read(ref _losses);
        if (!_readers.TryTake(out var reader)) reader = Connect();
        try
        {
            return read(reader);
        }
        catch (SqliteException)
        {
            reader.Dispose();
            reader = null;
            throw;
        }
        finally
        {
            if (reader is not null)
            {
                if (_disposed || losses != Volatile.Read(ref _losses)) reader.Dispose();
                else _readers.Add(reader);
            }
        }
    }

    protected override DbTransaction BeginSnapshot(DbConnection connection) =>
        ((SqliteConnection)connection).BeginTransaction(deferred: true);

    private static string ConnectionString(string file) => new SqliteConnectionStringBuilder
    {
        DataSource = file,
        Mode = SqliteOpenMode.ReadWriteCreate,
        Pooling = false,
        ForeignKeys = true,
        DefaultTimeout = (int)Patience.TotalSeconds,
    }.ConnectionString;

    private void Close()
    {
        Interlocked.Increment(ref _losses);
        while (_readers.TryTake(out var reader)) reader.Dispose();
        _writer?.Dispose();
        _writer = null;
    }

    private SqliteConnection Connect() => _readOnly is not null ? ConnectToRead()
        : Prepared(new SqliteConnection(ConnectionString(_file)), connection =>
    {
        connection.Open();
        if (!_watch.IsInPlace)
        {
            throw new StoreException(StoreError.Away, $"The store {_file} was taken away while it was opened. Nothing was changed.");
        }

        connection.Execute(string.Create(CultureInfo.InvariantCulture, $"PRAGMA busy_timeout = {(long)Patience.TotalMilliseconds}"));
        connection.Execute("PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL");
    });

    // In a read-only folder SQLite has no place for its index of the log. Without a log and an index there is no writer, and the file is
    // complete. Source: sqlite.org/wal.html, read-only databases.
    private SqliteConnection ConnectToRead()
    {
        var isAlone = !File.Exists(_file + "-shm") && (new FileInfo(_file + "-wal") is { Exists: false } or { Length: 0 });
        var source = isAlone ? new Uri(Path.GetFullPath(_file)).AbsoluteUri + "?immutable=1" : _file;
        return Prepared(new SqliteConnection(
            new SqliteConnectionStringBuilder { DataSource = source, Mode = SqliteOpenMode.ReadOnly, Pooling = false }.ConnectionString),
            connection => connection.Open());
    }

    // A store contains password hashes: its owner decides who else may read it, not the umask. Its log gets the same permissions.
    internal static void MakeForOwner(string file)
    {
        var options = new FileStreamOptions { Mode = FileMode.Create, Access = FileAccess.Write };
        if (!OperatingSystem.IsWindows())
        {
            options.UnixCreateMode = UnixFileMode.UserRead | UnixFileMode.UserWrite;
        }

        using (new FileStream(file, options))
        {
        }
    }

    // A log without its file indicates a lost store, and would be read into a new one.
    private void Make(Action<CellDatabase> prepare)
    {
        var folder = Path.GetDirectoryName(Path.GetFullPath(_file))!;
        if (!Directory.Exists(folder))
            throw new StoreException(
                StoreError.Missing,
                $"The store's folder {folder} is not there. If there was a store, mount the disk that has it. If not, errormatch user add "
                    + "makes the folder and the store, with its first user.");
        if (File.Exists(_file + "-wal"))
            throw new StoreException(
                StoreError.Damaged, $"The store {_file} is gone but its log {_file}-wal is there. Restore the latest backup.");
        if (FileLock.Beside(_file).Any())
        {
            throw new StoreException(
                StoreError.Missing,
                $"The store {_file} is gone, and a cell ran with it. Restore the latest backup. Delete {_file}.*.lock if the cell is to "
                    + $"begin anew and know nothing of what it did.");
        }

        var temporary = $"{_file}.{Environment.ProcessId.ToString(CultureInfo.InvariantCulture)}.{Guid.NewGuid():N}.new";
        try
        {
            MakeForOwner(temporary);
            using (var made = new SqliteDatabase(temporary))
            {
                made.Change(
                    (connection, transaction) => connection.Execute(
                        string.Create(CultureInfo.InvariantCulture, $"PRAGMA application_id = {ApplicationId}"), transaction: transaction));
                prepare(made);
            }

            // If another process was faster, its store is just as good.
            _ = FirstFile.TryPut(temporary, _file);
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
        {
            throw new StoreException(StoreError.ReadOnly, $"No store can be made in {folder}: {failure.Message}", failure);
        }
        finally
        {
            File.Delete(temporary);
        }
    }

    // Finds files that SQLite would treat as a new, empty database, or would reject only on the first write. The database file itself must
    // never be opened here: where locks belong to processes, as on Linux, closing it would release SQLite's locks on it, and another
    // process would think it is the last one and delete the log.
    private void Prove(bool toRead)
    {
        if (new FileInfo(_file).Length == 0)
            throw new StoreException(StoreError.Damaged, $"The store {_file} is empty. Restore the latest backup.");
        try
        {
            using var probe = new FileStream(
                $"{_file}.{Guid.NewGuid():N}.probe", FileMode.CreateNew, FileAccess.Write, FileShare.None, 1, FileOptions.DeleteOnClose);
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
        {
            _readOnly = new StoreException(StoreError.ReadOnly, $"The folder of the store {_file} cannot be written: {failure.Message} "
                + $"Make the disk and the folder writable for the user that runs the cell.", failure);
        }

        if (_readOnly is null && Read(connection => SQLitePCL.raw.sqlite3_db_readonly(((SqliteConnection)connection).Handle, "main")) == 1)
        {
            _readOnly = new StoreException(StoreError.ReadOnly, $"The store {_file} cannot be written. Make the file writable for the "
                + $"user that runs the cell.");
        }

        if (_readOnly is not null && !toRead) throw _readOnly;

        var id = Read(connection => connection.Value<int>("PRAGMA application_id"));
        if (id != ApplicationId)
            throw new StoreException(StoreError.Foreign, $"{_file} is a database, but not of a cell. Name another file as the store.");
    }
}

/// <summary>Writes a file that is a copy of a store, completely or not at all.</summary>
internal static class SqliteBackup
{
    /// <summary>Writes a backup under another name first, flushes it to disk, and then gives it its name.</summary>
    /// <param name="file">The backup's file.</param>
    /// <param name="fill">Copies the store into an empty file.</param>
    /// <exception cref="StoreException">It was not written.</exception>
    public static void Write(string file, Action<string> fill)
    {
        var folder = Path.GetDirectoryName(Path.GetFullPath(file));
        if (!Directory.Exists(folder))
            throw new StoreException(StoreError.Missing, $"The backup {file} was not written: the folder {folder} is not there.");
        var temporary = $"{file}.{Environment.ProcessId.ToString(CultureInfo.InvariantCulture)}.tmp";
        try
        {
            SqliteDatabase.MakeForOwner(temporary);
            fill(temporary);
            using (var written = new FileStream(temporary, FileMode.Open, FileAccess.ReadWrite)) written.Flush(flushToDisk: true);
            SharedFile.Replace(temporary, file);
        }
        catch (StoreException failure) when (failure.Error is not StoreError.Damaged)
        {
            throw new StoreException(failure.Error, $"The backup {file} was not written: {failure.InnerException!.Message}", failure);
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
        {
            throw new StoreException(StoreError.Disk, $"The backup {file} was not written: {failure.Message}", failure);
        }
        finally
        {
            foreach (var end in (ReadOnlySpan<string>)["", "-journal", "-wal", "-shm"]) File.Delete(temporary + end);
        }
    }
}
