namespace ErrorMatching.Cell;

/// <summary>Reports every few seconds that the cell runs and what prevents it from working.</summary>
internal sealed class HeartbeatWorker(CellFlow flow, Action? alive)
{
    private readonly DateTimeOffset _since = flow.Clock.GetUtcNow();

    /// <summary>Reports once.</summary>
    public Task<TimeSpan> WorkAsync(CancellationToken stop)
    {
        stop.ThrowIfCancellationRequested();
        alive?.Invoke();
        Try(
            "signs of life",
            () => new Heartbeat(Environment.ProcessId, _since, flow.Clock.GetUtcNow(), flow.Troubles.Open)
            {
                Machines = flow.Machines.Machines,
                Waiting = flow.Machines.Waiting,
                Backlog = flow.Backlogs.All,
            }.Write(flow.Settings.LogFolder));
        return Task.FromResult(flow.Pace.Heartbeat);
    }

    // A full disk for logs is reported as a trouble. It must not slow the heartbeat, or the cell would look dead and be killed.
    private void Try(string what, Action work)
    {
        try
        {
            work();
            flow.Troubles.End(what);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            if (flow.Troubles.Begin(what, CellCodes.NotKept, e.Message))
            {
                flow.Log.Warning("{What}: {Message}", what, e.Message);
            }
        }
    }
}
