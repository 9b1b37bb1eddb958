using System.Data.Common;

namespace ErrorMatching.Cell;

/// <summary>What the two kinds of database do differently. Everything else is SQL that both understand.</summary>
internal abstract class CellDatabase : IDisposable
{
    /// <summary>How long one waits for another process to finish its change.</summary>
    public static readonly TimeSpan Patience = TimeSpan.FromSeconds(15);

    private readonly Lock _seeing = new();
    private volatile AuditHead? _seen;

    /// <summary>The database in a sentence, such as a file's name or a server's.</summary>
    public abstract string Place { get; }

    /// <summary>Appended to the statement that reads the head of the audit trail: puts the writers of all processes in one order.</summary>
    protected abstract string ForUpdate { get; }

    /// <summary>Puts this engine's words for the tokens of a migration, such as <c>{blob}</c>.</summary>
    public abstract string Word(string token, string argument);

    /// <summary>Runs what changes something as one transaction, one at a time. What it throws undoes it.</summary>
    public T Change<T>(Func<DbConnection, DbTransaction, T> change) => Named(() => InTransaction(change));

    /// <summary>Runs what only reads.</summary>
    public T Read<T>(Func<DbConnection, T> read) => Named(() => OnReader(read));

    /// <summary>Runs what reads more than one statement and must see one state of the store.</summary>
    public T Snapshot<T>(Func<DbConnection, DbTransaction, T> read) => Read(connection =>
    {
        using var transaction = BeginSnapshot(connection);
        return read(connection, transaction);
    });

    /// <summary>Runs a change that audit entries are part of.</summary>
    public T Write<T>(TimeProvider clock, byte[]? auditKey, Func<StoreTransaction, T> write)
    {
        var (result, head) = Change((connection, transaction) =>
        {
            var open = StoreTransaction.Begin(connection, transaction, ForUpdate, clock, auditKey);
            var written = write(open);
            return (written, open.Finish());
        });
        Saw(head);
        return result;
    }

    /// <summary>Where the audit trail ended when this process last saw it; null if it did not.</summary>
    protected AuditHead? Seen => _seen;

    /// <summary>Remembers how far the audit trail goes: a store that lacks this is another one.</summary>
    public void Saw(AuditHead head)
    {
        lock (_seeing)
        {
            _seen = _seen is { } before && before.Seq >= head.Seq ? before : head;
        }
    }

    /// <summary>Looks whether the database is whole; what is not is a <see cref="StoreException"/>.</summary>
    public abstract void Inspect();

    /// <summary>What is in the form of the database that the migrations did not make, or is not there; null if nothing.</summary>
    public abstract AuditFault? FormFault(DbConnection connection, DbTransaction transaction);

    /// <summary>True if the database has a table of a name.</summary>
    public abstract bool HasTable(DbConnection connection, string name);

    /// <summary>Makes the statements that follow in this transaction wait for another process that migrates.</summary>
    public abstract void WaitForMigration(DbConnection connection, DbTransaction transaction);

    /// <summary>Takes a lock that one process has at a time; null if another one has it.</summary>
    public abstract ISlotLock? TryLock(string name);

    /// <summary>Writes a whole copy while others go on working.</summary>
    public abstract void Backup(string file, IProgress<CellProgress>? progress, CancellationToken cancellation);

    /// <inheritdoc/>
    public abstract void Dispose();

    /// <summary>What a failure of this engine is for a setter.</summary>
    protected abstract StoreException Name(DbException failure);

    protected abstract T InTransaction<T>(Func<DbConnection, DbTransaction, T> change);

    protected abstract T OnReader<T>(Func<DbConnection, T> read);

    protected abstract DbTransaction BeginSnapshot(DbConnection connection);

    /// <summary>Prepares what was opened, and closes it again if that fails: nobody else could.</summary>
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

    /// <summary>Runs something and names what the engine throws.</summary>
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
