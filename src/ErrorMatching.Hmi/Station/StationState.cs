using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>What the station knows of its cell at a moment. Made beside the screen, and never changed.</summary>
/// <param name="Version">Counts: a later state has a higher one.</param>
/// <param name="Status">How the cell is; null before it was seen for the first time.</param>
/// <param name="StoreTrouble">Why the store cannot be read just now, and <paramref name="Status"/> is what was seen last; null if it can.</param>
public sealed record StationState(long Version, CellStatus? Status, StoreException? StoreTrouble)
{
    /// <summary>Before the first look.</summary>
    public static StationState Unknown { get; } = new(0, null, null);

    /// <summary>Numbers of the corrections that wait and were made with a job as it was before it was changed.</summary>
    public IReadOnlySet<long> OfChangedJob { get; init; } = new HashSet<long>();

    /// <summary>What the programs of free slots cut last, by machine and slot.</summary>
    public IReadOnlyDictionary<(string Machine, string Slot), LastCut> LastCut { get; init; } = new Dictionary<(string Machine, string Slot), LastCut>();

    /// <summary>The counterparts that were measured outside of their limits, of each mating the newest first.</summary>
    public IReadOnlyList<KeptPiece> Outside { get; init; } = [];
}
