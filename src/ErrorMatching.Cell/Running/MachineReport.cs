using System.Collections.Concurrent;
using System.Text.Json.Serialization;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>What a machine was doing when the running cell asked it last.</summary>
/// <param name="Machine">Its name.</param>
/// <param name="State">What it said. Its time is that of the cell's first answer of this kind, if the machine names none.</param>
public sealed record MachineReport(string Machine, MachineState State)
{
    /// <summary>Why the state is unknown, as it is recorded; null if it is known.</summary>
    public string? Why { get; init; }

    /// <summary>Why the state is unknown; null if it is known.</summary>
    [JsonIgnore]
    public Statement? Reason => Why is { } text ? Recorded.Read(text) : null;
}

/// <summary>An approved program that is not sent yet, because its machine must not be disturbed.</summary>
/// <param name="Machine">The machine.</param>
/// <param name="Slot">The slot.</param>
/// <param name="Correction">Number of the correction.</param>
/// <param name="Why">The reason as it is recorded.</param>
/// <param name="Since">Since when it waits.</param>
public sealed record WaitingDelivery(string Machine, string Slot, long Correction, string Why, DateTimeOffset Since)
{
    /// <summary>The reason as a statement.</summary>
    [JsonIgnore]
    public Statement Statement => Recorded.Read(Why);
}

/// <summary>What the machines of a running cell are doing, and which programs wait for them.</summary>
internal sealed class MachineReports(TimeProvider clock)
{
    private readonly ConcurrentDictionary<string, MachineReport> _machines = new(StringComparer.Ordinal);
    private readonly ConcurrentDictionary<(string Machine, string Slot), WaitingDelivery> _waiting = new();

    /// <summary>The machines that say what they are doing, by name.</summary>
    public IReadOnlyList<MachineReport> Machines => [.. _machines.Values.OrderBy(m => m.Machine, StringComparer.Ordinal)];

    /// <summary>The waiting programs, by machine and slot.</summary>
    public IReadOnlyList<WaitingDelivery> Waiting =>
        [.. _waiting.Values.OrderBy(w => w.Machine, StringComparer.Ordinal).ThenBy(w => w.Slot, StringComparer.Ordinal)];

    /// <summary>Notes what a machine said.</summary>
    /// <returns>True if it is not what it said before.</returns>
    public bool Note(string machine, MachineState state)
    {
        var before = _machines.GetValueOrDefault(machine)?.State;
        if (before?.IsLike(state) == true)
            return false;
        _machines[machine] = new(machine, state with { Since = state.Since ?? clock.GetUtcNow() }) { Why = state.Why?.Text };
        return true;
    }

    /// <summary>Notes that a program waits. The first reason is kept with its time; a later one replaces its words.</summary>
    /// <returns>The wait, and true if it is new or has another reason.</returns>
    public (WaitingDelivery Wait, bool IsNew) Begin(string machine, string slot, long correction, Reporting.Statement why)
    {
        var before = _waiting.GetValueOrDefault((machine, slot));
        var since = before?.Correction == correction ? before.Since : clock.GetUtcNow();
        var wait = new WaitingDelivery(machine, slot, correction, why.Text, since);
        _waiting[(machine, slot)] = wait;
        return (wait, before != wait);
    }

    /// <summary>Notes that nothing waits any more.</summary>
    /// <returns>True if something did.</returns>
    public bool End(string machine, string slot) => !_waiting.IsEmpty && _waiting.TryRemove((machine, slot), out _);
}

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
