namespace ErrorMatching.Cell;

/// <summary>Patterns of which all that are given must match for a file to be a job's. Their groups <c>serial</c> and <c>workOrder</c> say what their names say.</summary>
/// <param name="FileName">About the name of the file.</param>
/// <param name="HeaderField">About the value of a header field: its name and the pattern.</param>
/// <param name="Column">About all values of a column: its name and the pattern.</param>
public sealed record RecognitionSettings(string? FileName, (string Name, string Pattern)? HeaderField, (string Name, string Pattern)? Column);
