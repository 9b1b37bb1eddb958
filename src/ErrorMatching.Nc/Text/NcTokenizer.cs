namespace ErrorMatching.Nc;

/// <summary>
/// Walks over a block's tokens without allocating. Spelling only: every byte belongs to exactly one token, and what no rule explains is
/// <see cref="NcTokenKind.Invalid"/>, never dropped.
/// </summary>
public ref struct NcTokenizer
{
    private readonly ReadOnlySpan<byte> bytes;
    private readonly int end;
    private int position;
    private bool atStart;

    internal NcTokenizer(ReadOnlySpan<byte> bytes, int start, int end)
    {
        this.bytes = bytes;
        this.end = end;
        position = start;
        atStart = true;
        Current = default;
    }

    /// <summary>The token last read.</summary>
    public NcToken Current { get; private set; }

    /// <summary>The tokenizer itself, so that <c>foreach</c> works.</summary>
    public readonly NcTokenizer GetEnumerator() => this;

    /// <summary>Reads the next token; false at the end of the block.</summary>
    public bool MoveNext()
    {
        if (position >= end)
        {
            return false;
        }

        var c = bytes[position];
        if ((uint)((c | 0x20) - 'a') < 26)
        {
            ReadLetter((byte)(c & ~0x20));
            atStart &= Current is { Kind: NcTokenKind.Word, Letter: (byte)'N' };
            return true;
        }

        switch (c)
        {
            case (byte)' ' or (byte)'\t':
                Plain(NcTokenKind.Space, SkipSpaces(position + 1));
                break;
            case (byte)'(':
                ReadComment();
                break;
            case (byte)';':
                Plain(NcTokenKind.Comment, end);
                break;
            case (byte)'%':
                Plain(NcTokenKind.Percent, end);
                break;
            // A slash stands at the beginning of a block or behind its number (N10 /1 G0); elsewhere it divides.
            case (byte)'/' when atStart:
                Plain(NcTokenKind.BlockSkip, position + 1 < end && IsDigit(bytes[position + 1]) ? position + 2 : position + 1);
                break;
            case (byte)',':
                ReadCommaWord();
                break;
            case (byte)'#':
                Plain(NcTokenKind.Assignment, ToCommentOrEnd(position + 1));
                break;
            case (byte)'[':
                Plain(NcTokenKind.Expression, BehindBracket(position));
                break;
            case (byte)'"':
                var close = bytes[(position + 1)..end].IndexOf((byte)'"');
                Plain(NcTokenKind.Invalid, close < 0 ? end : position + close + 2);
                break;
            default:
                Plain(NcTokenKind.Invalid, position + 1);
                break;
        }

        atStart &= Current.Kind is NcTokenKind.Space or NcTokenKind.BlockSkip;
        return true;
    }

    private static bool IsDigit(byte c) => (uint)(c - '0') < 10;

    private static bool IsLetter(byte c) => (uint)((c | 0x20) - 'a') < 26;

    private void Plain(NcTokenKind kind, int next, byte letter = 0)
    {
        Current = new(kind, letter, position, next - position, position, default);
        position = next;
    }

    private readonly int SkipSpaces(int at)
    {
        while (at < end && bytes[at] is (byte)' ' or (byte)'\t')
        {
            at++;
        }

        return at;
    }

    private void ReadComment()
    {
        var depth = 0;
        for (var at = position; at < end; at++)
        {
            if (bytes[at] == '(')
            {
                depth++;
            }
            else if (bytes[at] == ')' && --depth == 0)
            {
                Plain(NcTokenKind.Comment, at + 1);
                return;
            }
        }

        // Without a partner for every parenthesis the first closing one ends the comment, as most controls read it.
        var close = bytes[position..end].IndexOf((byte)')');
        Plain(close < 0 ? NcTokenKind.Invalid : NcTokenKind.Comment, close < 0 ? end : position + close + 1);
    }

    private void ReadCommaWord()
    {
        var letterAt = SkipSpaces(position + 1);
        if (letterAt < end && IsLetter(bytes[letterAt]) && ReadNumber(SkipSpaces(letterAt + 1), out var next, out var number))
        {
            Current = new(NcTokenKind.CommaWord, (byte)(bytes[letterAt] & ~0x20), position, next - position, SkipSpaces(letterAt + 1), number);
            position = next;
            return;
        }

        Plain(NcTokenKind.Invalid, position + 1);
    }

    private void ReadLetter(byte letter)
    {
        var valueAt = SkipSpaces(position + 1);
        if (ReadNumber(valueAt, out var next, out var number))
        {
            Current = new(NcTokenKind.Word, letter, position, next - position, valueAt, number);
            position = next;
        }
        else if (letter == 'O' && valueAt < end && bytes[valueAt] == '<')
        {
            Plain(NcTokenKind.ExpressionWord, BehindName(valueAt), letter);
        }
        else if (valueAt < end && ExpressionEnd(valueAt) is > 0 and var behind)
        {
            Plain(NcTokenKind.ExpressionWord, behind, letter);
        }
        else if (position + 1 < end && IsLetter(bytes[position + 1]))
        {
            Plain(NcTokenKind.Keyword, KeywordEnd());
        }
        else
        {
            Plain(NcTokenKind.Invalid, position + 1, letter);
        }
    }

    // Sign, digits, point, digits. More digits than are exact make the word invalid rather than wrong.
    private readonly bool ReadNumber(int at, out int next, out NcNumber number)
    {
        next = at;
        number = default;
        if (at >= end)
        {
            return false;
        }

        var negative = bytes[at] == '-';
        if (negative || bytes[at] == '+')
        {
            at++;
        }

        long digits = 0;
        var (first, significant, decimals) = (at, 0, 0);
        for (; at < end && IsDigit(bytes[at]) && significant <= NcNumber.MaxDigits; at++)
        {
            digits = (digits * 10) + (bytes[at] - '0');
            significant += digits == 0 ? 0 : 1;
        }

        var whole = at - first;
        if (at < end && bytes[at] == '.')
        {
            for (at++; at < end && IsDigit(bytes[at]) && significant <= NcNumber.MaxDigits && decimals <= NcNumber.MaxDigits; at++)
            {
                digits = (digits * 10) + (bytes[at] - '0');
                significant += digits == 0 ? 0 : 1;
                decimals++;
            }
        }

        if (whole + decimals == 0 || significant > NcNumber.MaxDigits || decimals > NcNumber.MaxDigits)
        {
            return false;
        }

        next = at;
        number = new(negative ? -digits : digits, decimals);
        return true;
    }

    // The end of a computed value (#100, -#[1], [#1+2], =R1+5), or 0 where none begins.
    private readonly int ExpressionEnd(int at)
    {
        if (bytes[at] == '=')
        {
            var depth = 0;
            for (; at < end; at++)
            {
                depth += bytes[at] is (byte)'(' or (byte)'[' ? 1 : bytes[at] is (byte)')' or (byte)']' ? -1 : 0;
                if (depth <= 0 && bytes[at] is (byte)' ' or (byte)'\t' or (byte)';')
                {
                    break;
                }
            }

            return at;
        }

        if (bytes[at] is (byte)'-' or (byte)'+')
        {
            at++;
        }

        var hashes = at;
        while (at < end && bytes[at] == '#')
        {
            at++;
        }

        if (at < end && bytes[at] == '[')
        {
            return BehindBracket(at);
        }

        if (at == hashes)
        {
            return 0;
        }

        if (at < end && bytes[at] == '<')
        {
            return BehindName(at);
        }

        while (at < end && IsDigit(bytes[at]))
        {
            at++;
        }

        return at;
    }

    // Named variables and O words: #<depth>, o<pocket>.
    private readonly int BehindName(int at)
    {
        var close = bytes[at..end].IndexOf((byte)'>');
        return close < 0 ? end : at + close + 1;
    }

    private readonly int KeywordEnd()
    {
        var at = position;
        while (at < end && (IsLetter(bytes[at]) || IsDigit(bytes[at]) || bytes[at] is (byte)'_' or (byte)'$'))
        {
            at++;
        }

        if (at < end && bytes[at] == '(')
        {
            var depth = 0;
            for (; at < end; at++)
            {
                depth += bytes[at] == '(' ? 1 : bytes[at] == ')' ? -1 : 0;
                if (depth == 0)
                {
                    return at + 1;
                }
            }

            return end;
        }

        return at < end && bytes[at] == '=' ? ExpressionEnd(at) : at;
    }

    private readonly int BehindBracket(int at)
    {
        var depth = 0;
        for (; at < end; at++)
        {
            depth += bytes[at] == '[' ? 1 : bytes[at] == ']' ? -1 : 0;
            if (depth == 0)
            {
                return at + 1;
            }
        }

        return end;
    }

    private readonly int ToCommentOrEnd(int at)
    {
        var length = bytes[at..end].IndexOfAny((byte)'(', (byte)';');
        return length < 0 ? end : at + length;
    }
}
