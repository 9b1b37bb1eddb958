namespace ErrorMatching.Cell;

/// <summary>How a file is known to be finished: a <see cref="FinishedByRename"/>, <see cref="FinishedByMarker"/> or <see cref="FinishedAtRest"/>.</summary>
public abstract record FinishedRule;
