using System.Globalization;
using ErrorMatching.Json;

namespace ErrorMatching.Measurement;

/// <summary>Reads the bytes of a file that may be missing, too large, or not a regular file.</summary>
internal static class FileBytes
{
    public static byte[] Read(string path, int maxBytes)
    {
        try
        {
            using var stream = SharedFile.OpenRead(path, FileShare.ReadWrite | FileShare.Delete);
            if (stream.CanSeek)
            {
                ThrowIfTooLarge(path, stream.Length, maxBytes);
            }

            // A pipe has no length, and a file may grow while it is read. One byte more than allowed is read to detect this.
            var buffer = new byte[stream.CanSeek ? (int)Math.Min(stream.Length, maxBytes) + 1 : 4096];
            var count = 0;
            for (int read; (read = stream.Read(buffer, count, buffer.Length - count)) > 0;)
            {
                count += read;
                ThrowIfTooLarge(path, count, maxBytes);
                if (count == buffer.Length)
                {
                    Array.Resize(ref buffer, (int)Math.Min(2L * count, (long)maxBytes + 1));
                }
            }

            return buffer[..count];
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException or ArgumentException)
        {
            throw MeasurementRefusal.Of(
                MeasurementError.FileUnreadable,
                e is FileNotFoundException or DirectoryNotFoundException && !Directory.Exists(path)
                    ? "no such file"
                    : Directory.Exists(path) ? "a folder"
                    : "a file that cannot be read: " + FileFault.Of(path, e),
                "a measurement file that exists and that this user may read",
                path,
                cause: e);
        }
    }

    public static void ThrowIfTooLarge(string file, long count, int maxBytes)
    {
        if (count > maxBytes)
        {
            throw Place.Start(file).Fail(
                MeasurementError.FileTooLarge,
                string.Create(CultureInfo.InvariantCulture, $"more than {maxBytes} bytes"),
                "a measurement within that limit: is this the right file? If so, raise maxBytes of its format");
        }
    }
}
