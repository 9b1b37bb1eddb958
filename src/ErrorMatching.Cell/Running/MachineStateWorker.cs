namespace ErrorMatching.Cell;

/// <summary>Asks a machine every few seconds what it is doing, for people to see. Whether a program may be replaced is asked again at that
/// moment.</summary>
internal sealed class MachineStateWorker(CellFlow flow, MachineSettings machine, ReplacementGuard guard)
{
    /// <summary>Asks once.</summary>
    public async Task<TimeSpan> WorkAsync(CancellationToken stop)
    {
        var state = await guard.AskAsync(stop);
        if (flow.Machines.Note(machine.Name, state))
        {
            flow.Log.Debug(
                "{Machine}: {Activity} {Program:l} {Message:l}", machine.Name, state.Activity, state.Named, state.Why?.Sentence ?? "");

            // A program may wait for just this.
            foreach (var slot in machine.Slots)
            {
                flow.OfSlot(machine.Name, slot.Name).Signal();
            }
        }

        return flow.Pace.State;
    }
}
