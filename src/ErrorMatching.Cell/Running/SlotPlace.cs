using ErrorMatching.Reporting;
using Polly;

namespace ErrorMatching.Cell;

/// <summary>A slot of a running cell, and what its worker needs to change what the machine has there.</summary>
/// <param name="Machine">The machine.</param>
/// <param name="Slot">The slot.</param>
/// <param name="Right">The right to change what the machine has.</param>
/// <param name="Folder">The machine's program folder, which is changed with the right only.</param>
/// <param name="Sender">Sends programs to the folder, and reads them.</param>
internal sealed record SlotPlace(
    MachineSettings Machine, SlotSettings Slot, SlotRight Right, IMachineFolder Folder, ProgramSender Sender)
{
    /// <summary>The place of a slot in a machine's open folder.</summary>
    /// <param name="store">The store, which gives the right.</param>
    /// <param name="machine">The machine.</param>
    /// <param name="slot">The slot.</param>
    /// <param name="folder">The machine's folder.</param>
    /// <param name="tries">Repeats transfers that fail.</param>
    /// <param name="guard">Keeps a program from being replaced while the machine runs it; null if the machine does not say what it
    /// does.</param>
    public static SlotPlace Of(
        CellStore store, MachineSettings machine, SlotSettings slot, IMachineFolder folder, ResiliencePipeline tries,
        ReplacementGuard? guard)
    {
        var right = new SlotRight(store, machine.Name, slot.Name);
        var fenced = new FencedFolder(folder, right.Demand);
        return new(machine, slot, right, fenced, new ProgramSender(fenced, store.Keeps, tries, guard));
    }

    /// <summary>Takes a step that says what was seen at the machine. It is recorded only while no other process may have changed
    /// that.</summary>
    /// <exception cref="StoreException">This process no longer has the right, or the store cannot be used.</exception>
    public Correction Step(
        CellFlow flow, Correction from, CorrectionState to, Statement basis, Func<Correction, Correction>? with = null,
        IReadOnlyList<ReadOnlyMemory<byte>>? contents = null)
    {
        Right.Demand();
        return flow.Step(from, to, basis, with, contents);
    }
}

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
