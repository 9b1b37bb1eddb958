namespace ErrorMatching.Cell;

/// <summary>Sees what other processes do to the store, such as an approval at the console, and wakes those whom it may concern.</summary>
internal sealed class StoreWatch(CellFlow flow)
{
    private long _seen = -1;

    /// <summary>Looks once.</summary>
    public Task<TimeSpan> WorkAsync(CancellationToken stop)
    {
        stop.ThrowIfCancellationRequested();
        var now = flow.Store.ChangeCount();
        if (now != _seen)
        {
            _seen = now;
            flow.TellAll();
        }

        return Task.FromResult(flow.Pace.Store);
    }
}
