using ErrorMatching.Json;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Watches the program of a taken slot until the machine reports that the piece is cut. The program is read again all the time,
/// for the piece cut next is assumed to be cut by it. A difference is stored and reported as a trouble and in the audit trail; the report
/// ends when the program is back or a person decides.</summary>
/// <param name="flow">State shared by the workers.</param>
/// <param name="place">The slot.</param>
/// <param name="listing">The folder's listing, for ready files.</param>
internal sealed class HeldProgram(CellFlow flow, SlotPlace place, MachineListing listing)
{
    private const string Missing = "missing";
    private readonly string _where = CellTrouble.OfProgram(place.Machine.Name, place.Slot.Name);
    private (long Id, string? Program) _of;
    private long _readAt;
    private string? _told;
    private (long Id, CorrectionState State) _seen;
    private long _seenAt;
    private long _nextReady;

    // True if the last read found another program in the slot.
    private bool IsChanged => _told is not null;

    /// <summary>The slot was just verified to hold a correction's program.</summary>
    public void Begin(Correction verified)
    {
        FoundAsVerified(verified.Id, verified.ProgramSha256);
        _nextReady = 0;
    }

    /// <summary>The slot is no longer held: someone decided.</summary>
    public void End()
    {
        _told = null;
        if (flow.Troubles.End(_where))
        {
            flow.Log.Information("{Where}: works again", _where);
        }
    }

    /// <summary>Reads the program if it is time to, and looks whether the machine reports that the piece is cut, which frees the
    /// slot.</summary>
    /// <param name="held">The correction that has the slot.</param>
    /// <param name="holding">What the slot holds.</param>
    /// <param name="stop">Cancels immediately.</param>
    /// <returns>How long to wait before looking again.</returns>
    /// <exception cref="TransportException">The machine cannot be read.</exception>
    public async Task<TimeSpan> WatchAsync(Correction held, SlotHolding holding, CancellationToken stop)
    {
        var program = held.State == CorrectionState.Verified ? held.ProgramSha256 : holding.ProgramSha256;
        var wait = Wait(held.Id, program);
        if (wait == TimeSpan.Zero)
        {
            // With the slot's lock: a revert in progress changes the program too, and must not be reported as a foreign change.
            using var taken = place.Right.TryTake();
            if (taken is null)
            {
                return flow.Pace.Locked;
            }

            if (flow.Store.Find(held.Id)!.Version != held.Version)
            {
                return TimeSpan.Zero;
            }

            await ReadAsync(held, program, stop);
            wait = flow.Pace.Held;
        }

        // A piece cut with a changed program is not the correction's, whatever the machine reports.
        return Shorter(wait, IsChanged ? flow.Idle : await LookForReadyAsync(held, program, stop));
    }

    // How long until the next read; zero if it has not been read yet.
    private TimeSpan Wait(long id, string? program) =>
        _of == (id, program) && flow.Clock.GetElapsedTime(_readAt) is var since && since < flow.Pace.Held
            ? flow.Pace.Held - since
            : TimeSpan.Zero;

    // Reads the program. True if it is the right one.
    private async Task<bool> ReadAsync(Correction held, string? program, CancellationToken cancellation)
    {
        var found = await place.Sender.CurrentAsync(place.Slot.Program, cancellation);
        if (found is null)
        {
            // A process that had the right before, was frozen and went on may have set it aside, where a server has no other way.
            await place.Sender.RecoverAsync(place.Slot.Program, cancellation);
            found = await place.Sender.CurrentAsync(place.Slot.Program, cancellation);
        }

        var hash = found is null ? null : ContentHash.Sha256(found);
        if (hash == program)
        {
            if (IsChanged)
            {
                var again = Recorded.HeldAgain.With(place.Slot.Program, place.Machine.Name, held.Id);
                flow.Store.Audit(CellFlow.ByCell, CellCodes.HeldAgain, again, Subject);
            }

            FoundAsVerified(held.Id, program);
            return true;
        }

        var changed = Recorded.ChangedWhileHeld.With(place.Slot.Program, place.Machine.Name, held.Id, hash ?? Missing);
        if (_of.Id != held.Id || _told != (hash ?? Missing))
        {
            // Stored first: what a person changed there may be gone a moment later.
            flow.Store.Audit(CellFlow.ByCell, CellCodes.ChangedAtMachine, changed, Subject, found);
        }

        (_of, _readAt, _told) = ((held.Id, program), flow.Clock.GetTimestamp(), hash ?? Missing);
        if (flow.Troubles.Begin(_where, CellCodes.ChangedAtMachine, changed))
        {
            flow.Log.Warning("{Where}: {Code}: {Message}", _where, CellCodes.ChangedAtMachine, changed.Sentence);
        }

        return false;
    }

    // The step comes first: a ready file that outlives it is stale, and is removed before the next program is sent.
    private async Task<TimeSpan> LookForReadyAsync(Correction held, string? program, CancellationToken stop)
    {
        if (place.Slot.ReadyFile is not { } ready)
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
        using var taken = place.Right.TryTake();
        if (taken is null)
        {
            return flow.Pace.Locked;
        }

        if (flow.Store.Slot(place.Machine.Name, place.Slot.Name).Correction != held.Id || flow.Store.Find(held.Id)!.Version != held.Version)
        {
            return TimeSpan.Zero;
        }

        if (!await ReadAsync(held, program, stop))
        {
            return TimeSpan.Zero;
        }

        var basis = Recorded.MachineWrote.With(ready);
        if (held.State == CorrectionState.Verified)
        {
            place.Step(flow, held, CorrectionState.Released, basis);
        }
        else
        {
            flow.Store.FreeSlot(place.Machine.Name, place.Slot.Name, held.Id, CellFlow.ByCell, basis);
        }

        if (place.Right.IsHeld) await place.Folder.DeleteAsync(ready, flow.Finish);

        return TimeSpan.Zero;
    }

    private void FoundAsVerified(long id, string? program)
    {
        (_of, _readAt) = ((id, program), flow.Clock.GetTimestamp());
        End();
    }

    private static TimeSpan Shorter(TimeSpan one, TimeSpan other) => one < other ? one : other;

    private Statement Subject => Recorded.Slot.With(place.Slot.Name, place.Machine.Name);
}

/// <summary>The names in a machine's folder, listed once for all slots that ask at about the same time, because a control cannot serve many
/// requests.</summary>
/// <param name="folder">The machine's folder.</param>
/// <param name="clock">The clock.</param>
/// <param name="age">Maximum age of a listing to be returned again.</param>
internal sealed class MachineListing(IMachineFolder folder, TimeProvider clock, TimeSpan age)
{
    private readonly Lock _gate = new();
    private Task<IReadOnlyList<string>>? _names;
    private long _begun;

    /// <summary>The names.</summary>
    /// <param name="notBefore">The listing must have started at this timestamp or later: earlier files must be ignored.</param>
    /// <param name="cancellation">Cancels the listing for all callers that wait for it.</param>
    /// <exception cref="TransportException">The machine cannot be listed.</exception>
    public Task<IReadOnlyList<string>> NamesAsync(long notBefore, CancellationToken cancellation)
    {
        lock (_gate)
        {
            if (_names is null || _names.IsFaulted || _names.IsCanceled || _begun < notBefore || clock.GetElapsedTime(_begun) >= age)
            {
                _begun = clock.GetTimestamp();
                _names = folder.ListAsync(cancellation);
            }

            return _names;
        }
    }
}
