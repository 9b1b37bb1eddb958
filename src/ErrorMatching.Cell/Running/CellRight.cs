namespace ErrorMatching.Cell;

/// <summary>The right of this process to run a cell. One process at a time has it, and only one cell runs with a store that is not
/// shared.</summary>
/// <param name="settings">The configuration.</param>
/// <param name="store">The open store.</param>
/// <param name="clock">The clock.</param>
public sealed class CellRight(CellSettings settings, CellStore store, TimeProvider clock) : IDisposable
{
    /// <summary>How often a standby looks whether it can have the right.</summary>
    public static readonly TimeSpan StandbyEvery = TimeSpan.FromSeconds(2);

    // A process that was frozen looks at once when it goes on, and before each operation at a machine anyway.
    private static readonly TimeSpan Every = TimeSpan.FromSeconds(5);

    private ISlotLock? _cell;
    private ISlotLock? _store;

    /// <summary>Takes the right.</summary>
    /// <exception cref="StoreException">The store cannot be used.</exception>
    public RightToRun TryTake()
    {
        Dispose();
        _cell = store.TryLockCell(settings.Name);
        if (_cell is null) return RightToRun.OfOtherProcess;
        if (settings.Store.IsShared || (_store = store.TryLockStore()) is not null) return RightToRun.Taken;
        Dispose();
        return RightToRun.OfOtherCell;
    }

    /// <summary>Waits until this process no longer has the right. A right that was lost with its connection is taken again, if no other
    /// process was faster.</summary>
    /// <param name="cancellation">Ends the wait.</param>
    /// <exception cref="OperationCanceledException">It was ended.</exception>
    public async Task UntilLostAsync(CancellationToken cancellation)
    {
        while (true)
        {
            await Task.Delay(Every, clock, cancellation).ConfigureAwait(false);
            try
            {
                if (_cell?.IsHeld == true || TryTake() == RightToRun.Taken) continue;
            }
            catch (StoreException)
            {
                // The workers report it. Without the store nothing is sent, and nobody else is known to have the right.
                continue;
            }

            return;
        }
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        _store?.Dispose();
        _cell?.Dispose();
        (_cell, _store) = (null, null);
    }
}

/// <summary>Who has the right to run a cell.</summary>
public enum RightToRun
{
    /// <summary>This process.</summary>
    Taken,

    /// <summary>Another process, which runs the same cell.</summary>
    OfOtherProcess,

    /// <summary>Another cell, whose store this is.</summary>
    OfOtherCell,
}
