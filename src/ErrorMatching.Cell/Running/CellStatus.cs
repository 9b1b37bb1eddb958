using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>The status of a cell: what it holds, what waits, and what prevents it from working.</summary>
/// <param name="Heartbeat">The heartbeat of the process that runs it; null if there is none.</param>
/// <param name="IsRunning">True if the heartbeat is fresh.</param>
/// <param name="Slots">All slots, in the order of the configuration.</param>
/// <param name="Proposed">Corrections that wait for a person's approval, in order of arrival: all of them, since any may
/// be the next of its slot.</param>
/// <param name="Failed">All failed corrections that wait for a setter, in order of arrival.</param>
/// <param name="InWork">All corrections that have arrived and are not computed yet.</param>
/// <param name="Counts">The number of corrections in each state; states without any are omitted.</param>
public sealed record CellStatus(
    Heartbeat? Heartbeat,
    bool IsRunning,
    IReadOnlyList<SlotStatus> Slots,
    IReadOnlyList<Correction> Proposed,
    IReadOnlyList<Correction> Failed,
    IReadOnlyList<Correction> InWork,
    IReadOnlyDictionary<CorrectionState, long> Counts)
{
    /// <summary>Changes made to the store from outside the cell: see <see cref="CellStore.Tampered"/>.</summary>
    public IReadOnlyList<Statement> Tampered { get; init; } = [];

    /// <summary>What waits at the gauges, as the running cell counted it last; empty if it does not run.</summary>
    public IReadOnlyList<GaugeBacklog> Backlog { get; init; } = [];

    /// <summary>Archives that are not in their folder, each in a sentence; a running cell has them among its troubles.</summary>
    public IReadOnlyList<string> MissingArchives { get; init; } = [];

    /// <summary>The number of corrections in a state.</summary>
    public long CountOf(CorrectionState state) => Counts.GetValueOrDefault(state);

    /// <summary>True if only a person's approval or an operator's release is pending, as in normal operation.</summary>
    public bool IsHealthy => IsRunning && Failed.Count == 0 && Heartbeat!.Troubles.Count == 0 && Tampered.Count == 0;

    /// <summary>Determines the status.</summary>
    /// <param name="settings">The configuration.</param>
    /// <param name="store">The store.</param>
    /// <param name="clock">The clock.</param>
    public static CellStatus Of(CellSettings settings, CellStore store, TimeProvider clock)
    {
        ArgumentNullException.ThrowIfNull(settings);
        ArgumentNullException.ThrowIfNull(store);
        ArgumentNullException.ThrowIfNull(clock);
        var heartbeat = Heartbeat.Read(settings.LogFolder);
        var isRunning = heartbeat?.IsFresh(clock.GetUtcNow()) ?? false;
        return new(
            heartbeat,
            isRunning,
            [.. settings.Machines.SelectMany(m => m.Slots.Select(
                s => SlotStatus.Of(settings, m, s, store, isRunning ? heartbeat : null)))],
            [.. store.Corrections.InState(CorrectionState.Proposed).OrderBy(c => c.Turn).ThenBy(c => c.Id)],
            store.Corrections.InState(CorrectionState.Failed),
            store.Corrections.InState([.. CorrectionSteps.Where(s => s.IsInWork)]),
            store.Corrections.Counts())
        {
            Tampered = store.Tampered(),
            Backlog = isRunning ? heartbeat!.Backlog : [],
        };
    }
}
