namespace ErrorMatching.Nc;

/// <summary>Bytes as all controls read them, and stretches that brackets enclose.</summary>
internal static class SyntaxBytes
{
    public static bool IsDigit(byte c) => (uint)(c - '0') < 10;

    public static bool IsLetter(byte c) => (uint)((c | 0x20) - 'a') < 26;

    public static bool IsSpace(byte c) => c is (byte)' ' or (byte)'\t';

    public static bool IsNamePart(byte c) => IsLetter(c) || IsDigit(c) || c is (byte)'_' or (byte)'$';

    public static int SkipSpaces(ReadOnlySpan<byte> bytes, int at, int end)
    {
        while (at < end && IsSpace(bytes[at]))
        {
            at++;
        }

        return at;
    }

    /// <summary>The place behind the bracket that closes the one at a place, strings passed over; the end where none does.</summary>
    public static int BehindBracket(ReadOnlySpan<byte> bytes, int at, int end)
    {
        var (open, close) = bytes[at] == '(' ? ((byte)'(', (byte)')') : ((byte)'[', (byte)']');
        var depth = 0;
        while (at < end)
        {
            var c = bytes[at];
            if (c == '"')
            {
                at = BehindString(bytes, at, end);
                continue;
            }

            depth += c == open ? 1 : c == close ? -1 : 0;
            at++;
            if (depth == 0)
            {
                return at;
            }
        }

        return end;
    }

    /// <summary>The place behind a string that begins at a place.</summary>
    public static int BehindString(ReadOnlySpan<byte> bytes, int at, int end)
    {
        var close = bytes[(at + 1)..end].IndexOf((byte)'"');
        return close < 0 ? end : at + close + 2;
    }
}
