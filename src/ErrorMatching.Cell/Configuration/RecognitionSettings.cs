namespace ErrorMatching.Cell;

/// <summary>Patterns that recognize a job's files; all that are given must match. The groups <c>serial</c> and <c>workOrder</c> capture the
/// serial number and the work order.</summary>
/// <param name="FileName">Pattern for the file name.</param>
/// <param name="HeaderField">A header field and the pattern for its value.</param>
/// <param name="Column">A column and the pattern for all its values.</param>
public sealed record RecognitionSettings(
    string? FileName, (string Name, string Pattern)? HeaderField, (string Name, string Pattern)? Column);
