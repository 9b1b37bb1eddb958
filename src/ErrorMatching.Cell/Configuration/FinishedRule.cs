namespace ErrorMatching.Cell;

/// <summary>How to tell that a file is finished: a <see cref="FinishedByRename"/>, <see cref="FinishedByMarker"/>,
/// <see cref="FinishedAtRest"/> or <see cref="FinishedByEndMark"/>.</summary>
public abstract record FinishedRule;

/// <summary>The gauge writes under another name and then renames: a file with a matching name is finished.</summary>
internal sealed record FinishedByRename : FinishedRule;

/// <summary>A second file, the marker, shows that the first is finished.</summary>
/// <param name="Suffix">What follows the first file's name in the marker's name, such as <c>.done</c>.</param>
internal sealed record FinishedByMarker(string Suffix) : FinishedRule;

/// <summary>The file is finished when its size and modification time stay the same; at a machine, when its content does.</summary>
/// <param name="For">For how long.</param>
internal sealed record FinishedAtRest(TimeSpan For) : FinishedRule;

/// <summary>The file is finished when its last nonblank line is the end mark.</summary>
/// <param name="Mark">The line's text, without surrounding spaces.</param>
internal sealed record FinishedByEndMark(string Mark) : FinishedRule;
