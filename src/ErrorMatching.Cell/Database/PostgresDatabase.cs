using System.Data;
using System.Data.Common;
using System.Diagnostics;
using System.Globalization;
using System.Net.Sockets;
using Npgsql;

namespace ErrorMatching.Cell;

/// <summary>A store on a PostgreSQL server, for several cells.</summary>
internal sealed class PostgresDatabase : CellDatabase
{
    private const long MigrationLock = 0x45724D4300000001;
    private const UnixFileMode OfOthers = UnixFileMode.GroupRead | UnixFileMode.OtherRead | UnixFileMode.GroupWrite
        | UnixFileMode.OtherWrite;

    // A change is over before the rights of a process that was frozen in it go to another one.
    private static readonly TimeSpan MostInChange = (PostgresLocks.Lease - PostgresLocks.SignOfLife) * 0.75;

    // With one for rights and one for news, a cell has four connections.
    private const int MostPooled = 2;

    private static readonly TimeSpan MostUnasked = TimeSpan.FromSeconds(5);
    private readonly PostgresSettings _settings;
    private readonly NpgsqlDataSource _source;
    private readonly string _single;
    private readonly PostgresLocks _locks;
    private readonly string _own = Guid.NewGuid().ToString("N");
    private readonly Lock _listening = new();
    private PostgresListener? _listener;
    private (long Seq, long Heard, long At) _heardOf;

    private PostgresDatabase(PostgresSettings settings)
    {
        _settings = settings;
        var connection = Connection(settings);
        connection.MaxPoolSize = MostPooled;

        // Nothing is set on a connection beyond its transaction.
        connection.NoResetOnClose = true;
        _source = NpgsqlDataSource.Create(connection);
        connection.Pooling = false;
        _single = connection.ConnectionString;
        connection.KeepAlive = (int)PostgresLocks.SignOfLife.TotalSeconds;
        connection.Options += string.Create(
            CultureInfo.InvariantCulture, $" -c idle_session_timeout={(long)PostgresLocks.Lease.TotalMilliseconds}");
        _locks = new(connection.ConnectionString, settings.Schema is { } schema ? $"schema {schema} " : "");
    }

    public override string Place => string.Create(
        CultureInfo.InvariantCulture,
        $"The store {_settings.Database}{(_settings.Schema is { } schema ? $" (schema {schema})" : "")} on "
            + $"{_settings.Host}:{_settings.Port}");

    public override bool IsPushed => _listener?.IsLive == true;

    private string Channel => "errormatch " + (_settings.Schema ?? "");

    protected override string ForUpdate => " FOR UPDATE";

    /// <summary>Opens a store in an existing database.</summary>
    /// <param name="settings">Where it is.</param>
    /// <param name="prepare">Checks its integrity and migrates it to the current schema.</param>
    public static PostgresDatabase Open(PostgresSettings settings, Action<CellDatabase> prepare) =>
        Prepared<PostgresDatabase>(new(settings), database =>
        {
            if (settings.Schema is { } schema) database.Make(schema);
            prepare(database);
        });

    public override long HeardOf()
    {
        lock (_listening)
        {
            _listener ??= new(_single, Channel, _own);
            if (_listener.IsLive && _listener.Heard == _heardOf.Heard && Stopwatch.GetElapsedTime(_heardOf.At) < MostUnasked)
                return _heardOf.Seq;
            var heard = _listener.Heard;
            return (_heardOf = (base.HeardOf(), heard, Stopwatch.GetTimestamp())).Seq;
        }
    }

    public override string Like => "ILIKE";

    public override string Word(string token, string argument) => token switch
    {
        "blob" => "BYTEA",
        "identity" => "BIGINT GENERATED ALWAYS AS IDENTITY PRIMARY KEY",
        "append_only" => $"""
            CREATE FUNCTION {Keeper(argument)}() RETURNS trigger LANGUAGE plpgsql AS $${KeeperBody(argument)}$$;
            CREATE TRIGGER {argument}_change BEFORE UPDATE OR DELETE OR TRUNCATE ON {argument}
                FOR EACH STATEMENT EXECUTE FUNCTION {Keeper(argument)}();
            """,
        _ => throw new ArgumentOutOfRangeException(nameof(token), token, "No such token of migrations."),
    };

    /// <summary>Name of the function that keeps a table append-only.</summary>
    internal static string Keeper(string table) => table + "_is_append_only";

    /// <summary>The body of that function.</summary>
    internal static string KeeperBody(string table) => $"BEGIN RAISE EXCEPTION '{table} is append-only'; END";

    public override AuditFault? FormFault(DbConnection connection, DbTransaction transaction) =>
        DatabaseForm.FaultOnServer(connection, transaction);

    public override void Inspect() => Read(connection =>
    {
        // The server checks its own files; hashes verify contents and the audit trail.
        if (connection.Value<string>("SHOW server_encoding") != "UTF8")
        {
            throw new StoreException(
                StoreError.NotSupported,
                $"{Place} cannot keep every text: make its database with createdb --encoding=UTF8 --template=template0.");
        }

        return connection.Value<string>("SHOW fsync") == "on"
            ? true
            : throw new StoreException(
                StoreError.NotSupported, $"{Place} forgets at a power cut what it has acknowledged: set fsync = on for its server.");
    });

    public override bool HasTable(DbConnection connection, string name) =>
        connection.Value<long>(
            "SELECT count(*) FROM pg_tables WHERE schemaname = current_schema() AND tablename = @name", [("name", name)]) == 1;

    public override void WaitForMigration(DbConnection connection, DbTransaction transaction) =>
        connection.Execute("SELECT pg_advisory_xact_lock(@MigrationLock)", [("MigrationLock", MigrationLock)], transaction);

    public override ISlotLock? TryLock(string name) => Named(() => _locks.TryTake(name));

    public override void Backup(string file, IProgress<CellProgress>? progress, CancellationToken cancellation) => throw new StoreException(
        StoreError.NotSupported,
        string.Create(
            CultureInfo.InvariantCulture,
            $"A store on PostgreSQL is backed up by its own tools: pg_dump --format=custom --host={_settings.Host} "
                + $"--port={_settings.Port} --username={_settings.User} --file={file} {_settings.Database}"));

    public override void Dispose()
    {
        _listener?.Dispose();
        _locks.Dispose();
        _source.Dispose();
    }

    // After the change, not within it: the server lets only one change that tells something finish at a time, in the whole cluster.
    protected override void Announce(AuditHead head)
    {
        lock (_listening)
        {
            if (head.Seq > _heardOf.Seq) _heardOf.Seq = head.Seq;
        }

        try
        {
            OnReader(connection => connection.Execute("SELECT pg_notify(@Channel, @_own)", [("Channel", Channel), ("_own", _own)]));
        }
        catch (DbException)
        {
            // The change is stored, and others find it when they look the next time.
        }
    }

    protected override T InTransaction<T>(Func<DbConnection, DbTransaction, T> change)
    {
        using var connection = _source.OpenConnection();
        using var transaction = connection.BeginTransaction(IsolationLevel.ReadCommitted);
        var result = change(connection, transaction);
        transaction.Commit();
        return result;
    }

    protected override T OnReader<T>(Func<DbConnection, T> read)
    {
        using var connection = _source.OpenConnection();
        return read(connection);
    }

    protected override T OnSecondReader<T>(Func<DbConnection, T> read)
    {
        using var connection = new NpgsqlConnection(_single);
        connection.Open();
        return read(connection);
    }

    // A view may be looked at for long, and keeps nobody waiting.
    protected override DbTransaction BeginSnapshot(DbConnection connection) => Prepared(
        connection.BeginTransaction(IsolationLevel.RepeatableRead),
        transaction => connection.Execute("SET LOCAL idle_in_transaction_session_timeout = 0", transaction: transaction));

    // To use a schema that is there, no right to make one is needed.
    private void Make(string schema)
    {
        if (Read(connection => connection.Value<long>(
            "SELECT count(*) FROM pg_namespace WHERE nspname = @schema", [("schema", schema)])) > 0) return;
        Change((connection, transaction) =>
        {
            WaitForMigration(connection, transaction);
            return connection.Execute($"CREATE SCHEMA IF NOT EXISTS \"{schema}\"", transaction: transaction);
        });
    }

    protected override StoreException Name(DbException failure)
    {
        var (error, words) = failure switch
        {
            PostgresException { SqlState: var state } => state switch
            {
                "53100" =>
                    (
                        StoreError.Full,
                        "has no room on its disk. Nothing was changed. Make room, then repeat what failed; a running cell repeats it by "
                            + "itself."),
                "25006" => (StoreError.ReadOnly, "takes no changes: it is a standby or set read-only. Nothing was changed."),
                "55P03" or "57014" or "40P01" =>
                    (StoreError.Locked, $"was held by another process for longer than {Patience.TotalSeconds} s. Nothing was changed."),
                "28000" or "28P01" or "42501" => (StoreError.Denied, $"does not let the user {_settings.User} in: {failure.Message}"),
                "3D000" => (StoreError.Missing, "is not there: make it with createdb."),
                "XX001" or "XX002" => (StoreError.Damaged, $"is damaged: {failure.Message} Restore the latest backup."),
                "58030" => (StoreError.Disk, $"reports an error of its disk: {failure.Message}"),
                "23503" => (StoreError.Missing, "does not have a content that is named. Nothing was changed."),
                _ when state.StartsWith("08", StringComparison.Ordinal)
                    || state.StartsWith("57P", StringComparison.Ordinal)
                    || state is "53300" or "25P03" =>
                    (StoreError.Away, $"does not answer: {failure.Message}"),
                _ => (StoreError.Unknown, $"says: {failure.Message}"),
            },
            NpgsqlException { InnerException: SocketException or IOException or TimeoutException } =>
                (StoreError.Away, $"does not answer: {failure.Message}"),
            NpgsqlException { IsTransient: true } => (StoreError.Away, $"does not answer: {failure.Message}"),
            _ => (StoreError.Unknown, $"says: {failure.Message}"),
        };

        // Other idle connections are dead too; the next call opens a new one.
        if (error == StoreError.Away) _source.Clear();
        return new StoreException(error, $"{Place} {words}", failure);
    }

    internal static NpgsqlConnectionStringBuilder Connection(PostgresSettings settings)
    {
        if (settings.PasswordFile is { } file)
        {
            if (!File.Exists(file)) throw new StoreException(StoreError.Missing, $"The store's password file {file} is not there.");
            if (!OperatingSystem.IsWindows() && (File.GetUnixFileMode(file) & OfOthers) != UnixFileMode.None)
            {
                throw new StoreException(StoreError.Denied, $"The store's password file {file} may be read by others: chmod 600.");
            }
        }

        return new NpgsqlConnectionStringBuilder
        {
            Host = settings.Host,
            Port = settings.Port,
            Database = settings.Database,
            Username = settings.User,
            Passfile = settings.PasswordFile,
            ApplicationName = "errormatch",
            Timeout = (int)Patience.TotalSeconds,
            CommandTimeout = 30,
            MaxAutoPrepare = 50,
            AutoPrepareMinUsages = 2,
            KeepAlive = 10,
            SearchPath = settings.Schema,
            Options = string.Create(
                CultureInfo.InvariantCulture,
                $"-c lock_timeout={(long)Patience.TotalMilliseconds} -c synchronous_commit=on -c tcp_keepalives_idle=10 -c "
                    + $"tcp_keepalives_interval=5 -c tcp_keepalives_count=3 -c idle_in_transaction_session_timeout="
                    + $"{(long)MostInChange.TotalMilliseconds}"),
        };
    }
}
