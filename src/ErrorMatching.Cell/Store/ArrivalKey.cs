using System.Globalization;
using System.Security.Cryptography;
using System.Text;

namespace ErrorMatching.Cell;

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
        Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(string.Join('\0', parts))));
}
