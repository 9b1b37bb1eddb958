using System.Globalization;
using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>Restores the program that a slot held before a correction, or sends the one that takes its offset back, and reads it back. The
/// slot stays taken until someone frees it: the person who reverted must check first.</summary>
/// <param name="settings">The configuration.</param>
/// <param name="store">The store.</param>
/// <param name="open">Opens a machine's folder, such as by <see cref="MachineFolders.Open"/>.</param>
/// <param name="clock">The clock.</param>
public sealed class SlotReversal(CellSettings settings, CellStore store, Func<MachineSettings, IMachineFolder> open, TimeProvider clock)
{
    private const int Tries = 20;
    private static readonly TimeSpan Pause = TimeSpan.FromMilliseconds(100);

    /// <summary>Reverts a correction whose program the slot holds.</summary>
    /// <param name="id">Its number.</param>
    /// <param name="by">The user's name.</param>
    /// <param name="reason">Why.</param>
    /// <param name="cancellation">Cancels the operation; the slot then holds the correction's program or the previous one, complete, and
    /// the same call continues from there.</param>
    /// <exception cref="DecisionException">It cannot be reverted.</exception>
    /// <exception cref="TransportException">The machine did not accept the program.</exception>
    public async Task<Correction> RevertAsync(long id, string by, string reason, CancellationToken cancellation)
    {
        var decisions = new CorrectionDecisions(store);
        var correction = decisions.Demand(id, "reverted", CorrectionSteps.Before(CorrectionState.Reverted));
        if (correction.RevertedSha256 is not { } previous)
        {
            throw new DecisionException(
                DecisionException.NothingBefore,
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"{correction.Slot} of {correction.Machine} was empty before correction {id}: there is no program to bring back."));
        }

        var machine = settings.Machines.FirstOrDefault(m => m.Name == correction.Machine);
        var slot = machine?.Slots.FirstOrDefault(s => s.Name == correction.Slot);
        if (machine is null || slot is null)
        {
            throw new DecisionException(
                DecisionException.WrongState,
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"Slot {correction.Slot} of {correction.Machine} is not in {settings.File} any more: bring it back there first."));
        }

        // The correction's row names the program to restore.
        store.Outside.DemandRecorded(correction);
        var right = new SlotRight(store, machine.Name, slot.Name);
        using var taken = await LockAsync(right, cancellation)
            ?? throw new DecisionException(
                DecisionException.SlotTaken,
                FormattableString.Invariant(
                    $"A program is being sent to slot {slot.Name} of {machine.Name} just now: try again in a moment."));
        if (store.Slot(machine.Name, slot.Name).Correction is { } holder && holder != id)
        {
            throw new DecisionException(
                DecisionException.SlotTaken,
                FormattableString.Invariant(
                    $"Correction {holder} has slot {slot.Name} of {machine.Name}: revert or release that one first."));
        }

        if (store.Slot(machine.Name, slot.Name).ProgramSha256 != correction.ProgramSha256)
        {
            throw new DecisionException(
                DecisionException.WrongState,
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"Slot {slot.Name} of {machine.Name} holds a later program than that of correction {id}: revert that one."));
        }

        try
        {
            using var folder = open(machine);
            await BringBackAsync(new FencedFolder(folder, right.Demand), machine, slot, correction, previous, by, reason, cancellation);
        }
        catch (ChangedAtMachineException e)
        {
            throw new DecisionException(DecisionException.ChangedAtMachine, e.Message);
        }
        catch (MachineBusyException e)
        {
            throw new DecisionException(e.IsReplaced ? DecisionException.StartedMeanwhile : DecisionException.MachineBusy, e.Message);
        }

        return decisions.Step(correction, CorrectionState.Reverted, by, reason, c => c with { Code = "reverted", Reason = reason });
    }

    private async Task BringBackAsync(
        FencedFolder folder,
        MachineSettings machine,
        SlotSettings slot,
        Correction correction,
        string previous,
        string by,
        string reason,
        CancellationToken cancellation)
    {
        var guard = ReplacementGuard.Of(machine, clock);
        var sender = new ProgramSender(folder, store.Keeps, TransferTries.For(machine, clock), guard);
        await sender.RecoverAsync(slot.Program, cancellation);
        var there = await sender.CurrentAsync(slot.Program, cancellation);
        var found = there is null ? null : ContentHash.Sha256(there);
        if (found != correction.ProgramSha256 && found != previous)
        {
            throw new DecisionException(
                DecisionException.ChangedAtMachine,
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"{slot.Program} at {machine.Name} is not the program of correction {correction.Id} but {found ?? "missing"}: "
                        + $"somebody changed it. Look at it; what was there before the correction is in the store, for errormatch cell "
                            + $"show "
                        + $"{correction.Id} --out."));
        }

        if (guard is not null && found != previous)
        {
            await guard.DemandAsync(
                slot.Program, [MachinePrograms.Content(there), store.Content(previous)], cancellation);
        }

        if (slot.ReadyFile is { } ready)
        {
            // It belongs to the program that is being reverted.
            await folder.DeleteAsync(ready, cancellation);
        }

        if (found == previous)
        {
            // An earlier call was interrupted after this.
            return;
        }

        // Before anything changes at the machine: if this is interrupted, the trail names the person who started it.
        store.Audit(by, "reverting", reason, Recorded.Correction.With(correction.Id));
        var unseen = await sender.SendAsync(slot.Program, found, store.Content(previous),
            FormattableString.Invariant($"revert{correction.Id}"), cancellation);
        if (unseen is not null)
        {
            store.Audit(by, CellCodes.ReadBackUnseen, Recorded.ReadBackUnseen.With(unseen), Recorded.Correction.With(correction.Id));
        }
    }

    // A worker that has just sent a program holds the slot a moment longer than the store shows.
    private async Task<IDisposable?> LockAsync(SlotRight right, CancellationToken cancellation)
    {
        for (var tries = Tries; ; tries--)
        {
            if (right.TryTake() is { } held)
            {
                return held;
            }

            if (tries == 0)
            {
                return null;
            }

            await Task.Delay(Pause, clock, cancellation);
        }
    }
}
