namespace ErrorMatching.Cell;

/// <summary>How a slot is.</summary>
/// <param name="Machine">The machine.</param>
/// <param name="Slot">The slot.</param>
/// <param name="Holding">What it holds.</param>
/// <param name="Held">The correction that has it; null if it is free.</param>
/// <param name="Waiting">How many stand in line for it.</param>
/// <param name="Next">The first of them, as they will be sent.</param>
public sealed record SlotStatus(MachineSettings Machine, SlotSettings Slot, SlotHolding Holding, Correction? Held, int Waiting, IReadOnlyList<Correction> Next)
{
    private const int MostNext = 5;

    internal static SlotStatus Of(CellSettings settings, MachineSettings machine, SlotSettings slot, CellStore store)
    {
        var holding = store.Slot(machine.Name, slot.Name);
        var line = store.Line(machine.Name, slot.Name);
        return new(
            machine,
            slot,
            holding,
            holding.Correction is { } id ? store.Find(id) : null,
            line.Count,
            SlotLine.Order(line, job => settings.Jobs.Any(j => j.Name == job && j.InOrderOfSerial), MostNext));
    }
}
