using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Looks at a cell: at once when the store has changed, and every two seconds for its sign of life.</summary>
internal sealed class StationWatch(Station station)
{
    private const int LooksBetween = 8;
    private static readonly TimeSpan Every = TimeSpan.FromMilliseconds(250);
    private long _seen = -1;
    private CellStatus? _last;
    private long _version;

    /// <summary>Looks until told to end.</summary>
    /// <param name="show">Is given each state that was seen.</param>
    /// <param name="end">Ends it.</param>
    public async Task RunAsync(Action<StationState> show, CancellationToken end)
    {
        for (var look = 0; !end.IsCancellationRequested; look++)
        {
            if (Look(isDue: look % LooksBetween == 0) is { } state)
            {
                show(state);
            }

            // The system's clock, not the station's: a test that stands its clock still wants to see what happens.
            await Task.Delay(Every, end).ContinueWith(_ => { }, CancellationToken.None, TaskContinuationOptions.None, TaskScheduler.Default);
        }
    }

    private StationState? Look(bool isDue)
    {
        try
        {
            var count = station.Store.ChangeCount();
            if (count == _seen && !isDue)
            {
                return null;
            }

            _last = CellStatus.Of(station.Settings, station.Store, station.Clock);
            _seen = count;
            return new(++_version, _last, null);
        }
        catch (StoreException e)
        {
            return new(++_version, _last, e);
        }
    }
}
