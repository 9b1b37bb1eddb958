using System.Buffers;
using System.Security.Cryptography;

namespace ErrorMatching.Cell;

/// <summary>Reads files that may still be in use by their writer.</summary>
internal static class FileReading
{
    private const int Piece = 1 << 20;

    /// <summary>The whole file; null if it changed while being read or its writer still has it open.</summary>
    public static byte[]? Whole(FileInfo file)
    {
        try
        {
            var (length, changed) = (file.Length, file.LastWriteTimeUtc);

            // Write sharing is not allowed: on Windows this fails until the writer has closed the file.
            using var handle = PlainFile.Open(file.FullName, FileShare.Read | FileShare.Delete);
            var bytes = GC.AllocateUninitializedArray<byte>((int)length + 1);
            var count = 0;
            for (int read; count < bytes.Length && (read = RandomAccess.Read(handle, bytes.AsSpan(count), count)) > 0;)
            {
                count += read;
            }

            return count == length && IsSame(file, length, changed) ? bytes[..count] : null;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return null;
        }
    }

    /// <summary>SHA-256 of a file of any length, as 64 lowercase hexadecimal digits; null if it changed while being read or its writer
    /// still has it open.</summary>
    /// <exception cref="OperationCanceledException">Canceled. Long files are slow to hash.</exception>
    public static string? Hash(FileInfo file, CancellationToken cancellation)
    {
        var piece = ArrayPool<byte>.Shared.Rent(Piece);
        try
        {
            var (length, changed) = (file.Length, file.LastWriteTimeUtc);
            using var handle = PlainFile.Open(file.FullName, FileShare.Read | FileShare.Delete);
            using var hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
            var count = 0L;
            for (int read; (read = RandomAccess.Read(handle, piece, count)) > 0; count += read)
            {
                cancellation.ThrowIfCancellationRequested();
                hash.AppendData(piece.AsSpan(0, read));
                if (count > length)
                {
                    return null;
                }
            }

            return count == length && IsSame(file, length, changed) ? Convert.ToHexStringLower(hash.GetHashAndReset()) : null;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return null;
        }
        finally
        {
            ArrayPool<byte>.Shared.Return(piece);
        }
    }

    private static bool IsSame(FileInfo file, long length, DateTime changed)
    {
        file.Refresh();
        return file.Exists && file.Length == length && file.LastWriteTimeUtc == changed;
    }
}
