namespace ErrorMatching.Cell;

/// <summary>Size and time of change have stayed the same; at a machine, the content has.</summary>
/// <param name="For">For how long.</param>
public sealed record FinishedAtRest(TimeSpan For) : FinishedRule;
