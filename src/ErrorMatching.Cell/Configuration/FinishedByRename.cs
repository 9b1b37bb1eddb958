namespace ErrorMatching.Cell;

/// <summary>The gauge writes under another name and renames: a file whose name fits is finished.</summary>
public sealed record FinishedByRename : FinishedRule;
