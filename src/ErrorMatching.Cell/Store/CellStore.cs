using System.Data.Common;
using System.Globalization;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Stores everything that a cell knows: what arrived, its result, what each slot holds, and who did what. Each change is one
/// transaction that is on disk when the call returns; if the call throws, none of it is stored. Thread-safe, and other processes may have
/// the same store open.</summary>
/// <remarks>Every member throws a <see cref="StoreException"/> if the store cannot do it.</remarks>
public sealed class CellStore : IDisposable
{
    private readonly TimeProvider _clock;
    private readonly byte[]? _auditKey;

    private CellStore(CellDatabase database, TimeProvider clock, byte[]? auditKey)
    {
        Database = database;
        _clock = clock;
        _auditKey = auditKey;
        Corrections = new(database);
        Outside = new(database, auditKey);
    }

    /// <summary>The database, for tables of other parts of the cell.</summary>
    internal CellDatabase Database { get; }

    /// <summary>Reads corrections other than one by its number: by state, in line for a slot, and the latest of a job.</summary>
    public CorrectionQueries Corrections { get; }

    /// <summary>Detects changes that were made from outside the cell, and keeps checkpoints of the audit trail.</summary>
    internal OutsideChanges Outside { get; }

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
        return Opened(StoreOpening.ToWrite(settings, clock, auditKey, inspect), clock, auditKey);
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
        return Opened(StoreOpening.ToRead(settings, clock, auditKey), clock, auditKey);
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

    /// <summary>Stores a file that arrived as a new correction.</summary>
    /// <returns>The correction and whether it is new: the same arrival again returns the existing one.</returns>
    public (Correction Correction, bool IsNew) Archive(Arrival arrival)
    {
        ArgumentNullException.ThrowIfNull(arrival);
        var (sha256, packed) = StoredContent.Pack([arrival.Bytes])[0];
        return Write(transaction => ArrivalWriter.Archive(transaction, arrival, sha256, packed));
    }

    /// <summary>Records a file that is refused without being stored.</summary>
    /// <returns>The correction, refused immediately, and whether it is new: the same arrival again returns the existing one.</returns>
    internal (Correction Correction, bool IsNew) ArchiveUnread(UnreadArrival arrival)
    {
        ArgumentNullException.ThrowIfNull(arrival);
        return Write(transaction => ArrivalWriter.ArchiveUnread(transaction, arrival));
    }

    /// <summary>The content stored under a hash.</summary>
    /// <exception cref="StoreException">With <see cref="StoreError.Missing"/> if there is none, with <see cref="StoreError.Damaged"/> if it
    /// no longer has this hash, with <see cref="StoreError.Redrawn"/> if it is a page that this version of the program draws
    /// differently.</exception>
    public byte[] Content(string sha256) => StoredContent.Read(Database, sha256);

    /// <summary>True if content is stored under a hash.</summary>
    internal bool Keeps(string sha256) => StoredContent.Has(Database, sha256);

    /// <summary>A correction by its number; null if there is none.</summary>
    public Correction? Find(long id) => First(CorrectionRow.Select + " WHERE id = @id", CorrectionRow.Read, [("id", id)]);

    /// <summary>Searches the history for corrections.</summary>
    /// <returns>The latest matches, last arrival first.</returns>
    public IReadOnlyList<Correction> Search(HistoryQuery query)
    {
        ArgumentNullException.ThrowIfNull(query);
        return HistorySearch.Find(Database, query);
    }

    /// <summary>Counts the corrections that a search of the history finds, whatever its maximum.</summary>
    public long Count(HistoryQuery query)
    {
        ArgumentNullException.ThrowIfNull(query);
        return HistorySearch.Count(Database, query);
    }

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
        IReadOnlyList<ReadOnlyMemory<byte>>? contents = null) => Step(from, to, by, basis, with, contents, isPageOfReport: false);

    /// <summary>Takes one step. If <paramref name="isPageOfReport"/>, the page among the contents was drawn from the report among them by
    /// <see cref="ReportPages"/>, and only the report is stored.</summary>
    internal Correction Step(
        Correction from,
        CorrectionState to,
        string by,
        Statement basis,
        Func<Correction, Correction>? with,
        IReadOnlyList<ReadOnlyMemory<byte>>? contents,
        bool isPageOfReport)
    {
        ArgumentNullException.ThrowIfNull(from);
        CorrectionStepWriter.DemandAllowed(from, to);
        var wanted = CorrectionRow.Stored(with?.Invoke(from) ?? from);
        var kept = StoredContent.Pack(contents ?? [], wanted, isPageOfReport);
        return Write(transaction =>
        {
            foreach (var (sha256, content) in kept) StoredContent.Keep(transaction, sha256, content);
            return CorrectionStepWriter.Take(transaction, from, to, by, basis, wanted);
        });
    }

    /// <summary>Recalculates a correction that is not at its machine: its measurement becomes a new correction in the same place in line,
    /// and the old one ends. Both changes and their audit entries are one transaction.</summary>
    /// <param name="correction">The correction as it was read.</param>
    /// <param name="by">The user's name.</param>
    /// <param name="reason">Why, in a person's words; null if none are given.</param>
    /// <returns>The new correction, which is archived.</returns>
    /// <exception cref="StoreException">With <see cref="StoreError.Conflict"/> if someone else changed it first, or no step leads to its
    /// end.</exception>
    public Correction Recalculate(Correction correction, string by, string? reason)
    {
        ArgumentNullException.ThrowIfNull(correction);
        return Write(transaction => ArrivalWriter.Recalculate(transaction, correction, by, reason));
    }

    /// <summary>Changes made outside the cell, found by a quick check of users, slots, the first 500 corrections that have not ended, and
    /// the database schema. <c>audit verify</c> may find more.</summary>
    public IReadOnlyList<Statement> Tampered() => Outside.Find();

    /// <summary>Archives that contents were moved to and that are not in their folder, each in a sentence.</summary>
    public IReadOnlyList<string> MissingArchives() =>
    [
        .. Read($"SELECT DISTINCT source FROM content WHERE form = '{PackedContent.Archive}' ORDER BY source", r => r.TextOrNull(0))
            .Where(name => !ContentArchive.IsThere(Database.ArchiveFolder, name))
            .Select(name => ContentArchive.Missing(Database.ArchiveFolder, name)),
    ];

    /// <summary>What a slot holds.</summary>
    public SlotHolding Slot(string machine, string slot) =>
        First(SlotRow.Select, SlotRow.Read, [("Machine", machine), ("Slot", slot)]) ?? new SlotHolding(machine, slot, null, null, null);

    /// <summary>Frees a slot of the correction that has it, as after a revert. A slot that is free or that another correction has stays as
    /// it is.</summary>
    public void FreeSlot(string machine, string slot, long correction, string by, Statement basis) =>
        Write(transaction => SlotRow.Free(transaction, machine, slot, correction, by, basis));

    /// <summary>Takes the right to send to a slot; one process at a time can hold it.</summary>
    /// <returns>The right; null if another process has it.</returns>
    public ISlotLock? TryLockSlot(string machine, string slot) =>
        Database.TryLock(string.Create(CultureInfo.InvariantCulture, $"slot {machine.Length} {machine} {slot}"));

    /// <summary>Takes the right to run the cell of this name; one process at a time can hold it.</summary>
    /// <returns>The right; null if another process has it.</returns>
    public ISlotLock? TryLockCell(string cell) => Database.TryLock($"cell {cell}");

    /// <summary>Takes the right to be the one cell that runs with a store that is not shared.</summary>
    /// <returns>The right; null if another cell has it.</returns>
    public ISlotLock? TryLockStore() => Database.TryLock("store");

    /// <summary>Records an act that is not a step of a correction.</summary>
    /// <param name="who">The user's name, or <c>cell</c>.</param>
    /// <param name="what">What was done, in one word.</param>
    /// <param name="basis">The basis.</param>
    /// <param name="subject">What it was done to; null if nothing in particular.</param>
    public void Audit(string who, string what, Statement basis, Statement? subject = null) => Audit(who, what, basis, subject, null);

    /// <summary>Records an act that is not a step of a correction, and stores the content that its entry refers to by its hash.</summary>
    internal void Audit(string who, string what, Statement basis, Statement? subject, byte[]? content)
    {
        var kept = content is null ? [] : StoredContent.Pack([content]);
        Write(transaction =>
        {
            foreach (var (sha256, packed) in kept) StoredContent.Keep(transaction, sha256, packed);
            transaction.Audit(who, what, subject, basis);
            return true;
        });
    }

    /// <summary>Entries of the audit trail, in order.</summary>
    /// <param name="after">Returns entries after this number; 0 for the first.</param>
    /// <param name="most">Maximum number of entries.</param>
    public IReadOnlyList<AuditEntry> AuditEntries(long after, int most) =>
        Read(AuditRow.Select + " WHERE seq > @after ORDER BY seq LIMIT @most", AuditRow.Read, [("after", after), ("most", most)]);

    /// <summary>Searches the audit trail.</summary>
    /// <returns>The latest matches, last entry first.</returns>
    public IReadOnlyList<AuditEntry> SearchTrail(TrailQuery query)
    {
        ArgumentNullException.ThrowIfNull(query);
        return TrailSearch.Find(Database, query);
    }

    /// <summary>The end of the audit trail.</summary>
    public AuditHead AuditHead()
    {
        var head = Database.Read(connection => AuditRow.Head(connection, null, ""));
        Database.Saw(head);
        return head;
    }

    /// <summary>Verifies one snapshot of the audit trail with the key that the store was opened with.</summary>
    /// <returns>The first fault; null if every entry is as written and in its place, and none is missing.</returns>
    public AuditFault? VerifyAudit() => Database.Snapshot((connection, transaction) => AuditChain.Verify(
        Rows.Stream(connection, AuditRow.Select + " ORDER BY seq", AuditRow.Read, transaction: transaction),
        AuditRow.Head(connection, transaction, ""),
        _auditKey));

    /// <summary>A number that differs after any change: the number of the last audit entry.</summary>
    public long ChangeCount() => AuditHead().Seq;

    /// <summary>The latest <see cref="ChangeCount"/> that this process knows, cheap enough to be read all the time. A server reports
    /// changes, and is asked itself only every few seconds in case a report was lost.</summary>
    public long HeardOf() => Database.HeardOf();

    /// <summary>Writes a copy of the whole store as of one moment, while others continue to work.</summary>
    /// <param name="file">The copy, which appears complete or not at all.</param>
    /// <exception cref="StoreException">With <see cref="StoreError.NotSupported"/> for PostgreSQL, which has its own tools.</exception>
    public void Backup(string file) => Backup(file, null, CancellationToken.None);

    /// <summary>Writes a copy of the whole store as of one moment, while others continue to work, and reports progress.</summary>
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

    /// <summary>Restores a backup in place of the store, and reports progress. The backup is unchanged; the store that it replaces is kept
    /// next to it.</summary>
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
        var aside = StoreOpening.Restore(settings, backup, clock, auditKey, progress, cancellation);
        using var store = Open(settings, clock, auditKey);
        store.Audit(
            by,
            "restored",
            Recorded.FromBackup.With(Path.GetFileName(backup)),
            aside is null ? null : Recorded.StoredAside.With(Path.GetFileName(aside)));
        return aside;
    }

    /// <summary>Moves contents that nothing needs any more to archives, while the cell goes on. What was moved is still read from its
    /// archive.</summary>
    /// <param name="policy">Which contents.</param>
    /// <param name="by">The user's name; null to only look how much would be moved.</param>
    /// <param name="progress">Receives progress; null for no reports.</param>
    /// <param name="cancellation">Ends the work; everything that was not moved is still in the store.</param>
    /// <exception cref="StoreException">With <see cref="StoreError.NotSupported"/> if there is no folder for archives; with
    /// <see cref="StoreError.Locked"/> while another process does the same.</exception>
    public Thinned Thin(ThinPolicy policy, string? by, IProgress<CellProgress>? progress, CancellationToken cancellation) =>
        Thin(policy, by, _ => { }, progress, cancellation);

    /// <summary>Moves contents to archives, and calls back between two steps, where tests end the process.</summary>
    internal Thinned Thin(
        ThinPolicy policy, string? by, Action<string> at, IProgress<CellProgress>? progress, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(policy);
        var thinning = new Thinning(Database, _clock, _auditKey);
        return by is null ? thinning.Rehearse(policy) : thinning.Run(policy, by, at, progress, cancellation);
    }

    /// <summary>Runs a change with its audit entries, for tables of other parts of the cell.</summary>
    internal T Write<T>(Func<StoreTransaction, T> write) => Database.Write(_clock, _auditKey, write);

    /// <summary>The rows of one statement, for tables of other parts of the cell.</summary>
    internal IReadOnlyList<T> Read<T>(string sql, Func<DbDataReader, T> row, SqlArguments? parameters = null) =>
        Database.Read(connection => Rows.Query(connection, sql, row, parameters));

    /// <summary>The first row of one statement, for tables of other parts of the cell; null if there is none.</summary>
    internal T? First<T>(string sql, Func<DbDataReader, T> row, SqlArguments? parameters = null)
        where T : class => Database.Read(connection => Rows.First(connection, sql, row, parameters));

    /// <inheritdoc/>
    public void Dispose() => Database.Dispose();
}
