namespace ErrorMatching.Cell;

/// <summary>A file that waits at a gauge.</summary>
/// <param name="Name">Its name, as it may be shown.</param>
/// <param name="Bytes">Its length; null for a log at a machine.</param>
/// <param name="Found">Which job would take it, or why none; null for a log at a machine, which is not fetched.</param>
public sealed record CheckedFile(string Name, long? Bytes, Recognition? Found);
