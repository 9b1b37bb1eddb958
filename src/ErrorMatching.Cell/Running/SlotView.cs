namespace ErrorMatching.Cell;

/// <summary>What a slot's worker sees of its slot. While the store tells of every change, and told of none, nobody asks it again.</summary>
internal sealed class SlotView(CellFlow flow, MachineSettings machine, SlotSettings slot)
{
    private const long Unknown = -1;
    private long _count = Unknown;

    /// <summary>What the slot holds.</summary>
    public SlotHolding Holding { get; private set; } = new(machine.Name, slot.Name, null, null, null);

    /// <summary>The correction that has the slot; null if none has it.</summary>
    public Correction? Held { get; private set; }

    /// <summary>The first in line for the free slot; null if there is none.</summary>
    public Correction? First { get; private set; }

    /// <summary>Looks again.</summary>
    /// <exception cref="StoreException">The store cannot be used.</exception>
    public void Look()
    {
        var count = flow.Store.Database.IsPushed ? flow.Store.HeardOf() : Unknown;
        if (count != Unknown && count == _count) return;
        _count = Unknown;
        Holding = flow.Store.Slot(machine.Name, slot.Name);
        Held = Holding.Correction is { } id ? flow.Store.Find(id)! : null;
        First = Held is null ? FirstInLine() : null;
        _count = count;
    }

    // Only where the serial number decides, all others in line must be looked at.
    private Correction? FirstInLine() =>
        flow.Store.Corrections.FirstInLine(machine.Name, slot.Name) is not { } first ? null
        : IsInOrderOfSerial(first.Job!) ? SlotLine.First(flow.Store.Corrections.Line(machine.Name, slot.Name), IsInOrderOfSerial)
        : first;

    private bool IsInOrderOfSerial(string job) => flow.Settings.Jobs.FirstOrDefault(j => j.Name == job)?.InOrderOfSerial ?? false;
}
