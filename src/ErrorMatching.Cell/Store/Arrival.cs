namespace ErrorMatching.Cell;

/// <summary>A finished file as it arrived.</summary>
/// <param name="Gauge">The gauge that it came from.</param>
/// <param name="FileName">The file's name, without folders.</param>
/// <param name="Key">Distinguishes this arrival from all others by what is known of it: gauge, name, modification time, content. An arrival
/// with the same key is the same one, seen twice.</param>
/// <param name="Bytes">Its content.</param>
/// <param name="Trace">The W3C trace that follows it; null without tracing.</param>
public sealed record Arrival(string Gauge, string FileName, string Key, ReadOnlyMemory<byte> Bytes, string? Trace = null);

/// <summary>A file that arrived and is refused without being stored, such as one that is too large.</summary>
/// <param name="Gauge">The gauge that it came from.</param>
/// <param name="FileName">The file's name, without folders.</param>
/// <param name="Key">Distinguishes this arrival from all others, as in <see cref="Arrival"/>.</param>
/// <param name="Sha256">SHA-256 of its content as 64 lowercase hexadecimal digits.</param>
/// <param name="Length">Its length in bytes.</param>
/// <param name="Code">Stable code for why it is refused.</param>
/// <param name="Reason">The reason in a setter's terms.</param>
/// <param name="Trace">The W3C trace that follows it; null without tracing.</param>
internal sealed record UnreadArrival(
    string Gauge, string FileName, string Key, string Sha256, long Length, string Code, string Reason, string? Trace = null);
