using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>Releases a correction after reading its program at the machine again: reporting a piece as cut also states which program cut
/// it. If the program has changed or cannot be read, the person must give a reason.</summary>
/// <param name="settings">The configuration.</param>
/// <param name="store">The store.</param>
/// <param name="open">Opens a machine's folder, such as by <see cref="MachineFolders.Open"/>.</param>
public sealed class SlotRelease(CellSettings settings, CellStore store, Func<MachineSettings, IMachineFolder> open)
{
    /// <summary>Records that the piece is cut, which frees the slot for the next.</summary>
    /// <param name="id">Number of the correction that has the slot.</param>
    /// <param name="by">The user's name.</param>
    /// <param name="reason">Why; null if no reason is given.</param>
    /// <param name="cancellation">Cancels the read; then nothing is released.</param>
    /// <exception cref="DecisionException">It cannot be released.</exception>
    /// <exception cref="TransportException">The program cannot be read, and no reason is given.</exception>
    public async Task<Correction> ReleaseAsync(long id, string by, string? reason, CancellationToken cancellation)
    {
        var decisions = new CorrectionDecisions(store);
        var held = decisions.Demand(id, "released", CorrectionSteps.Where(s => s.WaitsForRelease));
        var machine = settings.Machines.FirstOrDefault(m => m.Name == held.Machine);
        var holding = store.Slot(held.Machine!, held.Slot!);
        if (string.IsNullOrWhiteSpace(reason) && holding.Correction == id
            && machine?.Slots.FirstOrDefault(s => s.Name == held.Slot) is { } slot)
        {
            await DemandAsync(machine, slot, held, holding.ProgramSha256, cancellation);
        }

        return decisions.Release(id, by, reason);
    }

    private async Task DemandAsync(MachineSettings machine, SlotSettings slot, Correction held, string? program,
        CancellationToken cancellation)
    {
        using var folder = open(machine);
        var found = await new ProgramSender(folder, store.Keeps).CurrentAsync(slot.Program, cancellation);
        var hash = found is null ? null : ContentHash.Sha256(found);
        if (hash == program)
        {
            return;
        }

        var changed = Recorded.ChangedWhileHeld.With(slot.Program, machine.Name, held.Id, hash ?? "missing");
        store.Audit(CellFlow.ByCell, CellCodes.ChangedAtMachine, changed, Recorded.Slot.With(slot.Name, machine.Name), found);
        throw new DecisionException(DecisionException.ChangedAtMachine, changed.Sentence);
    }
}
