using System.Globalization;
using System.Security.Cryptography;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>Keys of arrivals: one file that is seen twice, because the first look was cut off, has one key.</summary>
internal static class ArrivalKey
{
    /// <summary>The key of a file in a folder. The same content written again later is another arrival.</summary>
    /// <param name="gauge">The gauge.</param>
    /// <param name="name">The file's name.</param>
    /// <param name="changed">Its time of change in ticks.</param>
    /// <param name="sha256">Its content.</param>
    public static string Of(string gauge, string name, long changed, string sha256) => Hash(gauge, name, changed.ToString(CultureInfo.InvariantCulture), sha256);

    /// <summary>The key of a log at a machine, which has no reliable time: its content alone tells it from others.</summary>
    public static string Of(string gauge, string name, string sha256) => Hash(gauge, name, sha256);

    /// <summary>The key of a kept measurement that is given again in the place of a correction, which happens once for each.</summary>
    /// <param name="gauge">The gauge.</param>
    /// <param name="name">The file's name.</param>
    /// <param name="correction">Number of the correction that it takes the place of.</param>
    public static string OfAgain(string gauge, string name, long correction) => Hash(gauge, name, "again", correction.ToString(CultureInfo.InvariantCulture));

    // A zero stands in no part, so no two lists of parts are one text.
    private static string Hash(params string[] parts) => Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(string.Join('\0', parts))));
}
