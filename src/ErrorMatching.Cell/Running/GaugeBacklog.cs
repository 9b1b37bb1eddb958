using System.Collections.Concurrent;
using System.Text.Json.Serialization;

namespace ErrorMatching.Cell;

/// <summary>What waits at a gauge: files that are not stored yet, and stored measurements that are not computed yet.</summary>
/// <param name="Gauge">The gauge.</param>
/// <param name="Files">Number of files in its folder, at most 10,000.</param>
/// <param name="FilesSince">Since when the oldest file waits; null if none does.</param>
/// <param name="Pieces">Number of stored measurements that are not computed yet.</param>
/// <param name="PiecesSince">Since when the oldest of them waits; null if none does.</param>
public sealed record GaugeBacklog(
    string Gauge, int Files, DateTimeOffset? FilesSince, long Pieces, DateTimeOffset? PiecesSince)
{
    /// <summary>True if it has grown for a minute, and has not shrunk since.</summary>
    public bool IsGrowing { get; init; }

    /// <summary>Files and measurements.</summary>
    [JsonIgnore]
    public long Count => Files + Pieces;

    /// <summary>True if there are more files than were counted.</summary>
    [JsonIgnore]
    public bool AreMore => Files >= WaitingFiles.Most;

    /// <summary>Since when the oldest waits; null if nothing does.</summary>
    [JsonIgnore]
    public DateTimeOffset? Since => FilesSince is not { } files ? PiecesSince
        : PiecesSince is { } pieces && pieces < files ? pieces : files;

    /// <summary>What waits in the store, by gauge; gauges without anything are left out.</summary>
    internal static IReadOnlyDictionary<string, (long Count, DateTimeOffset Since)> InStore(CellStore store) => store.Read(
        $"SELECT gauge, count(*), min(arrived_at) FROM correction WHERE "
            + CorrectionRow.IsIn("state", CorrectionSteps.Where(s => s.IsInWork)) + " GROUP BY gauge",
        r => (Gauge: r.GetString(0), Count: r.GetInt64(1), Since: StoredTime.From(r.GetInt64(2)))).ToDictionary(
            g => g.Gauge, g => (g.Count, g.Since), StringComparer.Ordinal);

    /// <summary>What waits at each gauge of a cell now.</summary>
    /// <param name="settings">The cell.</param>
    /// <param name="store">Its store.</param>
    /// <param name="clock">The clock.</param>
    public static IReadOnlyList<GaugeBacklog> Of(CellSettings settings, CellStore store, TimeProvider clock)
    {
        ArgumentNullException.ThrowIfNull(settings);
        ArgumentNullException.ThrowIfNull(store);
        var stored = InStore(store);
        return [.. settings.Gauges.Select(g => Of(g.Name, new WaitingFiles(g, clock).Count(), stored))];
    }

    internal static GaugeBacklog Of(
        string gauge, (int Count, DateTimeOffset? Since) files, IReadOnlyDictionary<string, (long Count, DateTimeOffset Since)> stored) =>
        stored.TryGetValue(gauge, out var pieces)
            ? new(gauge, files.Count, files.Since, pieces.Count, pieces.Since)
            : new(gauge, files.Count, files.Since, 0, null);
}

/// <summary>What waits at the gauges of a running cell, as it was counted last.</summary>
internal sealed class Backlogs
{
    private readonly ConcurrentDictionary<string, GaugeBacklog> _all = new(StringComparer.Ordinal);

    /// <summary>The gauges that were counted, by name.</summary>
    public IReadOnlyList<GaugeBacklog> All => [.. _all.Values.OrderBy(b => b.Gauge, StringComparer.Ordinal)];

    /// <summary>Notes what was counted.</summary>
    public void Note(GaugeBacklog backlog) => _all[backlog.Gauge] = backlog;
}
