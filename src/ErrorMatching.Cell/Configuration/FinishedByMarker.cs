namespace ErrorMatching.Cell;

/// <summary>A second file says that the first is finished.</summary>
/// <param name="Suffix">What the second file's name has behind the first's, such as <c>.done</c>.</param>
public sealed record FinishedByMarker(string Suffix) : FinishedRule;
