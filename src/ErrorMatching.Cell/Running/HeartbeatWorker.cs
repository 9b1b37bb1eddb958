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
        Try("signs of life", () => new Heartbeat(Environment.ProcessId, _since, flow.Clock.GetUtcNow(), flow.Troubles.Open).Write(flow.Settings.LogFolder));
        if (flow.Clock.GetElapsedTime(_remembered) > Remembering)
        {
            // The more often the end of the audit trail is remembered elsewhere, the less can be cut off unseen.
            Try("end of the audit trail", () => new AuditTrail(flow.Store, flow.Settings.KeysFolder).Remember());
            _remembered = flow.Clock.GetTimestamp();
        }

        return Task.FromResult(flow.Pace.Heartbeat);
    }

    // A full disk of the logs or keys is a trouble to be told. It must not make the heart beat slower, or the cell would be taken for dead and ended.
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
