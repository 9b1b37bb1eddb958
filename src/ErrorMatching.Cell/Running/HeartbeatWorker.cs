namespace ErrorMatching.Cell;

/// <summary>Reports every few seconds that the cell runs and what prevents it from working.</summary>
internal sealed class HeartbeatWorker(CellFlow flow, Action? alive)
{
    private static readonly TimeSpan Remembering = TimeSpan.FromSeconds(30);
    private readonly DateTimeOffset _since = flow.Clock.GetUtcNow();
    private long _remembered = flow.Clock.GetTimestamp();

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
        if (flow.Clock.GetElapsedTime(_remembered) > Remembering)
        {
            // The more often the trail's end is remembered elsewhere, the less can be cut off unnoticed.
            Try("end of the audit trail", () => new AuditTrail(flow.Store, flow.Settings.KeysFolder).Remember());
            _remembered = flow.Clock.GetTimestamp();
        }

        return Task.FromResult(flow.Pace.Heartbeat);
    }

    // A full disk for logs or keys is reported as a trouble. It must not slow the heartbeat, or the cell would look dead and be killed.
    private void Try(string what, Action work)
    {
        try
        {
            work();
            flow.Troubles.End(what);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or PeopleException or StoreException)
        {
            if (flow.Troubles.Begin(what, CellCodes.NotKept, e.Message))
            {
                flow.Log.Warning("{What}: {Message}", what, e.Message);
            }
        }
    }
}
