namespace ErrorMatching.Nc;

/// <summary>The bytes of a block up to its end, and the rules common to all spellings.</summary>
/// <param name="bytes">The program's bytes.</param>
/// <param name="end">The position after the block's last byte.</param>
/// <param name="syntax">Syntax of the block.</param>
internal readonly ref struct BlockScanner(ReadOnlySpan<byte> bytes, int end, NcSyntax syntax)
{
    public readonly ReadOnlySpan<byte> Bytes = bytes;
    public readonly int End = end;
    public readonly NcSyntax Syntax = syntax;

    public int SkipSpaces(int at) => SyntaxBytes.SkipSpaces(Bytes, at, End);

    /// <summary>Reads sign, digits, point, digits. A number with more digits than are exact makes the word invalid, not wrong.</summary>
    public bool ReadNumber(int at, out int next, out NcNumber number)
    {
        next = at;
        number = default;
        if (at >= End)
        {
            return false;
        }

        var negative = Bytes[at] == '-';
        if (negative || Bytes[at] == '+')
        {
            at = Inside(at + 1);
        }

        long digits = 0;
        var (whole, significant, decimals) = (0, 0, 0);
        var behind = at;
        for (; at < End && SyntaxBytes.IsDigit(Bytes[at]) && significant <= NcNumber.MaxDigits; at = Inside(behind))
        {
            digits = (digits * 10) + (Bytes[at] - '0');
            significant += digits == 0 ? 0 : 1;
            whole++;
            behind = at + 1;
        }

        if (at < End && Bytes[at] == '.')
        {
            behind = at + 1;
            for (at = Inside(behind);
                at < End && SyntaxBytes.IsDigit(Bytes[at]) && significant <= NcNumber.MaxDigits && decimals <= NcNumber.MaxDigits;
                at = Inside(behind))
            {
                digits = (digits * 10) + (Bytes[at] - '0');
                significant += digits == 0 ? 0 : 1;
                decimals++;
                behind = at + 1;
            }
        }

        if (whole + decimals == 0 || significant > NcNumber.MaxDigits || decimals > NcNumber.MaxDigits)
        {
            return false;
        }

        next = behind;
        number = new(negative ? -digits : digits, decimals);
        return true;
    }

    /// <summary>Bytes that every control passes over: a byte order mark at the start of the file, and padding. Null for others.</summary>
    public NcToken? FillerAt(int at)
    {
        switch (Bytes[at])
        {
            case 0xEF when at == 0 && SyntaxBytes.MarkLength(Bytes) is > 0 and var mark:
                return Plain(NcTokenKind.Space, at, mark);
            case 0 or SyntaxBytes.EndOfFile:
                var filled = SyntaxBytes.BehindPadding(Bytes, at, End);
                return Plain(SyntaxBytes.IsFiller(Bytes, at, filled, End) ? NcTokenKind.Space : NcTokenKind.Invalid, at, filled);
            default:
                return null;
        }
    }

    public int NameEnd(int at)
    {
        while (at < End && SyntaxBytes.IsNamePart(Bytes[at]))
        {
            at++;
        }

        return at;
    }

    /// <summary>True at an equals sign that assigns.</summary>
    public bool IsEquals(int at) => at < End && Bytes[at] == '=' && !(at + 1 < End && Bytes[at + 1] == '=');

    /// <summary>The closing parenthesis of an open one; -1 if there is none within a length.</summary>
    public int PartnerOf(int open, int most = int.MaxValue)
    {
        var (depth, end) = (0, Math.Min(End, open + (long)most));
        for (var at = open; at < end; at++)
        {
            depth += Bytes[at] == '(' ? 1 : Bytes[at] == ')' ? -1 : 0;
            if (depth == 0)
            {
                return at;
            }
        }

        return -1;
    }

    /// <summary>The position after a value that begins with an equals sign.</summary>
    public int BehindEquals(int at)
    {
        var depth = 0;
        for (; at < End; at++)
        {
            depth += Bytes[at] is (byte)'(' or (byte)'[' ? 1 : Bytes[at] is (byte)')' or (byte)']' ? -1 : 0;
            if (depth <= 0 && Bytes[at] is (byte)' ' or (byte)'\t' or (byte)';')
            {
                break;
            }
        }

        return at;
    }

    public int ToCommentOrEnd(int at)
    {
        var length = Bytes[at..End].IndexOfAny((byte)'(', (byte)';');
        return length < 0 ? End : at + length;
    }

    /// <summary>The position after the name of a variable or O word: #&lt;depth&gt;, o&lt;pocket&gt;.</summary>
    public int BehindName(int at)
    {
        var close = Bytes[at..End].IndexOf((byte)'>');
        return close < 0 ? End : at + close + 1;
    }

    /// <summary>A token without a value.</summary>
    public static NcToken Plain(NcTokenKind kind, int at, int next, byte letter = 0) =>
        new(kind, letter, at, next - at, at, next - at, default, WordDistance.Modal);

    /// <summary>A token that ends with its value.</summary>
    public static NcToken Valued(NcTokenKind kind, byte letter, int at, int value, int next, NcNumber number = default) =>
        new(kind, letter, at, next - at, value, next - value, number, WordDistance.Modal);

    // LinuxCNC ignores spaces inside numbers.
    private int Inside(int at) => Syntax == NcSyntax.LinuxCnc ? SkipSpaces(at) : at;
}
