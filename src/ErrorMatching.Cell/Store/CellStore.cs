using System.Globalization;
using System.Security.Cryptography;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Stores everything that a cell knows: what arrived, its result, what each slot holds, and who did what. Each change is one
/// transaction that is on disk when the call returns; if the call throws, none of it is stored. Thread-safe, and other processes may have
/// the same store open.</summary>
/// <remarks>Every member throws a <see cref="StoreException"/> if the store cannot do it.</remarks>
public sealed partial class CellStore : IDisposable
{
    private readonly TimeProvider _clock;
    private readonly byte[]? _auditKey;

    private CellStore(CellDatabase database, TimeProvider clock, byte[]? auditKey)
    {
        Database = database;
        _clock = clock;
        _auditKey = auditKey;
        _ledger = new(auditKey);
    }

    /// <summary>The database, for tables of other parts of the cell.</summary>
    internal CellDatabase Database { get; }

    /// <summary>Opens a store, creates it if there is none, and migrates an earlier version to the current schema.</summary>
    /// <param name="settings">Where it is.</param>
    /// <param name="clock">Supplies the time of each change.</param>
    /// <param name="auditKey">Seals the end of the audit trail, so that removed entries are detected. Everyone who opens the store must use
    /// the same key. Null for no seal.</param>
    /// <param name="inspect">True to check every page of the file, as the running cell does at startup; false for a quick look while it
    /// runs.</param>
    public static CellStore Open(StoreSettings settings, TimeProvider clock, byte[]? auditKey = null, bool inspect = true)
    {
        ArgumentNullException.ThrowIfNull(settings);
        ArgumentNullException.ThrowIfNull(clock);
        var database = Connect(settings, opened =>
        {
            if (inspect) opened.Inspect();
            Migrations.Apply(opened, clock, auditKey);
            if (auditKey is not null) RowCodes.Give(opened, clock, auditKey);
        });
        return Opened(database, clock, auditKey);
    }

    /// <summary>Opens an existing store for reading, even if it cannot be written, as on a read-only mount. A writable store of an earlier
    /// version is migrated to the current schema.</summary>
    /// <param name="settings">Where it is.</param>
    /// <param name="clock">Supplies the time of each change.</param>
    /// <param name="auditKey">The key that seals the audit trail; null if it is not available.</param>
    /// <exception cref="StoreException">It cannot be read, or has an earlier schema and cannot be written.</exception>
    public static CellStore OpenToRead(StoreSettings settings, TimeProvider clock, byte[]? auditKey)
    {
        ArgumentNullException.ThrowIfNull(settings);
        ArgumentNullException.ThrowIfNull(clock);
        var database = Connect(
            settings,
            opened =>
            {
                Migrations.Apply(opened, clock, auditKey);
                try
                {
                    if (auditKey is not null) RowCodes.Give(opened, clock, auditKey);
                }
                catch (StoreException e) when (e.Error == StoreError.ReadOnly)
                {
                    // It is read as it is.
                }
            },
            toRead: true);
        return Opened(database, clock, auditKey);
    }

    // Entries that exist now must still exist later.
    private static CellStore Opened(CellDatabase database, TimeProvider clock, byte[]? auditKey)
    {
        var store = new CellStore(database, clock, auditKey);
        try
        {
            store.AuditHead();
            return store;
        }
        catch
        {
            store.Dispose();
            throw;
        }
    }

    /// <summary>True if there is a store whose audit trail is sealed with a key.</summary>
    internal static bool IsSealed(StoreSettings settings)
    {
        if (settings is SqliteSettings { File: var file } && !File.Exists(file)) return false;
        using var database = Connect(settings, _ => { }, toRead: true);
        return database.Read(
            connection => database.HasTable(connection, "audit_head") && AuditRow.Head(connection, null, "").Seal is not null);
    }

    /// <summary>Stores a file that arrived as a new correction.</summary>
    /// <returns>The correction and whether it is new: the same arrival again returns the existing one.</returns>
    public (Correction Correction, bool IsNew) Archive(Arrival arrival)
    {
        ArgumentNullException.ThrowIfNull(arrival);
        var sha256 = Sha256(arrival.Bytes.Span);
        return Write(transaction =>
        {
            if (Known(transaction, arrival.Key) is { } known) return (known, false);
            Keep(transaction, sha256, arrival.Bytes);
            return (
                Arrive(
                    transaction,
                    New(transaction, CorrectionState.Archived, arrival.Gauge, arrival.FileName, sha256, arrival.Bytes.Length) with
                    {
                        Trace = arrival.Trace
                    },
                    arrival.Key),
                true);
        });
    }

    /// <summary>Records a file that is refused without being stored.</summary>
    /// <returns>The correction, refused immediately, and whether it is new: the same arrival again returns the existing one.</returns>
    public (Correction Correction, bool IsNew) ArchiveUnread(UnreadArrival arrival)
    {
        ArgumentNullException.ThrowIfNull(arrival);
        return Write(transaction => Known(transaction, arrival.Key) is { } known
            ? (known, false)
            : (Arrive(
                transaction,
                New(transaction, CorrectionState.Refused, arrival.Gauge, arrival.FileName, arrival.Sha256, arrival.Length) with
                {
                    Code = arrival.Code,
                    Reason = arrival.Reason,
                    Trace = arrival.Trace
                },
                arrival.Key), true));
    }

    /// <summary>The content stored under a hash.</summary>
    /// <exception cref="StoreException">With <see cref="StoreError.Missing"/> if there is none, with <see cref="StoreError.Damaged"/> if it
    /// no longer has this hash.</exception>
    public byte[] Content(string sha256)
    {
        var bytes = First("SELECT bytes FROM content WHERE sha256 = @sha256", r => r.GetFieldValue<byte[]>(0), new { sha256 })
            ?? throw new StoreException(StoreError.Missing, $"{Database.Place} has no content {sha256}.");
        if (Sha256(bytes) != sha256)
        {
            throw new StoreException(
                StoreError.Damaged,
                $"{Database.Place} is damaged: content {sha256} is not what was kept, but {Sha256(bytes)}. Restore the latest backup.");
        }

        return bytes;
    }

    /// <summary>True if content is stored under a hash.</summary>
    internal bool Keeps(string sha256) =>
        First("SELECT sha256 FROM content WHERE sha256 = @sha256", r => r.GetString(0), new { sha256 }) is not null;

    /// <summary>A correction by its number; null if there is none.</summary>
    public Correction? Find(long id) => First(CorrectionRow.Select + " WHERE id = @id", CorrectionRow.Read, new { id });

    /// <summary>The corrections in any of the given states, in order of arrival.</summary>
    public IReadOnlyList<Correction> InState(params CorrectionState[] states) => states is []
        ? []
        : Read(CorrectionRow.Select + $" WHERE {CorrectionRow.IsIn("state", states)} ORDER BY id", CorrectionRow.Read);

    /// <summary>The steps of a correction, in order.</summary>
    public IReadOnlyList<CorrectionStep> StepsOf(long id) =>
        Read(
            "SELECT correction, from_state, to_state, at, who, basis FROM step WHERE correction = @id ORDER BY step.id",
            CorrectionRow.ReadStep,
            new { id });

    /// <summary>Takes one step. The correction, the step, the contents that it names, its slot and the audit entry are one
    /// transaction.</summary>
    /// <param name="from">The correction as it was read.</param>
    /// <param name="to">The state after.</param>
    /// <param name="by">The user's name, or <c>cell</c> for what the cell does by its policy.</param>
    /// <param name="basis">The basis.</param>
    /// <param name="with">Other changes; arrival, number, state, version and time belong to the store. Null for none.</param>
    /// <param name="contents">Contents to store by hash with this step; null for none.</param>
    /// <returns>The correction after the step.</returns>
    /// <exception cref="StoreException">With <see cref="StoreError.Conflict"/> if someone else changed it first or the step is not one of
    /// <see cref="CorrectionSteps"/>; with <see cref="StoreError.Missing"/> if the correction names content that is not stored.</exception>
    /// <exception cref="DuplicateCorrectionException">Another correction has this identity.</exception>
    /// <exception cref="SlotTakenException">Another correction has the slot that the step takes.</exception>
    public Correction Step(
        Correction from,
        CorrectionState to,
        string by,
        Statement basis,
        Func<Correction, Correction>? with = null,
        IReadOnlyList<ReadOnlyMemory<byte>>? contents = null)
    {
        ArgumentNullException.ThrowIfNull(from);
        if (!CorrectionSteps.Allows(from.State, to))
        {
            throw new StoreException(
                StoreError.Conflict,
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"Correction {from.Id} is {CorrectionRow.Word(from.State)}: from there no step leads to {CorrectionRow.Word(to)}."));
        }

        var kept = (contents ?? []).Select(c => (Sha256(c.Span), c)).ToArray();
        var wanted = CorrectionRow.Kept(with?.Invoke(from) ?? from);
        return Write(transaction =>
        {
            var after = wanted with
            {
                Id = from.Id,
                State = to,
                Version = from.Version + 1,
                Gauge = from.Gauge,
                FileName = from.FileName,
                ArrivedAt = from.ArrivedAt,
                ChangedAt = transaction.Now,
                MeasurementSha256 = from.MeasurementSha256,
                MeasurementBytes = from.MeasurementBytes,
                MeasuredAs = from.MeasuredAs,
            };
            foreach (var (sha256, bytes) in kept) Keep(transaction, sha256, bytes);
            if (after.Identity is { } identity && identity != from.Identity
                && transaction.Value<long?>(
                    "SELECT id FROM correction WHERE identity = @identity AND id <> @Id", new { identity, after.Id }) is { } existing)
            {
                throw new DuplicateCorrectionException(existing);
            }

            DemandKept(transaction, from, after);
            var code = transaction.CodeOf(CorrectionRow.Coded(after));
            if (transaction.Execute(CorrectionRow.Update, CorrectionRow.Parameters(after, from.State, code)) != 1)
            {
                throw Conflict(transaction, from, to);
            }

            SlotRow.Follow(transaction, from.State, after);
            Note(transaction, after, from.State, by, basis);
            return after;
        });
    }

    /// <summary>What a slot holds.</summary>
    public SlotHolding Slot(string machine, string slot) =>
        First(SlotRow.Select, SlotRow.Read, new { Machine = machine, Slot = slot }) ?? new SlotHolding(machine, slot, null, null, null);

    /// <summary>Frees a slot of the correction that has it, as after a revert. A slot that is free or that another correction has stays as
    /// it is.</summary>
    public void FreeSlot(string machine, string slot, long correction, string by, Statement basis) => Write(transaction =>
    {
        SlotRow.Demand(transaction, machine, slot);
        var freed = transaction.Execute(
            "UPDATE slot SET correction = NULL WHERE machine = @machine AND slot = @slot AND correction = @correction",
            new { machine, slot, correction });
        if (freed == 1)
        {
            SlotRow.Code(transaction, machine, slot);
            transaction.Audit(by, "freed", Recorded.Slot.With(slot, machine), basis);
        }

        return freed;
    });

    /// <summary>Takes the right to send to a slot; one process at a time can hold it.</summary>
    /// <returns>The right; null if another process has it.</returns>
    public ISlotLock? TryLockSlot(string machine, string slot) =>
        Database.TryLock(string.Create(CultureInfo.InvariantCulture, $"slot {machine.Length} {machine} {slot}"));

    /// <summary>Takes the right to run the cell of this name; one process at a time can hold it.</summary>
    /// <returns>The right; null if another process has it.</returns>
    public ISlotLock? TryLockCell(string cell) => Database.TryLock($"cell {cell}");

    /// <summary>A number that differs after any change: the number of the last audit entry.</summary>
    public long ChangeCount() => AuditHead().Seq;

    /// <summary>Writes a copy of the whole store as of one moment, while others continue to work.</summary>
    /// <param name="file">The copy, which appears complete or not at all.</param>
    /// <exception cref="StoreException">With <see cref="StoreError.NotSupported"/> for PostgreSQL, which has its own tools.</exception>
    public void Backup(string file) => Backup(file, null, CancellationToken.None);

    /// <summary>The same, with progress and cancellation.</summary>
    /// <param name="file">The copy, which appears complete or not at all.</param>
    /// <param name="progress">Receives progress; null for no reports.</param>
    /// <param name="cancellation">Cancels the copy and leaves nothing of it behind.</param>
    /// <exception cref="StoreException">With <see cref="StoreError.NotSupported"/> for PostgreSQL, which has its own tools.</exception>
    public void Backup(string file, IProgress<CellProgress>? progress, CancellationToken cancellation) =>
        Database.Backup(file, progress, cancellation);

    /// <summary>Restores a backup in place of the store. The backup is unchanged; the store that it replaces is kept next to it.</summary>
    /// <param name="settings">Where the store is; it need not exist.</param>
    /// <param name="backup">The backup's file.</param>
    /// <param name="clock">Supplies the time of the audit entry.</param>
    /// <param name="by">The user's name.</param>
    /// <param name="auditKey">The key for opening the store.</param>
    /// <returns>The file with the replaced store; null if there was none.</returns>
    /// <exception cref="StoreException">With <see cref="StoreError.Locked"/> while a cell is using the store; with
    /// <see cref="StoreError.NotSupported"/> for PostgreSQL, which has its own tools.</exception>
    public static string? Restore(StoreSettings settings, string backup, TimeProvider clock, string by, byte[]? auditKey = null) =>
        Restore(settings, backup, clock, by, auditKey, null, CancellationToken.None);

    /// <summary>The same, with progress and cancellation.</summary>
    /// <param name="settings">Where the store is; it need not exist.</param>
    /// <param name="backup">The backup's file.</param>
    /// <param name="clock">Supplies the time of the audit entry.</param>
    /// <param name="by">The user's name.</param>
    /// <param name="auditKey">The key for opening the store.</param>
    /// <param name="progress">Receives progress; null for no reports.</param>
    /// <param name="cancellation">Cancels the restore until the store has been replaced.</param>
    /// <returns>The file with the replaced store; null if there was none.</returns>
    /// <exception cref="StoreException">With <see cref="StoreError.Locked"/> while a cell is using the store; with
    /// <see cref="StoreError.NotSupported"/> for PostgreSQL, which has its own tools.</exception>
    public static string? Restore(
        StoreSettings settings,
        string backup,
        TimeProvider clock,
        string by,
        byte[]? auditKey,
        IProgress<CellProgress>? progress,
        CancellationToken cancellation)
    {
        if (settings is not SqliteSettings sqlite)
        {
            throw new StoreException(
                StoreError.NotSupported,
                "A store on PostgreSQL is restored by its own tools: createdb, then pg_restore --exit-on-error --dbname=NAME FILE.");
        }

        var aside = SqliteRestore.Restore(sqlite.File, backup, opened => Migrations.Apply(opened, clock, auditKey), progress, cancellation);
        using var store = Open(settings, clock, auditKey);
        store.Audit(
            by,
            "restored",
            Recorded.FromBackup.With(Path.GetFileName(backup)),
            aside is null ? null : Recorded.KeptAside.With(Path.GetFileName(aside)));
        return aside;
    }

    /// <summary>Opens the database of a store.</summary>
    /// <param name="settings">Where it is.</param>
    /// <param name="prepare">Checks its integrity and migrates it to the wanted schema.</param>
    /// <param name="toRead">True if the database need not be writable.</param>
    internal static CellDatabase Connect(StoreSettings settings, Action<CellDatabase> prepare, bool toRead = false) => settings switch
    {
        SqliteSettings sqlite => SqliteDatabase.Open(sqlite.File, prepare, toRead),
        PostgresSettings postgres => PostgresDatabase.Open(postgres, prepare),
        _ => throw new ArgumentOutOfRangeException(nameof(settings), settings, "No such kind of store."),
    };

    /// <summary>Runs a change with its audit entries, for tables of other parts of the cell.</summary>
    internal T Write<T>(Func<StoreTransaction, T> write) => Database.Write(_clock, _auditKey, write);

    /// <summary>The rows of one statement, for tables of other parts of the cell.</summary>
    internal IReadOnlyList<T> Read<T>(string sql, Func<System.Data.Common.DbDataReader, T> row, object? parameters = null) =>
        Database.Read(connection => Rows.Query(connection, sql, row, parameters));

    /// <summary>The first row of one statement, for tables of other parts of the cell; null if there is none.</summary>
    internal T? First<T>(string sql, Func<System.Data.Common.DbDataReader, T> row, object? parameters = null)
        where T : class => Database.Read(connection => Rows.First(connection, sql, row, parameters));

    /// <inheritdoc/>
    public void Dispose() => Database.Dispose();

    private static string Sha256(ReadOnlySpan<byte> bytes) => Convert.ToHexStringLower(SHA256.HashData(bytes));

    internal static void Keep(StoreTransaction transaction, string sha256, ReadOnlyMemory<byte> bytes) =>
        transaction.Execute(
            "INSERT INTO content (sha256, bytes) VALUES (@sha256, @Bytes) ON CONFLICT (sha256) DO NOTHING",
            new { sha256, Bytes = bytes.ToArray() });

    private static Correction? Known(StoreTransaction transaction, string key) =>
        transaction.First(CorrectionRow.Select + " WHERE arrival = @Arrival", CorrectionRow.Read, new { Arrival = KeyOf(key) });

    private static string KeyOf(string key) => Sha256(System.Text.Encoding.UTF8.GetBytes(key));

    private static Correction New(
        StoreTransaction transaction, CorrectionState state, string gauge, string fileName, string sha256, long length) =>
        new(0, state, 1, StoredText.Name(gauge), StoredText.Name(fileName), transaction.Now, sha256, length)
        {
            ChangedAt = transaction.Now
        };

    // Without a basis, the cell itself took it from its gauge.
    private static Correction Arrive(
        StoreTransaction transaction, Correction arriving, string key, string by = "cell", Statement? basis = null)
    {
        var arrived = CorrectionRow.Kept(arriving);
        var id = transaction.Value<long>(CorrectionRow.Insert, new
        {
            State = CorrectionRow.Word(arrived.State),
            Arrival = KeyOf(key),
            arrived.Gauge,
            arrived.FileName,
            At = StoredTime.Of(transaction.Now),
            arrived.MeasurementSha256,
            arrived.MeasurementBytes,
            arrived.Code,
            Reason = arrived.Reason?.Text,
            arrived.Trace,
            arrived.Job,
            arrived.Piece,
            arrived.Serial,
            arrived.WorkOrder,
            arrived.Machine,
            arrived.Slot,
            arrived.Program,
            arrived.MeasuredAs,
        });
        arrived = arrived with { Id = id };
        if (transaction.CodeOf(CorrectionRow.Coded(arrived)) is { } code) transaction.Execute(
            "UPDATE correction SET row_code = @code WHERE id = @id", new { code, id });
        Note(transaction, arrived, null, by, basis ?? arrived.Reason ?? Recorded.Arrived.With(arrived.Gauge, arrived.FileName));
        return arrived;
    }

    private static void Note(StoreTransaction transaction, Correction after, CorrectionState? from, string by, Statement basis)
    {
        transaction.Execute(
            "INSERT INTO step (correction, from_state, to_state, at, who, basis) VALUES (@Id, @From, @To, @At, @By, @Basis)",
            new
            {
                after.Id,
                From = from is { } f ? CorrectionRow.Word(f) : null,
                To = CorrectionRow.Word(after.State),
                At = StoredTime.Of(transaction.Now),
                By = StoredText.Name(by),
                Basis = StoredText.Of(basis).Text,
            });
        var subject = from is null
            ? Recorded.File.With(after.Id, after.MeasurementSha256)
            : after.ProgramSha256 is { } program
            ? Recorded.Program.With(after.Id, program)
            : Recorded.Correction.With(after.Id);
        transaction.Audit(by, CorrectionRow.Word(after.State), subject, basis);
    }

    private static StoreException Conflict(StoreTransaction transaction, Correction from, CorrectionState to)
    {
        var now = transaction.First(CorrectionRow.Select + " WHERE id = @Id", CorrectionRow.Read, new { from.Id });
        return now is null
            ? new StoreException(StoreError.Missing, string.Create(CultureInfo.InvariantCulture, $"There is no correction {from.Id}."))
            : new StoreException(
                StoreError.Conflict,
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"Correction {from.Id} was {CorrectionRow.Word(from.State)} and is {CorrectionRow.Word(now.State)} meanwhile: it "
                        + $"cannot become {CorrectionRow.Word(to)}. Look at it again."));
    }
}
