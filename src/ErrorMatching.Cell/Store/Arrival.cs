namespace ErrorMatching.Cell;

/// <summary>A finished file as it arrived.</summary>
/// <param name="Gauge">The gauge that it came from.</param>
/// <param name="FileName">The file's name, without folders.</param>
/// <param name="Key">Distinguishes this arrival from all others by what is known of it: gauge, name, modification time, content. An arrival
/// with the same key is the same one, seen twice.</param>
/// <param name="Bytes">Its content.</param>
/// <param name="Trace">The W3C trace that follows it; null without tracing.</param>
public sealed record Arrival(string Gauge, string FileName, string Key, ReadOnlyMemory<byte> Bytes, string? Trace = null);
