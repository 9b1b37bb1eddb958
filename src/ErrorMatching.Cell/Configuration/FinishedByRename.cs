namespace ErrorMatching.Cell;

/// <summary>The gauge writes under another name and then renames: a file with a matching name is finished.</summary>
public sealed record FinishedByRename : FinishedRule;
