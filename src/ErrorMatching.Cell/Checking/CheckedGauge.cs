namespace ErrorMatching.Cell;

/// <summary>The current state of a gauge's folder, or of the machine that its logs come from.</summary>
/// <param name="Gauge">The gauge.</param>
/// <param name="Files">The first files that match its pattern, and what the cell would do with each.</param>
/// <param name="More">How many more match.</param>
/// <param name="Left">Matching files that the cell would leave where they are.</param>
/// <param name="Problem">Why the source cannot be checked; null if nothing is wrong.</param>
public sealed record CheckedGauge(
    GaugeSettings Gauge, IReadOnlyList<CheckedFile> Files, int More, IReadOnlyList<LeftFile> Left, CheckProblem? Problem);
