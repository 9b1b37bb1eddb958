namespace ErrorMatching.Cell;

/// <summary>The last line that is not blank says that the file is finished.</summary>
/// <param name="Mark">What the line says, without the spaces around it.</param>
public sealed record FinishedByEndMark(string Mark) : FinishedRule;
