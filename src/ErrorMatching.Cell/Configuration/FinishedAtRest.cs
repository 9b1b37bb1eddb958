namespace ErrorMatching.Cell;

/// <summary>The file is finished when its size and modification time stay the same; at a machine, when its content does.</summary>
/// <param name="For">For how long.</param>
public sealed record FinishedAtRest(TimeSpan For) : FinishedRule;
