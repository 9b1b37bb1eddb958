using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>What the station knows of its cell at one moment. Immutable; created off the UI thread.</summary>
/// <param name="Version">Version number; later states have higher ones.</param>
/// <param name="Status">The state of the cell; null before the first check.</param>
/// <param name="StoreTrouble">Why the store cannot be read now, in which case <paramref name="Status"/> is the last known state;
/// null if it can be read.</param>
public sealed record StationState(long Version, CellStatus? Status, StoreException? StoreTrouble)
{
    /// <summary>The state before the first check.</summary>
    public static StationState Unknown { get; } = new(0, null, null);

    /// <summary>Numbers of the waiting corrections whose job was changed after they were computed.</summary>
    public IReadOnlySet<long> OfChangedJob { get; init; } = new HashSet<long>();

    /// <summary>The last cuts with the programs of free slots, by machine and slot.</summary>
    public IReadOnlyDictionary<(string Machine, string Slot), LastCut> LastCut { get; init; } =
        new Dictionary<(string Machine, string Slot), LastCut>();

    /// <summary>The measured counterparts outside their limits, newest first within each mating.</summary>
    public IReadOnlyList<StoredPiece> Outside { get; init; } = [];

    /// <summary>What people did about alarms, by the alarms' keys.</summary>
    public IReadOnlyDictionary<string, AlarmMark> Marks { get; init; } = new Dictionary<string, AlarmMark>(StringComparer.Ordinal);

    /// <summary>What people did about an alarm.</summary>
    public AlarmMark MarkOf(Alarm alarm)
    {
        ArgumentNullException.ThrowIfNull(alarm);
        return Marks.GetValueOrDefault(alarm.Key, AlarmMark.None);
    }
}
