namespace ErrorMatching.Cell.Tests;

/// <summary>A kind of store, as its tests need it.</summary>
public abstract class StoreKind : IDisposable
{
    /// <summary>A place for a store, where none is yet.</summary>
    public abstract StoreSettings NewSettings();

    /// <summary>True if several cells share a store.</summary>
    public abstract bool IsShared { get; }

    /// <summary>Lists the names of the tables.</summary>
    public abstract string TablesSql { get; }

    /// <summary>Removes what keeps the audit trail append-only.</summary>
    public abstract string RemoveTriggersSql { get; }

    public void Dispose()
    {
        Dispose(true);
        GC.SuppressFinalize(this);
    }

    protected virtual void Dispose(bool disposing)
    {
    }
}
