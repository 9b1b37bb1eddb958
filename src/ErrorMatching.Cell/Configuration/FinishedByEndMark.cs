namespace ErrorMatching.Cell;

/// <summary>The file is finished when its last nonblank line is the end mark.</summary>
/// <param name="Mark">The line's text, without surrounding spaces.</param>
public sealed record FinishedByEndMark(string Mark) : FinishedRule;
