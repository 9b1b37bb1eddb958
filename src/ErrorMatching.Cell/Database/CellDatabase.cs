using System.Data.Common;

namespace ErrorMatching.Cell;

/// <summary>The operations in which the two kinds of database differ. Everything else is SQL that both understand.</summary>
internal abstract class CellDatabase : IDisposable
{
    /// <summary>How long to wait for another process to finish its change.</summary>
    public static readonly TimeSpan Patience = TimeSpan.FromSeconds(15);

    private const int MostTries = 1000;

    private readonly Lock _seeing = new();
    private volatile AuditHead? _seen;

    /// <summary>Describes the database in messages, such as by a file or server name.</summary>
    public abstract string Place { get; }

    /// <summary>The folder of the archives of contents; null if there is none.</summary>
    public string? ArchiveFolder { get; set; }

    /// <summary>Appended to the statement that reads the head of the audit trail: serializes the writers of all processes.</summary>
    protected abstract string ForUpdate { get; }

    /// <summary>The operator that compares a text with a pattern in any case.</summary>
    public abstract string Like { get; }

    /// <summary>Translates a migration's token, such as <c>{blob}</c>, for this engine.</summary>
    public abstract string Word(string token, string argument);

    /// <summary>Runs a change in a transaction, one at a time. An exception rolls it back.</summary>
    public T Change<T>(Func<DbConnection, DbTransaction, T> change) => Named(() => InTransaction(change));

    /// <summary>Runs a read-only operation.</summary>
    public T Read<T>(Func<DbConnection, T> read) => Named(() => OnReader(read));

    /// <summary>Runs a read of several statements on a single snapshot of the store.</summary>
    public T Snapshot<T>(Func<DbConnection, DbTransaction, T> read) => Read(connection =>
    {
        using var transaction = BeginSnapshot(connection);
        return read(connection, transaction);
    });

    /// <summary>Runs a read on two snapshots of the same state, on two connections for two cores. Every change moves the end of the audit
    /// trail, so two snapshots with the same end are of one state.</summary>
    /// <exception cref="StoreException">With <see cref="StoreError.Locked"/> if others change the store so often that no two views
    /// agree.</exception>
    public T TwoSnapshots<T>(Func<DbConnection, DbTransaction, DbTransaction, T> read)
    {
        for (var tries = 0; tries < MostTries; tries++)
        {
            var (agree, result) = Snapshot((one, first) => Named(() => OnSecondReader(two =>
            {
                using var second = BeginSnapshot(two);
                return AuditRow.Head(one, first, "") == AuditRow.Head(two, second, "") ? (true, read(one, first, second))
                    : (false, default(T));
            })));
            if (agree) return result!;
        }

        throw new StoreException(StoreError.Locked, $"{Place} changes too often to be looked at. Try again.");
    }

    /// <summary>Runs a change that includes audit entries.</summary>
    public T Write<T>(TimeProvider clock, byte[]? auditKey, Func<StoreTransaction, T> write)
    {
        var (result, head, isNew) = Change((connection, transaction) =>
        {
            var open = StoreTransaction.Begin(connection, transaction, ForUpdate, clock, auditKey);
            var (before, written) = (open.Head, write(open));
            var after = open.Finish();
            return (written, after, after != before);
        });
        Saw(head);
        if (isNew) Announce(head);
        return result;
    }

    /// <summary>The end of the audit trail when this process last saw it; null if it has not seen it.</summary>
    protected AuditHead? Seen => _seen;

    /// <summary>Remembers the end of the audit trail: a store that lacks this entry has been replaced.</summary>
    public void Saw(AuditHead head)
    {
        lock (_seeing)
        {
            _seen = _seen is { } before && before.Seq >= head.Seq ? before : head;
        }
    }

    /// <summary>True if the database tells this process of the changes of others, so that nobody needs to look for them.</summary>
    public virtual bool IsPushed => false;

    /// <summary>Number of the last audit entry as far as this process has heard of it; a change by another process may show some seconds
    /// later.</summary>
    public virtual long HeardOf() => Read(connection => AuditRow.Head(connection, null, "")).Seq;

    /// <summary>Tells other processes of a change that was stored.</summary>
    protected virtual void Announce(AuditHead head)
    {
    }

    /// <summary>Checks the database's integrity; throws a <see cref="StoreException"/> if it is damaged.</summary>
    public abstract void Inspect();

    /// <summary>A schema object that the migrations did not create, or one that is missing; null if there is none.</summary>
    public abstract AuditFault? FormFault(DbConnection connection, DbTransaction transaction);

    /// <summary>True if the database has a table with a given name.</summary>
    public abstract bool HasTable(DbConnection connection, string name);

    /// <summary>Makes later statements of this transaction wait for another process's migration.</summary>
    public abstract void WaitForMigration(DbConnection connection, DbTransaction transaction);

    /// <summary>Takes a lock that one process at a time can hold; null if another has it.</summary>
    public abstract ISlotLock? TryLock(string name);

    /// <summary>Writes a full copy while others continue to work.</summary>
    public abstract void Backup(string file, IProgress<CellProgress>? progress, CancellationToken cancellation);

    public abstract void Dispose();

    /// <summary>Translates a failure of this engine for a setter.</summary>
    protected abstract StoreException Name(DbException failure);

    protected abstract T InTransaction<T>(Func<DbConnection, DbTransaction, T> change);

    protected abstract T OnReader<T>(Func<DbConnection, T> read);

    /// <summary>Reads with a second connection, while another read of the same caller is in progress.</summary>
    protected virtual T OnSecondReader<T>(Func<DbConnection, T> read) => OnReader(read);

    protected abstract DbTransaction BeginSnapshot(DbConnection connection);

    /// <summary>Prepares a newly opened object. If that fails, disposes of it, since no caller has a reference to it.</summary>
    protected static T Prepared<T>(T opened, Action<T> prepare)
        where T : IDisposable
    {
        try
        {
            prepare(opened);
            return opened;
        }
        catch
        {
            opened.Dispose();
            throw;
        }
    }

    /// <summary>Runs an operation and translates the engine's exceptions.</summary>
    protected T Named<T>(Func<T> work)
    {
        try
        {
            return work();
        }
        catch (DbException failure)
        {
            throw Name(failure);
        }
    }
}

/// <summary>The right to send to a slot; one process at a time can hold it. It ends when disposed of, or with the process, however that
/// ends.</summary>
public interface ISlotLock : IDisposable
{
    /// <summary>Checks whether it is still held: a server may have gone away and given it to another cell.</summary>
    bool IsHeld { get; }
}

/// <summary>Progress of a long operation on a store.</summary>
/// <param name="Doing">What is being done, in a few words.</param>
/// <param name="Done">The amount done.</param>
/// <param name="Of">The total; 0 if unknown.</param>
public readonly record struct CellProgress(string Doing, long Done, long Of);
