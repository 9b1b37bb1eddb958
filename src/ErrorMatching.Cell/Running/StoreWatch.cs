namespace ErrorMatching.Cell;

/// <summary>Detects changes to the store by other processes, such as an approval at the console, and wakes the workers.</summary>
internal sealed class StoreWatch(CellFlow flow)
{
    private long _seen = -1;

    /// <summary>Checks once.</summary>
    public Task<TimeSpan> WorkAsync(CancellationToken stop)
    {
        stop.ThrowIfCancellationRequested();
        var now = flow.Store.HeardOf();
        if (now != _seen)
        {
            _seen = now;
            flow.TellAll();
        }

        return Task.FromResult(flow.Pace.Store);
    }
}
