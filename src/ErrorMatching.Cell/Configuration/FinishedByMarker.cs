namespace ErrorMatching.Cell;

/// <summary>A second file, the marker, shows that the first is finished.</summary>
/// <param name="Suffix">What follows the first file's name in the marker's name, such as <c>.done</c>.</param>
public sealed record FinishedByMarker(string Suffix) : FinishedRule;
