using System.Globalization;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Serves one slot: takes the slot for the next correction in line, sends its program, and lets it be watched until the machine
/// reports that the piece is cut, which frees the slot.</summary>
/// <param name="flow">State shared by the workers.</param>
/// <param name="place">The slot.</param>
/// <param name="watched">Watches the program of the taken slot.</param>
/// <param name="known">Decides which programs may be replaced.</param>
/// <param name="names">What the control would call the slot's programs.</param>
/// <param name="delivery">Lets programs wait for the machine.</param>
internal sealed class SlotWorker(
    CellFlow flow, SlotPlace place, HeldProgram watched, KnownPrograms known, SlotNames names, DeliveryWait delivery)
{
    private readonly SlotView _view = new(flow, place);
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
            return await watched.WatchAsync(held, _view.Holding, stop);
        }

        watched.End();

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
        using var taken = place.Right.TryTake();
        if (taken is null)
        {
            return flow.Pace.Locked;
        }

        // The previous owner of the lock may have taken a step meanwhile.
        if (flow.Store.Find(correction.Id)!.Version != correction.Version)
        {
            return TimeSpan.Zero;
        }

        if (flow.Store.Slot(place.Machine.Name, place.Slot.Name).Correction is { } holder && holder != correction.Id)
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
            Fail(
                place.Step(flow, approved, CorrectionState.Uploading, Recorded.LookedAtBase.With()),
                CellCodes.BaseReverted,
                reverted.Reason);
            return null;
        }

        if (OffsetStep.TooLarge(flow.Store, approved) is { } tooLarge)
        {
            Fail(place.Step(flow, approved, CorrectionState.Uploading, Recorded.LookedAtBase.With()), CorrectionCodes.OffsetStep, tooLarge);
            return null;
        }

        byte[]? found;
        (string Code, Statement Why)? named;
        try
        {
            found = await LookAsync(flow.Finish);
            named = await names.WhyNotAsync(approved, found, ProgramSender.HashOf(found), flow.Finish);
        }
        catch (ChangedAtMachineException e)
        {
            Fail(
                place.Step(flow, approved, CorrectionState.Uploading, Recorded.TriedToRead.With()),
                CellCodes.ChangedAtMachine,
                e.Statement,
                e.Found);
            return null;
        }
        catch (TransportException e) when (!e.IsWorthAnotherTry)
        {
            Fail(place.Step(flow, approved, CorrectionState.Uploading, Recorded.TriedToRead.With()), CellCodes.Of(e.Error), e.Message);
            return null;
        }

        var hash = ProgramSender.HashOf(found);
        var unknown = known.WhyNot(found, hash, approved);
        var mayReplace = unknown is null && named is null;
        var uploading = place.Step(
            flow,
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
            await place.Sender.RecoverAsync(place.Slot.Program, cancellation);
            _isInOrder = true;
        }

        return await place.Sender.CurrentAsync(place.Slot.Program, cancellation);
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
            var hash = ProgramSender.HashOf(found);
            // If the old and the new program are the same, a ready file may still belong to the old one: then the program is sent again.
            if (hash == uploading.ProgramSha256 && hash != uploading.PreviousSha256)
            {
                return Recorded.HeldAfterCut.With();
            }

            if (hash != uploading.PreviousSha256)
            {
                throw new ChangedAtMachineException(found, ChangedMeanwhile(hash));
            }
        }

        place.Right.Demand();

        // Again, for changes to the store since the slot was taken.
        flow.DemandRecorded(uploading);

        // From here on an interruption may leave any state.
        _isInOrder = false;
        if (place.Slot.ReadyFile is { } ready)
        {
            // An existing ready file belongs to the previous program.
            await place.Folder.DeleteAsync(ready, flow.Finish);
        }

        var program = flow.Store.Content(uploading.ProgramSha256!);
        var unseen = await place.Sender.SendAsync(place.Slot.Program, uploading.PreviousSha256, program,
            string.Create(CultureInfo.InvariantCulture, $"{uploading.Id}"), flow.Finish);
        _isInOrder = true;
        return unseen is null ? Recorded.ReadBack.With() : Recorded.ReadBackUnseen.With(unseen);
    }

    private void Verify(Correction uploading, Statement basis)
    {
        var verified = place.Step(flow, uploading, CorrectionState.Verified, basis);
        CellTelemetry.Arrived(verified, flow.Clock.GetUtcNow());
        watched.Begin(verified);
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
                place.Machine.Name,
                place.Slot.Name,
                uploading.Id,
                e.Message);
            return;
        }

        var hash = ProgramSender.HashOf(found);
        if (hash == uploading.ProgramSha256 && hash != uploading.PreviousSha256)
        {
            Verify(uploading, Recorded.HeldAfterCut.With());
        }
        else if (hash != uploading.PreviousSha256 && cause is not { Error: TransportError.Differs })
        {
            Fail(uploading, CellCodes.ChangedAtMachine, ChangedMeanwhile(hash), found);
        }
        else if (cause is null or { Error: TransportError.Away or TransportError.Slow })
        {
            place.Step(flow, uploading, CorrectionState.Approved, Recorded.GivenBack.With(basis));
        }
        else if (cause is not null)
        {
            Fail(uploading, CellCodes.Of(cause.Error), basis);
        }
    }

    private Statement ChangedMeanwhile(string? found) =>
        Recorded.ChangedMeanwhile.With(place.Slot.Program, place.Machine.Name, found ?? "missing");

    private void Fail(Correction uploading, string code, Statement reason, byte[]? found = null) =>
        place.Step(
            flow,
            uploading,
            CorrectionState.Failed,
            reason,
            c => c with { Code = code, Reason = reason, PreviousSha256 = found is null ? c.PreviousSha256 : ProgramSender.HashOf(found) },
            found is null ? null : [found]);

}

/// <summary>What a slot's worker sees of its slot. A store that reports every change is read again only after it has reported
/// one.</summary>
internal sealed class SlotView(CellFlow flow, SlotPlace place)
{
    private const long Unknown = -1;
    private long _count = Unknown;

    /// <summary>What the slot holds.</summary>
    public SlotHolding Holding { get; private set; } = new(place.Machine.Name, place.Slot.Name, null, null, null);

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
        Holding = flow.Store.Slot(place.Machine.Name, place.Slot.Name);
        Held = Holding.Correction is { } id ? flow.Store.Find(id)! : null;
        First = Held is null ? FirstInLine() : null;
        _count = count;
    }

    // Only where the serial number decides, all others in line must be looked at.
    private Correction? FirstInLine() =>
        flow.Store.Corrections.FirstInLine(place.Machine.Name, place.Slot.Name) is not { } first
            ? null
            : IsInOrderOfSerial(first.Job!)
            ? SlotLine.First(flow.Store.Corrections.Line(place.Machine.Name, place.Slot.Name), IsInOrderOfSerial)
            : first;

    private bool IsInOrderOfSerial(string job) => flow.Settings.Jobs.FirstOrDefault(j => j.Name == job)?.InOrderOfSerial ?? false;
}
