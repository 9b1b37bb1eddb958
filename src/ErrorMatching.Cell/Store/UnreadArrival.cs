namespace ErrorMatching.Cell;

/// <summary>A file that arrived and is refused without being kept, such as one that is too large.</summary>
/// <param name="Gauge">The gauge that it came from.</param>
/// <param name="FileName">The file's name, without folders.</param>
/// <param name="Key">Tells this arrival from every other one, as in <see cref="Arrival"/>.</param>
/// <param name="Sha256">SHA-256 of its content as 64 lower-case hexadecimal digits.</param>
/// <param name="Length">Its length in bytes.</param>
/// <param name="Code">Stable word for why it is refused.</param>
/// <param name="Reason">The reason in a setter's words.</param>
/// <param name="Trace">The W3C trace that follows it; null where nothing traces.</param>
public sealed record UnreadArrival(string Gauge, string FileName, string Key, string Sha256, long Length, string Code, string Reason, string? Trace = null);
