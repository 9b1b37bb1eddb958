using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Checks a cell: four times a second for changes of the store, and every two seconds for its sign of life. While there
/// is none, every half second, so that a restarted cell is soon shown as running.</summary>
internal sealed class StationWatch(Station station)
{
    private const int LooksBetween = 8, LooksBetweenIfStill = 2;
    private static readonly TimeSpan Every = TimeSpan.FromMilliseconds(250);
    private readonly ChangedJobs _changedJobs = new(station.Settings);
    private readonly MeasuredOutside _measured = new(station.Settings);
    private readonly AlarmBook _alarms = new(station.Store, station.Clock);
    private IReadOnlyList<StoredPiece> _outside = [];
    private IReadOnlyDictionary<string, AlarmMark> _marks = new Dictionary<string, AlarmMark>(StringComparer.Ordinal);
    private IReadOnlyDictionary<(string Machine, string Slot), LastCut> _lastCut = new Dictionary<(string Machine, string Slot), LastCut>();
    private long _seen = -1;
    private CellStatus? _last;
    private IReadOnlySet<long> _ofChangedJob = new HashSet<long>();
    private long _version;

    /// <summary>Checks until canceled.</summary>
    /// <param name="show">Receives each new state.</param>
    /// <param name="end">Stops it.</param>
    public async Task RunAsync(Action<StationState> show, CancellationToken end)
    {
        for (var look = 0; !end.IsCancellationRequested; look++)
        {
            if (Look(isDue: look % (_last is { IsRunning: false } ? LooksBetweenIfStill : LooksBetween) == 0) is { } state)
            {
                show(state);
            }

            // The system's clock, not the station's: a test with a stopped clock must still see changes.
            await Task.Delay(Every, end).ContinueWith(
                _ => { }, CancellationToken.None, TaskContinuationOptions.None, TaskScheduler.Default);
        }
    }

    private StationState? Look(bool isDue)
    {
        try
        {
            var count = station.Store.HeardOf();
            if (count == _seen && !isDue)
            {
                return null;
            }

            _last = CellStatus.Of(station.Settings, station.Store, station.Clock);
            station.JobNames.Learn(
                station.Store,
                [
                    .. _last.Proposed,
                    .. _last.Failed,
                    .. _last.InWork,
                    .. _last.Slots.SelectMany(s => s.Approved),
                    .. _last.Slots.Select(s => s.Held).OfType<Correction>()]);
            _ofChangedJob = _changedJobs.Among(
                station.Store, [.. _last.Proposed, .. _last.Failed, .. _last.Slots.SelectMany(s => s.Approved)]);
            _outside = _measured.Now(station.Store);
            _marks = _alarms.Read();
            _lastCut = _last.Slots.Select(s => (s.Machine.Name, Slot: s.Slot.Name, Cut: LastCut.Of(station.Settings, station.Store, s)))
                .Where(s => s.Cut is not null)
                .ToDictionary(s => (s.Name, s.Slot), s => s.Cut!);
            _seen = count;
            return Known(null);
        }
        catch (StoreException e)
        {
            return Known(e);
        }

        StationState Known(StoreException? trouble) => new(++_version, _last, trouble)
        {
            OfChangedJob = _ofChangedJob,
            Outside = _outside,
            LastCut = _lastCut,
            Marks = _marks,
        };
    }
}
