using System.Collections.Concurrent;

namespace ErrorMatching.Cell;

/// <summary>What waits at the gauges of a running cell, as it was counted last.</summary>
internal sealed class Backlogs
{
    private readonly ConcurrentDictionary<string, GaugeBacklog> _all = new(StringComparer.Ordinal);

    /// <summary>The gauges that were counted, by name.</summary>
    public IReadOnlyList<GaugeBacklog> All => [.. _all.Values.OrderBy(b => b.Gauge, StringComparer.Ordinal)];

    /// <summary>Notes what was counted.</summary>
    public void Note(GaugeBacklog backlog) => _all[backlog.Gauge] = backlog;
}
