namespace ErrorMatching.Cell;

/// <summary>Size and time of change have stayed the same.</summary>
/// <param name="For">For how long.</param>
public sealed record FinishedAtRest(TimeSpan For) : FinishedRule;
