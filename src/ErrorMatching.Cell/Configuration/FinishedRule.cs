namespace ErrorMatching.Cell;

/// <summary>How a file is known to be finished: a <see cref="FinishedByRename"/>, <see cref="FinishedByMarker"/>, <see cref="FinishedAtRest"/> or <see cref="FinishedByEndMark"/>.</summary>
public abstract record FinishedRule;
