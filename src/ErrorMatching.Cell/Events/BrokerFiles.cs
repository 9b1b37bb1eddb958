using System.Security.Cryptography;
using System.Security.Cryptography.X509Certificates;
using System.Text;

namespace ErrorMatching.Cell;

/// <summary>Reads the files that a broker's settings name: the password, and the certificates of authorities. They are read at each
/// connection, so that a changed password takes effect without a restart.</summary>
internal static class BrokerFiles
{
    private const int MostBytes = 1 << 20;
    private const int MostPassword = 4096;
    private const UnixFileMode OfOthers =
        UnixFileMode.GroupRead | UnixFileMode.GroupWrite | UnixFileMode.OtherRead | UnixFileMode.OtherWrite;

    /// <summary>The password as the broker gets it; null if the settings name no file.</summary>
    /// <exception cref="BrokerException">With <see cref="BrokerError.Secret"/>.</exception>
    public static byte[]? Password(EventSettings broker)
    {
        if (broker.PasswordFile is not { } file)
        {
            return null;
        }

        var bytes = Read(broker, file, isSecret: true);
        var line = Encoding.UTF8.GetString(bytes).TrimEnd('\n', '\r');
        return line.Length is > 0 and <= MostPassword && !line.Any(char.IsControl)
            ? Encoding.UTF8.GetBytes(line)
            : throw Unusable(broker, file, "it must have the password as its only line");
    }

    /// <summary>The certificates of the authorities; null if the settings name no file.</summary>
    /// <exception cref="BrokerException">With <see cref="BrokerError.Secret"/>.</exception>
    public static X509Certificate2Collection? Authorities(EventSettings broker)
    {
        if (broker.AuthorityFile is not { } file)
        {
            return null;
        }

        try
        {
            var found = new X509Certificate2Collection();
            found.ImportFromPem(Encoding.UTF8.GetString(Read(broker, file, isSecret: false)));
            return found.Count > 0 ? found : throw Unusable(broker, file, "it has no certificate in PEM form");
        }
        catch (CryptographicException e)
        {
            throw Unusable(broker, file, e.Message, e);
        }
    }

    private static byte[] Read(EventSettings broker, string file, bool isSecret)
    {
        try
        {
            using var handle = PlainFile.Open(file, FileShare.Read);
            if (isSecret && !OperatingSystem.IsWindows() && (File.GetUnixFileMode(handle) & OfOthers) != UnixFileMode.None)
            {
                throw Unusable(broker, file, "others may read it: chmod 600");
            }

            var bytes = new byte[Math.Min(RandomAccess.GetLength(handle), MostBytes + 1)];
            var length = RandomAccess.Read(handle, bytes, 0);
            return length <= MostBytes ? bytes[..length] : throw Unusable(broker, file, "it is too large");
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw Unusable(broker, file, e.Message, e);
        }
    }

    private static BrokerException Unusable(EventSettings broker, string file, string why, Exception? cause = null) =>
        BrokerException.Of(BrokerError.Secret, broker, $"reading {file}", why, cause);
}
