using System.Text;

namespace ErrorMatching.Cell;

/// <summary>Looks for the mark in the last line of a file.</summary>
internal static class EndMark
{
    // Room for the last line and the blank ones after it; a file with more blanks at its end counts as unfinished.
    private const int Tail = 4096;

    /// <summary>The same for a file; also false if the file cannot be opened yet.</summary>
    public static bool Ends(FileInfo file, string mark)
    {
        try
        {
            using var handle = PlainFile.Open(file.FullName, FileShare.ReadWrite | FileShare.Delete);
            var tail = new byte[Tail];
            var length = RandomAccess.GetLength(handle);
            var read = RandomAccess.Read(handle, tail, Math.Max(0, length - Tail));
            return Ends(tail.AsSpan(0, read), mark);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return false;
        }
    }

    /// <summary>True if the last nonblank line is the mark. The percent sign that a control closes a file with is not a line.</summary>
    public static bool Ends(ReadOnlySpan<byte> bytes, string mark)
    {
        var line = bytes.TrimEnd(mark.EndsWith('%') ? " \t\r\n\0"u8 : " \t\r\n\0%"u8);
        line = line[(line.LastIndexOfAny("\r\n"u8) + 1)..].TrimStart(" \t"u8);
        return line.SequenceEqual(Encoding.UTF8.GetBytes(mark));
    }
}
