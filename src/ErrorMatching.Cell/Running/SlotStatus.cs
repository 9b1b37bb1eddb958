namespace ErrorMatching.Cell;

/// <summary>The status of a slot.</summary>
/// <param name="Machine">The machine.</param>
/// <param name="Slot">The slot.</param>
/// <param name="Holding">What it holds.</param>
/// <param name="Held">The correction that has it; null if it is free.</param>
/// <param name="Line">Its line, in the order in which corrections will be sent if nothing changes; they never overtake.</param>
public sealed record SlotStatus(
    MachineSettings Machine, SlotSettings Slot, SlotHolding Holding, Correction? Held, IReadOnlyList<Correction> Line)
{
    private const int MostNext = 5;

    /// <summary>What the machine was doing a moment ago; null if nothing says that, or the cell does not run.</summary>
    public MachineReport? Report { get; init; }

    /// <summary>The program that waits for the machine; null if none does, or the cell does not run.</summary>
    public WaitingDelivery? Delivery { get; init; }

    /// <summary>The length of the line.</summary>
    public int Waiting => Line.Count;

    /// <summary>The first of the line.</summary>
    public IReadOnlyList<Correction> Next => [.. Line.Take(MostNext)];

    /// <summary>The approved ones in line.</summary>
    public IReadOnlyList<Correction> Approved => [.. Line.Where(c => c.State == CorrectionState.Approved)];

    /// <summary>Those of <see cref="Approved"/> that wait for a decision about others before them, in line order.</summary>
    public IReadOnlyList<HeldUpCorrection> HeldUp
    {
        get
        {
            // The lists of what is before them are the beginnings of one list: a line may be long.
            Correction[] undecided = [.. Line.Where(c => c.IsUndecided)];
            var (held, before) = (new List<HeldUpCorrection>(), 0);
            foreach (var correction in Line)
            {
                before += correction.IsUndecided ? 1 : 0;
                if (correction.State == CorrectionState.Approved && before > 0)
                {
                    held.Add(new(correction, new ArraySegment<Correction>(undecided, 0, before)));
                }
            }

            return held;
        }
    }

    /// <summary>The corrections that must be decided before a correction can be sent: those before it in line that wait for a
    /// decision.</summary>
    /// <param name="id">Number of the correction.</param>
    /// <returns>In line order; none if the correction is not in this line.</returns>
    public IReadOnlyList<Correction> UndecidedBefore(long id) =>
        Line.Any(c => c.Id == id)
            ? [.. Line.TakeWhile(c => c.Id != id).Where(c => c.IsUndecided)]
            : [];

    internal static SlotStatus Of(
        CellSettings settings, MachineSettings machine, SlotSettings slot, CellStore store, Heartbeat? running)
    {
        var holding = store.Slot(machine.Name, slot.Name);
        return new(
            machine,
            slot,
            holding,
            holding.Correction is { } id ? store.Find(id) : null,
            SlotLine.Order(
                store.Corrections.Line(machine.Name, slot.Name), job => settings.Jobs.Any(j => j.Name == job && j.InOrderOfSerial)))
        {
            Report = running?.Machines.FirstOrDefault(m => m.Machine == machine.Name),
            Delivery = running?.Waiting.FirstOrDefault(w => w.Machine == machine.Name && w.Slot == slot.Name),
        };
    }
}

/// <summary>An approved correction that is not sent, because undecided ones precede it in line.</summary>
/// <param name="Correction">The correction.</param>
/// <param name="Behind">The corrections that hold it up, in line order: proposed ones, and ones that failed at the machine. At least
/// one.</param>
public sealed record HeldUpCorrection(Correction Correction, IReadOnlyList<Correction> Behind);
