using System.Globalization;
using System.Security.Cryptography;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Serves one slot: sends the next correction in line, and frees the slot when the machine reports that the piece is
/// cut.</summary>
/// <param name="flow">State shared by the workers.</param>
/// <param name="machine">The machine.</param>
/// <param name="slot">The slot.</param>
/// <param name="right">The right to change what the machine has.</param>
/// <param name="folder">The machine's program folder, which is changed with the right only.</param>
/// <param name="sender">Sends programs to the folder, and reads them.</param>
/// <param name="listing">The folder's listing, for ready files.</param>
/// <param name="originals">The original programs of the slot's jobs.</param>
/// <param name="names">What the control would call the slot's programs.</param>
/// <param name="delivery">Lets programs wait for the machine.</param>
internal sealed class SlotWorker(
    CellFlow flow, MachineSettings machine, SlotSettings slot, SlotRight right, IMachineFolder folder, ProgramSender sender,
    MachineListing listing, OriginalPrograms originals, SlotNames names, DeliveryWait delivery)
{
    private readonly SlotView _view = new(flow, machine, slot);
    private readonly HeldProgram _held = new(flow, machine, slot, sender);
    private readonly KnownPrograms _known = new(flow, machine, slot, originals);
    private (long Id, CorrectionState State) _seen;
    private long _seenAt;
    private long _nextReady;
    private bool _isInOrder;

    /// <summary>Processes the slot's pending work.</summary>
    /// <returns>How long to wait before looking again.</returns>
    public async Task<TimeSpan> WorkAsync(CancellationToken stop)
    {
        _view.Look();
        if (_view.Held is { } held)
        {
            if (held.State == CorrectionState.Uploading)
                return await UploadLockedAsync(held, stop);
            delivery.End();
            return await WatchAsync(held, _view.Holding, stop);
        }

        _held.End();

        if (_view.First is not { State: CorrectionState.Approved } first)
        {
            delivery.End();
            return flow.Idle;
        }

        // Before the slot is taken: a program that waits can still be rejected or replaced by a newer one.
        return await delivery.MustWaitAsync(first, stop) ? flow.Pace.Busy : await UploadLockedAsync(first, stop);
    }

    private async Task<TimeSpan> UploadLockedAsync(Correction correction, CancellationToken stop)
    {
        using var taken = right.TryTake();
        if (taken is null)
        {
            return flow.Pace.Locked;
        }

        // The previous owner of the lock may have taken a step meanwhile.
        if (flow.Store.Find(correction.Id)!.Version != correction.Version)
        {
            return TimeSpan.Zero;
        }

        if (flow.Store.Slot(machine.Name, slot.Name).Correction is { } holder && holder != correction.Id)
        {
            return TimeSpan.Zero;
        }

        stop.ThrowIfCancellationRequested();
        flow.DemandRecorded(correction);
        using var activity = CellTelemetry.Start("upload", correction);
        try
        {
            if (correction.State == CorrectionState.Uploading)
            {
                _isInOrder = false;
                await SendAsync(correction);
            }
            else if (await TakeAsync(correction) is { } uploading)
            {
                await SendAsync(uploading);
            }
        }
        catch (MachineBusyException e)
        {
            delivery.Forget();
            delivery.Note(correction, e.Statement);
            return flow.Pace.Busy;
        }

        delivery.End();
        return TimeSpan.Zero;
    }

    // Reads and stores the machine's current program, and takes the slot. Nothing is changed at the machine yet.
    private async Task<Correction?> TakeAsync(Correction approved)
    {
        if (RevertedBase.Of(flow, approved) is { } reverted)
        {
            Fail(Step(approved, CorrectionState.Uploading, Recorded.LookedAtBase.With()), CellCodes.BaseReverted, reverted.Reason);
            return null;
        }

        if (OffsetStep.TooLarge(flow.Store, approved) is { } tooLarge)
        {
            Fail(Step(approved, CorrectionState.Uploading, Recorded.LookedAtBase.With()), CorrectionCodes.OffsetStep, tooLarge);
            return null;
        }

        byte[]? found;
        (string Code, Statement Why)? named;
        try
        {
            found = await LookAsync(flow.Finish);
            named = await names.WhyNotAsync(approved, found, HashOf(found), flow.Finish);
        }
        catch (ChangedAtMachineException e)
        {
            Fail(Step(approved, CorrectionState.Uploading, Recorded.TriedToRead.With()), CellCodes.ChangedAtMachine, e.Statement,
                e.Found);
            return null;
        }
        catch (TransportException e) when (!e.IsWorthAnotherTry)
        {
            Fail(Step(approved, CorrectionState.Uploading, Recorded.TriedToRead.With()), CellCodes.Of(e.Error), e.Message);
            return null;
        }

        var hash = HashOf(found);
        var unknown = _known.WhyNot(found, hash, approved);
        var mayReplace = unknown is null && named is null;
        var uploading = Step(
            approved,
            CorrectionState.Uploading,
            hash is null ? Recorded.SlotEmpty.With() : Recorded.SlotHeld.With(hash),
            // Only the step that refuses an unknown program names it: if the process ends in between, the next one finds it unknown again.
            c => mayReplace ? c with { PreviousSha256 = hash } : c,
            mayReplace && found is not null ? [found] : null);
        if (mayReplace)
        {
            return uploading;
        }

        if (unknown is null && named is { } name)
        {
            // What was found is named if it is a person's to decide: approved again, it may be replaced.
            Fail(uploading, name.Code, name.Why, name.Why.Is(Recorded.NamedOtherwiseThere) ? found : null);
            return null;
        }

        Fail(uploading, CellCodes.ChangedAtMachine, unknown!, found);
        return null;
    }

    private async Task<byte[]?> LookAsync(CancellationToken cancellation)
    {
        if (!_isInOrder)
        {
            await sender.RecoverAsync(slot.Program, cancellation);
            _isInOrder = true;
        }

        return await sender.CurrentAsync(slot.Program, cancellation);
    }

    // The slot is taken. The machine may hold the old program, the new one, or what an interruption left of both.
    private async Task SendAsync(Correction uploading)
    {
        try
        {
            Verify(uploading, await SendOrFindAsync(uploading));
        }
        catch (ChangedAtMachineException e)
        {
            Fail(uploading, CellCodes.ChangedAtMachine, e.Statement, e.Found);
        }
        catch (MachineBusyException e) when (e.IsReplaced)
        {
            Fail(uploading, CellCodes.StartedMeanwhile, e.Statement);
        }
        catch (MachineBusyException e)
        {
            await GiveBackAsync(uploading, null, e.Statement, flow.Finish);
            throw;
        }
        catch (OperationCanceledException) when (flow.Finish.IsCancellationRequested)
        {
            using var soon = new CancellationTokenSource(flow.Pace.GiveBack, flow.Clock);
            await GiveBackAsync(uploading, null, Recorded.CellStopped.With(), soon.Token);
            throw;
        }
        catch (TransportException e)
        {
            await GiveBackAsync(uploading, e, e.Message, flow.Finish);
            if (e.IsWorthAnotherTry)
            {
                throw;
            }
        }
    }

    private async Task<Statement> SendOrFindAsync(Correction uploading)
    {
        if (!_isInOrder)
        {
            var found = await LookAsync(flow.Finish);
            var hash = HashOf(found);
            // If the old and the new program are the same, a ready file may still belong to the old one: then the program is sent again.
            if (hash == uploading.ProgramSha256 && hash != uploading.PreviousSha256)
            {
                return Recorded.HeldAfterCut.With();
            }

            if (hash != uploading.PreviousSha256)
            {
                throw new ChangedAtMachineException(found, Recorded.ChangedMeanwhile.With(slot.Program, machine.Name, hash ?? "missing"));
            }
        }

        right.Demand();

        // Again, for changes to the store since the slot was taken.
        flow.DemandRecorded(uploading);

        // From here on an interruption may leave any state.
        _isInOrder = false;
        if (slot.ReadyFile is { } ready)
        {
            // An existing ready file belongs to the previous program.
            await folder.DeleteAsync(ready, flow.Finish);
        }

        var program = flow.Store.Content(uploading.ProgramSha256!);
        var unseen = await sender.SendAsync(slot.Program, uploading.PreviousSha256, program,
            string.Create(CultureInfo.InvariantCulture, $"{uploading.Id}"), flow.Finish);
        _isInOrder = true;
        return unseen is null ? Recorded.ReadBack.With() : Recorded.ReadBackUnseen.With(unseen);
    }

    private void Verify(Correction uploading, Statement basis)
    {
        var verified = Step(uploading, CorrectionState.Verified, basis);
        CellTelemetry.Arrived(verified, flow.Clock.GetUtcNow());
        _held.IsAsVerified(verified.Id, verified.ProgramSha256);
        _nextReady = 0;
    }

    // After all attempts: recovers the slot if the machine can be reached, and gives it back if it then holds its previous program.
    // Otherwise the correction keeps the slot, and the next look continues.
    private async Task GiveBackAsync(Correction uploading, TransportException? cause, Statement basis, CancellationToken cancellation)
    {
        _isInOrder = false;
        byte[]? found;
        try
        {
            found = await LookAsync(cancellation);
        }
        catch (ChangedAtMachineException e)
        {
            Fail(uploading, CellCodes.ChangedAtMachine, e.Statement, e.Found);
            return;
        }
        catch (TransportException) when (cause is { IsWorthAnotherTry: false })
        {
            Fail(uploading, CellCodes.Of(cause.Error), Recorded.EitherProgram.With(cause.Message));
            return;
        }
        catch (Exception e) when (e is TransportException or MachineBusyException)
        {
            flow.Log.Debug(
                "slot {Machine}/{Slot}: keeps correction {Correction} while the machine cannot be looked at: {Message}",
                machine.Name,
                slot.Name,
                uploading.Id,
                e.Message);
            return;
        }

        var hash = HashOf(found);
        if (hash == uploading.ProgramSha256 && hash != uploading.PreviousSha256)
        {
            Verify(uploading, Recorded.HeldAfterCut.With());
        }
        else if (hash != uploading.PreviousSha256 && cause is not { Error: TransportError.Differs })
        {
            Fail(uploading, CellCodes.ChangedAtMachine, Recorded.ChangedMeanwhile.With(slot.Program, machine.Name, hash ?? "missing"),
                found);
        }
        else if (cause is null or { Error: TransportError.Away or TransportError.Slow })
        {
            Step(uploading, CorrectionState.Approved, Recorded.GivenBack.With(basis));
        }
        else if (cause is not null)
        {
            Fail(uploading, CellCodes.Of(cause.Error), basis);
        }
    }

    // What was seen at the machine is recorded only while no other process may have changed it.
    private Correction Step(
        Correction from, CorrectionState to, Statement basis, Func<Correction, Correction>? with = null,
        IReadOnlyList<ReadOnlyMemory<byte>>? contents = null)
    {
        right.Demand();
        return flow.Step(from, to, basis, with, contents);
    }

    private void Fail(Correction uploading, string code, Statement reason, byte[]? found = null) =>
        Step(
            uploading,
            CorrectionState.Failed,
            reason,
            c => c with { Code = code, Reason = reason, PreviousSha256 = found is null ? c.PreviousSha256 : HashOf(found) },
            found is null ? null : [found]);

    // A piece cut with a changed program is not the correction's, whatever the machine reports.
    private async Task<TimeSpan> WatchAsync(Correction held, SlotHolding holding, CancellationToken stop)
    {
        var program = held.State == CorrectionState.Verified ? held.ProgramSha256 : holding.ProgramSha256;
        var wait = _held.Wait(held.Id, program);
        if (wait == TimeSpan.Zero)
        {
            // With the slot's lock: a revert in progress changes the program too, and must not be reported as a foreign change.
            using var taken = right.TryTake();
            if (taken is null)
            {
                return flow.Pace.Locked;
            }

            if (flow.Store.Find(held.Id)!.Version != held.Version)
            {
                return TimeSpan.Zero;
            }

            await _held.ReadAsync(held, program, stop);
            wait = flow.Pace.Held;
        }

        return Shorter(wait, _held.IsChanged ? flow.Idle : await LookForReadyAsync(held, program, stop));
    }

    private static TimeSpan Shorter(TimeSpan one, TimeSpan other) => one < other ? one : other;

    // The step comes first: a ready file that outlives it is stale, and is removed before the next program is sent.
    private async Task<TimeSpan> LookForReadyAsync(Correction held, string? program, CancellationToken stop)
    {
        if (slot.ReadyFile is not { } ready)
        {
            return flow.Idle;
        }

        var now = flow.Clock.GetTimestamp();
        if (_seen != (held.Id, held.State))
        {
            // Only listings from now on show this program's ready file: the ready file was removed before the program was sent or restored.
            (_seen, _seenAt) = ((held.Id, held.State), now);
        }

        if (_nextReady > now)
        {
            return flow.Clock.GetElapsedTime(now, _nextReady);
        }

        var listed = await listing.NamesAsync(_seenAt, stop);
        _nextReady = flow.Clock.GetTimestamp() + (long)(flow.Pace.Ready.TotalSeconds * flow.Clock.TimestampFrequency);
        if (!listed.Contains(ready, StringComparer.Ordinal))
        {
            return flow.Pace.Ready;
        }

        // With the slot's lock: if another cell sent the next program before the file is removed, this would delete the ready file of the
        // next piece, and the slot would never become free.
        using var taken = right.TryTake();
        if (taken is null)
        {
            return flow.Pace.Locked;
        }

        if (flow.Store.Slot(machine.Name, slot.Name).Correction != held.Id || flow.Store.Find(held.Id)!.Version != held.Version)
        {
            return TimeSpan.Zero;
        }

        if (!await _held.ReadAsync(held, program, stop))
        {
            return TimeSpan.Zero;
        }

        var basis = Recorded.MachineWrote.With(ready);
        if (held.State == CorrectionState.Verified)
        {
            Step(held, CorrectionState.Released, basis);
        }
        else
        {
            flow.Store.FreeSlot(machine.Name, slot.Name, held.Id, CellFlow.ByCell, basis);
        }

        if (right.IsHeld) await folder.DeleteAsync(ready, flow.Finish);

        return TimeSpan.Zero;
    }

    private static string? HashOf(byte[]? bytes) => bytes is null ? null : Convert.ToHexStringLower(SHA256.HashData(bytes));
}
