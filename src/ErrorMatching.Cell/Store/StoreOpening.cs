namespace ErrorMatching.Cell;

/// <summary>Opens, creates and restores the databases of stores.</summary>
internal static class StoreOpening
{
    /// <summary>Opens a database with the current schema, or creates it; rows without codes get theirs.</summary>
    public static CellDatabase ToWrite(StoreSettings settings, TimeProvider clock, byte[]? auditKey, bool inspect) => Connect(
        settings,
        opened =>
        {
            if (inspect) opened.Inspect();
            Migrations.Apply(opened, clock, auditKey);
            if (auditKey is not null) RowCoding.Give(opened, clock, auditKey);
        });

    /// <summary>Opens a database for reading, even if it cannot be written.</summary>
    public static CellDatabase ToRead(StoreSettings settings, TimeProvider clock, byte[]? auditKey) => Connect(
        settings,
        opened =>
        {
            Migrations.Apply(opened, clock, auditKey);
            try
            {
                if (auditKey is not null) RowCoding.Give(opened, clock, auditKey);
            }
            catch (StoreException e) when (e.Error == StoreError.ReadOnly)
            {
                // It is read as it is.
            }
        },
        toRead: true);

    /// <summary>Opens the database of a store.</summary>
    /// <param name="settings">Where it is.</param>
    /// <param name="prepare">Checks its integrity and migrates it to the wanted schema.</param>
    /// <param name="toRead">True if the database need not be writable.</param>
    public static CellDatabase Connect(StoreSettings settings, Action<CellDatabase> prepare, bool toRead = false)
    {
        CellDatabase database = settings switch
        {
            SqliteSettings sqlite => SqliteDatabase.Open(sqlite.File, prepare, toRead),
            PostgresSettings postgres => PostgresDatabase.Open(postgres, prepare),
            _ => throw new ArgumentOutOfRangeException(nameof(settings), settings, "No such kind of store."),
        };
        database.ArchiveFolder = settings.ArchiveFolder;
        return database;
    }

    /// <summary>True if there is a store whose audit trail is sealed with a key.</summary>
    public static bool IsSealed(StoreSettings settings)
    {
        if (settings is SqliteSettings { File: var file } && !File.Exists(file)) return false;
        using var database = Connect(settings, _ => { }, toRead: true);
        return database.Read(
            connection => database.HasTable(connection, "audit_head") && AuditRow.Head(connection, null, "").Seal is not null);
    }

    /// <summary>Restores a backup in place of a database.</summary>
    /// <returns>The file with the replaced database; null if there was none.</returns>
    /// <exception cref="StoreException">With <see cref="StoreError.Locked"/> or <see cref="StoreError.NotSupported"/>.</exception>
    public static string? Restore(
        StoreSettings settings,
        string backup,
        TimeProvider clock,
        byte[]? auditKey,
        IProgress<CellProgress>? progress,
        CancellationToken cancellation) => settings is SqliteSettings sqlite
        ? SqliteRestore.Restore(sqlite.File, backup, opened => Migrations.Apply(opened, clock, auditKey), progress, cancellation)
        : throw new StoreException(
            StoreError.NotSupported,
            "A store on PostgreSQL is restored by its own tools: createdb, then pg_restore --exit-on-error --dbname=NAME FILE.");
}
