namespace ErrorMatching.Cell;

/// <summary>A finished file as it arrived.</summary>
/// <param name="Gauge">The gauge that it came from.</param>
/// <param name="FileName">The file's name, without folders.</param>
/// <param name="Key">Tells this arrival from every other one, of whatever is known of it: gauge, name, time of change, content. The same key again is the same arrival, seen twice.</param>
/// <param name="Bytes">Its content.</param>
/// <param name="Trace">The W3C trace that follows it; null where nothing traces.</param>
public sealed record Arrival(string Gauge, string FileName, string Key, ReadOnlyMemory<byte> Bytes, string? Trace = null);
