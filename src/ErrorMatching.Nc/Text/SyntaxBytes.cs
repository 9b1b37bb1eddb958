namespace ErrorMatching.Nc;

/// <summary>Bytes that all controls read alike, and bracketed ranges.</summary>
internal static class SyntaxBytes
{
    /// <summary>The end-of-file sign of old file systems, which some senders still append.</summary>
    public const byte EndOfFile = 0x1A;

    /// <summary>Maximum number of filler bytes checked after an end-of-file sign.</summary>
    private const int LongestTail = 1 << 12;

    private static readonly System.Buffers.SearchValues<byte> Fill = System.Buffers.SearchValues.Create("\0\x1A\r\n \t"u8);

    /// <summary>Length of the UTF-8 byte order mark at the start of a file; 0 if it has none.</summary>
    public static int MarkLength(ReadOnlySpan<byte> bytes) => bytes.StartsWith("\uFEFF"u8) ? 3 : 0;

    /// <summary>The position after zero bytes and end-of-file signs.</summary>
    public static int BehindPadding(ReadOnlySpan<byte> bytes, int at, int end) =>
        bytes[at..end].IndexOfAnyExcept((byte)0, EndOfFile) is >= 0 and var length ? at + length : end;

    private const int LongestProgramName = 32;

    /// <summary>True for bytes that controls ignore: zero bytes at the end of a block, as left by paper tapes and file systems, and an
    /// end-of-file sign with only filler after it.</summary>
    public static bool IsFiller(ReadOnlySpan<byte> bytes, int start, int end, int blockEnd) => end == blockEnd
        && (bytes[start..end].IndexOf(EndOfFile) < 0 || (bytes.Length - end <= LongestTail && bytes[end..].IndexOfAnyExcept(Fill) < 0));

    public static bool IsDigit(byte c) => (uint)(c - '0') < 10;

    public static bool IsLetter(byte c) => (uint)((c | 0x20) - 'a') < 26;

    public static bool IsSpace(byte c) => c is (byte)' ' or (byte)'\t';

    public static bool IsNamePart(byte c) => IsLetter(c) || IsDigit(c) || c is (byte)'_' or (byte)'$';

    /// <summary>The end of a program's name in angle brackets, <c>&lt;BORE-1&gt;</c>; 0 if none is at the position. It has at most 32
    /// letters, digits and signs (Fanuc 30i).</summary>
    public static int BehindProgramName(ReadOnlySpan<byte> bytes, int at, int end)
    {
        if (bytes[at] != '<')
        {
            return 0;
        }

        var (name, last) = (at + 1, Math.Min(end, at + LongestProgramName + 2));
        while (name < last
            && (IsLetter(bytes[name]) || IsDigit(bytes[name]) || bytes[name] is (byte)'+' or (byte)'-' or (byte)'_' or (byte)'.'))
        {
            name++;
        }

        return name < last && bytes[name] == '>' && name - at > 1 ? name + 1 : 0;
    }

    public static int SkipSpaces(ReadOnlySpan<byte> bytes, int at, int end)
    {
        while (at < end && IsSpace(bytes[at]))
        {
            at++;
        }

        return at;
    }

    /// <summary>The position after the closing bracket of the one at a position, skipping strings; the end if there is none.</summary>
    public static int BehindBracket(ReadOnlySpan<byte> bytes, int at, int end)
    {
        var (open, close) = bytes[at] == '(' ? ((byte)'(', (byte)')') : ((byte)'[', (byte)']');
        var depth = 0;
        while (at < end)
        {
            var c = bytes[at++];
            if (c == close)
            {
                if (--depth == 0)
                {
                    return at;
                }
            }
            else if (c == open)
            {
                depth++;
            }
            else if (c == '"')
            {
                at = BehindString(bytes, at - 1, end);
            }
        }

        return end;
    }

    /// <summary>The position after a string that begins at a position.</summary>
    public static int BehindString(ReadOnlySpan<byte> bytes, int at, int end)
    {
        var close = bytes[(at + 1)..end].IndexOf((byte)'"');
        return close < 0 ? end : at + close + 2;
    }
}
