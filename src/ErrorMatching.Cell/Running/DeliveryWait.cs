using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Lets the programs of a slot wait while their machine must not be disturbed. A wait that is longer than its limit is a trouble;
/// the program still waits, and nothing is lost.</summary>
/// <param name="flow">State shared by the workers.</param>
/// <param name="place">The slot.</param>
/// <param name="guard">Says whether the machine may be disturbed; null if it does not say what it does.</param>
internal sealed class DeliveryWait(CellFlow flow, SlotPlace place, ReplacementGuard? guard)
{
    // How long a program that was read at the machine is not read again: a control that cuts should not be asked every second.
    private static readonly TimeSpan Memory = TimeSpan.FromMinutes(1);

    private readonly string _where = CellTrouble.OfDelivery(place.Machine.Name, place.Slot.Name);
    private (byte[]? Content, long At)? _there;

    /// <summary>Asks the machine whether the next program must wait.</summary>
    public async Task<bool> MustWaitAsync(Correction next, CancellationToken stop)
    {
        if (guard is null)
            return false;
        if (await guard.WhyNotAsync(place.Slot.Program, c => ContentsAsync(next, c), stop) is not { } why)
        {
            End();
            return false;
        }

        Note(next, why);
        return true;
    }

    // The machine may call the slot's program by what is in it, and by what is to be in it.
    private async Task<IReadOnlyCollection<ReadOnlyMemory<byte>?>> ContentsAsync(Correction next, CancellationToken stop)
    {
        if (_there is not { } there || flow.Clock.GetElapsedTime(there.At) > Memory)
        {
            try
            {
                there = (await place.Sender.CurrentAsync(place.Slot.Program, stop), flow.Clock.GetTimestamp());
            }
            catch (TransportException e) when (!e.IsWorthAnotherTry)
            {
                // The transfer fails with it.
                there = (null, flow.Clock.GetTimestamp());
            }

            _there = there;
        }

        return [MachinePrograms.Content(there.Content), flow.Store.Content(next.ProgramSha256!)];
    }

    /// <summary>A program waits.</summary>
    public void Note(Correction next, Statement why)
    {
        var (wait, isNew) = flow.Machines.Begin(place.Machine.Name, place.Slot.Name, next.Id, why);
        if (isNew)
            flow.Log.Information(
                "{Machine}/{Slot}: correction {Correction} waits: {Message:l}", place.Machine.Name, place.Slot.Name, next.Id, why.Sentence);
        if (place.Machine.State is { } settings && flow.Clock.GetUtcNow() - wait.Since >= settings.WaitLimit)
        {
            var late = Recorded.WaitsTooLong.With(next.Id, wait.Since, why);
            if (flow.Troubles.Begin(_where, CellCodes.WaitsTooLong, late))
            {
                flow.Store.Audit(CellFlow.ByCell, CellCodes.WaitsTooLong, late, Recorded.Slot.With(place.Slot.Name, place.Machine.Name));
                flow.Log.Warning("{Where}: {Code}: {Message:l}", _where, CellCodes.WaitsTooLong, late.Sentence);
            }
        }
    }

    /// <summary>The program at the machine may not be the one that was read.</summary>
    public void Forget() => _there = null;

    /// <summary>Nothing waits any more.</summary>
    public void End()
    {
        _there = null;
        if (flow.Machines.End(place.Machine.Name, place.Slot.Name))
            flow.Log.Information("{Machine}/{Slot}: the machine may get its program now", place.Machine.Name, place.Slot.Name);
        flow.Troubles.End(_where);
    }
}
