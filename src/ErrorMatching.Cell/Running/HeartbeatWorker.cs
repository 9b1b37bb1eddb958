namespace ErrorMatching.Cell;

/// <summary>Says every few seconds that the cell runs and what keeps it from working.</summary>
internal sealed class HeartbeatWorker(CellFlow flow, Action? alive)
{
    private static readonly TimeSpan Remembering = TimeSpan.FromSeconds(30);
    private readonly DateTimeOffset _since = flow.Clock.GetUtcNow();
    private long _remembered = flow.Clock.GetTimestamp();

    /// <summary>Says so once.</summary>
    public Task<TimeSpan> WorkAsync(CancellationToken stop)
    {
        stop.ThrowIfCancellationRequested();
        alive?.Invoke();
        new Heartbeat(Environment.ProcessId, _since, flow.Clock.GetUtcNow(), flow.Troubles.Open).Write(flow.Settings.LogFolder);
        if (flow.Clock.GetElapsedTime(_remembered) > Remembering)
        {
            // The more often the end of the audit trail is remembered elsewhere, the less can be cut off unseen.
            new AuditTrail(flow.Store, flow.Settings.KeysFolder).Remember();
            _remembered = flow.Clock.GetTimestamp();
        }

        return Task.FromResult(flow.Pace.Heartbeat);
    }
}
