using System.Globalization;
using ErrorMatching.Json;
using ErrorMatching.Reporting;

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
    string Gauge, string FileName, string Key, string Sha256, long Length, string Code, Statement Reason, string? Trace = null);

/// <summary>Keys of arrivals. A file that is seen twice because the first look was interrupted has the same key both times.</summary>
internal static class ArrivalKey
{
    /// <summary>The key of a file in a folder. The same content written again later is another arrival.</summary>
    /// <param name="gauge">The gauge.</param>
    /// <param name="name">The file's name.</param>
    /// <param name="changed">Its modification time in ticks.</param>
    /// <param name="sha256">Its content.</param>
    public static string Of(string gauge, string name, long changed, string sha256) =>
        Hash(gauge, name, changed.ToString(CultureInfo.InvariantCulture), sha256);

    /// <summary>The key of a log at a machine. It has no reliable time, so only its content distinguishes it.</summary>
    public static string Of(string gauge, string name, string sha256) => Hash(gauge, name, sha256);

    /// <summary>The key of a stored measurement that is recalculated: a correction is replaced once, so that its number tells the arrivals
    /// apart.</summary>
    /// <param name="gauge">The gauge.</param>
    /// <param name="name">The file's name.</param>
    /// <param name="correction">Number of the correction that it replaces.</param>
    public static string OfRecalculation(string gauge, string name, long correction) =>
        Hash(gauge, name, "again", correction.ToString(CultureInfo.InvariantCulture));

    // No part contains a zero, so no two lists of parts give the same text.
    private static string Hash(params string[] parts) =>
        ContentHash.Sha256OfText(string.Join('\0', parts));
}
