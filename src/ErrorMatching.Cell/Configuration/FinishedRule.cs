namespace ErrorMatching.Cell;

/// <summary>How to tell that a file is finished: a <see cref="FinishedByRename"/>, <see cref="FinishedByMarker"/>,
/// <see cref="FinishedAtRest"/> or <see cref="FinishedByEndMark"/>.</summary>
public abstract record FinishedRule;
