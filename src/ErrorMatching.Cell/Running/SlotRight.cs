namespace ErrorMatching.Cell;

/// <summary>The right of this process to change what a slot's machine has. It is a lease, which another process gets if this one falls
/// silent; so it is demanded again before each operation at the machine.</summary>
internal sealed class SlotRight(CellStore store, string machine, string slot)
{
    private ISlotLock? _held;

    /// <summary>True while this process has the right.</summary>
    public bool IsHeld => _held?.IsHeld == true;

    /// <summary>Takes the right until the result is disposed of.</summary>
    /// <returns>Null if another process, or another part of this one, has it.</returns>
    /// <exception cref="StoreException">The store cannot be used.</exception>
    public IDisposable? TryTake() => store.TryLockSlot(machine, slot) is { } held ? new Taken(this, _held = held) : null;

    /// <summary>Demands that this process still has the right.</summary>
    /// <exception cref="StoreException">With <see cref="StoreError.Away"/> if it does not.</exception>
    public void Demand()
    {
        if (!IsHeld)
            throw new StoreException(
                StoreError.Away, $"The right to send to slot {slot} of {machine} was lost with the connection to the store.");
    }

    private sealed class Taken(SlotRight right, ISlotLock held) : IDisposable
    {
        public void Dispose()
        {
            right._held = null;
            held.Dispose();
        }
    }
}
