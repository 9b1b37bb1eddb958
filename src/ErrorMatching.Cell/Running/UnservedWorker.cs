namespace ErrorMatching.Cell;

/// <summary>Reports corrections that wait for a gauge, job or slot that is no longer in the configuration: no worker would process them,
/// and in a line they would silently block those after them.</summary>
internal sealed class UnservedWorker(CellFlow flow)
{
    private const string Where = "configuration";

    /// <summary>Checks once.</summary>
    /// <returns>How long to wait before looking again.</returns>
    public Task<TimeSpan> WorkAsync(CancellationToken stop)
    {
        stop.ThrowIfCancellationRequested();
        var unserved = flow.Store.Corrections.Waiting()
            .Select(w => (Waiting: w, Lacks: Lacks(w)))
            .Where(w => w.Lacks is not null)
            .OrderBy(w => w.Waiting.First)
            .ToArray();
        if (unserved.Length == 0)
        {
            flow.Troubles.End(Where);
        }
        else if (Sentence(unserved) is var sentence && flow.Troubles.Begin(Where, CellCodes.NotConfigured, sentence))
        {
            flow.Log.Warning("{Where}: {Message}", Where, sentence);
        }

        return Task.FromResult(flow.Idle);
    }

    // What is missing for a waiting correction; null if nothing is. In a store of several cells it may belong to another cell: then neither
    // its gauge nor its machine is one of this cell's.
    private string? Lacks(WaitingCorrections waiting)
    {
        var (hasGauge, hasMachine) = (flow.Gauges.Contains(waiting.Gauge), flow.Settings.Machines.Any(m => m.Name == waiting.Machine));
        if (flow.Settings.Store.IsShared && !hasGauge && !hasMachine)
        {
            return null;
        }

        return CorrectionSteps.Of(waiting.State).TakenBy switch
        {
            StateWorker.Recognize => hasGauge ? null : $"gauge \"{waiting.Gauge}\"",
            StateWorker.Compute or StateWorker.Propose when !flow.Jobs.Contains(waiting.Job!) =>
                $"job \"{waiting.Job}\"",
            _ when !flow.Settings.Machines.Any(m => m.Name == waiting.Machine && m.Slots.Any(s => s.Name == waiting.Slot)) =>
                $"slot \"{waiting.Slot}\" of \"{waiting.Machine}\"",
            _ => null,
        };
    }

    private string Sentence((WaitingCorrections Waiting, string? Lacks)[] unserved)
    {
        var (first, lacks) = unserved[0];
        var count = unserved.Sum(u => u.Waiting.Count);
        var who = count == 1
            ? FormattableString.Invariant($"Correction {first.First}")
            : FormattableString.Invariant($"{count} corrections, the first is {first.First}");
        var line = first.Slot is null ? "" : $" What is behind in the line of slot {first.Slot} of {first.Machine} waits with it.";
        return $"{who} ({first.State.ToString().ToLowerInvariant()}): nobody takes it up, for {flow.Settings.File} does not have the "
            + $"{lacks} any more.{line} Bring it back into the configuration; then reject what is not to be sent.";
    }
}
