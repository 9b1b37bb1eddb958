using System.Collections.Concurrent;

namespace ErrorMatching.Cell;

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
