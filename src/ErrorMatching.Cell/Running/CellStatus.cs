namespace ErrorMatching.Cell;

/// <summary>How a cell is: what it holds, what waits, and what keeps it from working.</summary>
/// <param name="Heartbeat">The sign of life of the process that runs it; null if there is none.</param>
/// <param name="IsRunning">True if that is fresh.</param>
/// <param name="Slots">All slots, in the order of the configuration.</param>
/// <param name="Proposed">What waits for a person's approval, in order of arrival: the first hundred.</param>
/// <param name="Failed">What failed and waits for a setter, in order of arrival: the first hundred.</param>
/// <param name="InWork">What arrived and is not computed yet: the first hundred.</param>
/// <param name="Counts">How many corrections there are in each state; states without any are left out.</param>
public sealed record CellStatus(
    Heartbeat? Heartbeat,
    bool IsRunning,
    IReadOnlyList<SlotStatus> Slots,
    IReadOnlyList<Correction> Proposed,
    IReadOnlyList<Correction> Failed,
    IReadOnlyList<Correction> InWork,
    IReadOnlyDictionary<CorrectionState, long> Counts)
{
    // More of a kind than a person looks through at once are counted.
    internal const int Most = 100;

    /// <summary>What somebody else wrote to the store, in sentences: see <see cref="CellStore.Tampered"/>.</summary>
    public IReadOnlyList<string> Tampered { get; init; } = [];

    /// <summary>How many corrections are in a state.</summary>
    public long CountOf(CorrectionState state) => Counts.GetValueOrDefault(state);

    /// <summary>True if nothing stands in the way but a person's approval or an operator's release, which is the ordinary course.</summary>
    public bool IsHealthy => IsRunning && Failed.Count == 0 && Heartbeat!.Troubles.Count == 0 && Tampered.Count == 0;

    /// <summary>Looks.</summary>
    /// <param name="settings">The configuration.</param>
    /// <param name="store">The store.</param>
    /// <param name="clock">The clock.</param>
    public static CellStatus Of(CellSettings settings, CellStore store, TimeProvider clock)
    {
        ArgumentNullException.ThrowIfNull(settings);
        ArgumentNullException.ThrowIfNull(store);
        ArgumentNullException.ThrowIfNull(clock);
        var heartbeat = Heartbeat.Read(settings.LogFolder);
        return new(
            heartbeat,
            heartbeat?.IsFresh(clock.GetUtcNow()) ?? false,
            [.. settings.Machines.SelectMany(m => m.Slots.Select(s => SlotStatus.Of(settings, m, s, store)))],
            [.. store.First(CorrectionState.Proposed, Most).OrderBy(c => c.Turn).ThenBy(c => c.Id)],
            store.First(CorrectionState.Failed, Most),
            [.. store.First(CorrectionState.Archived, Most), .. store.First(CorrectionState.Recognized, Most)],
            store.Counts())
        {
            Tampered = store.Tampered(),
        };
    }
}
