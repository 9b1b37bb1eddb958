namespace ErrorMatching.Cell;

/// <summary>What a gauge's folder, or the machine that its logs come from, looks like now.</summary>
/// <param name="Gauge">The gauge.</param>
/// <param name="Files">The first files that fit its pattern, and what the cell would do with each.</param>
/// <param name="More">How many more fit.</param>
/// <param name="Left">What fits and would be left where it is.</param>
/// <param name="Problem">Why nobody can tell; null if nothing is wrong.</param>
public sealed record CheckedGauge(GaugeSettings Gauge, IReadOnlyList<CheckedFile> Files, int More, IReadOnlyList<LeftFile> Left, CheckProblem? Problem);
