namespace ErrorMatching.Cell;

/// <summary>A file waiting at a gauge.</summary>
/// <param name="Name">Its name, made safe for display.</param>
/// <param name="Bytes">Its length; null for a log at a machine.</param>
/// <param name="Found">The job that would take it, or why none would; null for a log at a machine, which is not fetched.</param>
public sealed record CheckedFile(string Name, long? Bytes, RecognitionResult? Found);
