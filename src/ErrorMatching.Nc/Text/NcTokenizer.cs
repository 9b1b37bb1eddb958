namespace ErrorMatching.Nc;

/// <summary>
/// Walks over a block's tokens without allocating. Spelling only: every byte belongs to exactly one token, and what no rule explains is
/// <see cref="NcTokenKind.Invalid"/>, never dropped.
/// </summary>
public ref struct NcTokenizer
{
    private readonly ReadOnlySpan<byte> _bytes;
    private readonly int _end;
    private int _position;
    private bool _atStart;

    internal NcTokenizer(ReadOnlySpan<byte> bytes, int start, int end)
    {
        _bytes = bytes;
        _end = end;
        _position = start;
        _atStart = true;
        Current = default;
    }

    /// <summary>The token last read.</summary>
    public NcToken Current { get; private set; }

    /// <summary>The tokenizer itself, so that <c>foreach</c> works.</summary>
    public readonly NcTokenizer GetEnumerator() => this;

    /// <summary>Reads the next token; false at the end of the block.</summary>
    public bool MoveNext()
    {
        if (_position >= _end)
        {
            return false;
        }

        var c = _bytes[_position];
        if ((uint)((c | 0x20) - 'a') < 26)
        {
            ReadLetter((byte)(c & ~0x20));
            _atStart &= Current is { Kind: NcTokenKind.Word, Letter: (byte)'N' };
            return true;
        }

        switch (c)
        {
            case (byte)' ' or (byte)'\t':
                Plain(NcTokenKind.Space, SkipSpaces(_position + 1));
                break;
            case (byte)'(':
                ReadComment();
                break;
            case (byte)';':
                Plain(NcTokenKind.Comment, _end);
                break;
            case (byte)'%':
                Plain(NcTokenKind.Percent, _end);
                break;
            // A slash stands at the beginning of a block or behind its number (N10 /1 G0); elsewhere it divides.
            case (byte)'/' when _atStart:
                Plain(NcTokenKind.BlockSkip, _position + 1 < _end && IsDigit(_bytes[_position + 1]) ? _position + 2 : _position + 1);
                break;
            case (byte)',':
                ReadCommaWord();
                break;
            case (byte)'#':
                Plain(NcTokenKind.Assignment, ToCommentOrEnd(_position + 1));
                break;
            case (byte)'[':
                Plain(NcTokenKind.Expression, BehindBracket(_position));
                break;
            case (byte)'"':
                var close = _bytes[(_position + 1).._end].IndexOf((byte)'"');
                Plain(NcTokenKind.Invalid, close < 0 ? _end : _position + close + 2);
                break;
            default:
                Plain(NcTokenKind.Invalid, _position + 1);
                break;
        }

        _atStart &= Current.Kind is NcTokenKind.Space or NcTokenKind.BlockSkip;
        return true;
    }

    private static bool IsDigit(byte c) => (uint)(c - '0') < 10;

    private static bool IsLetter(byte c) => (uint)((c | 0x20) - 'a') < 26;

    private void Plain(NcTokenKind kind, int next, byte letter = 0)
    {
        Current = new(kind, letter, _position, next - _position, _position, default);
        _position = next;
    }

    private readonly int SkipSpaces(int at)
    {
        while (at < _end && _bytes[at] is (byte)' ' or (byte)'\t')
        {
            at++;
        }

        return at;
    }

    private void ReadComment()
    {
        var depth = 0;
        for (var at = _position; at < _end; at++)
        {
            if (_bytes[at] == '(')
            {
                depth++;
            }
            else if (_bytes[at] == ')' && --depth == 0)
            {
                Plain(NcTokenKind.Comment, at + 1);
                return;
            }
        }

        // Without a partner for every parenthesis the first closing one ends the comment, as most controls read it.
        var close = _bytes[_position.._end].IndexOf((byte)')');
        Plain(close < 0 ? NcTokenKind.Invalid : NcTokenKind.Comment, close < 0 ? _end : _position + close + 1);
    }

    private void ReadCommaWord()
    {
        var letterAt = SkipSpaces(_position + 1);
        if (letterAt < _end && IsLetter(_bytes[letterAt]) && ReadNumber(SkipSpaces(letterAt + 1), out var next, out var number))
        {
            Current = new(NcTokenKind.CommaWord, (byte)(_bytes[letterAt] & ~0x20), _position, next - _position, SkipSpaces(letterAt + 1), number);
            _position = next;
            return;
        }

        Plain(NcTokenKind.Invalid, _position + 1);
    }

    private void ReadLetter(byte letter)
    {
        var valueAt = SkipSpaces(_position + 1);
        if (ReadNumber(valueAt, out var next, out var number))
        {
            Current = new(NcTokenKind.Word, letter, _position, next - _position, valueAt, number);
            _position = next;
        }
        else if (letter == 'O' && valueAt < _end && _bytes[valueAt] == '<')
        {
            Plain(NcTokenKind.ExpressionWord, BehindName(valueAt), letter);
        }
        else if (valueAt < _end && ExpressionEnd(valueAt) is > 0 and var behind)
        {
            Plain(NcTokenKind.ExpressionWord, behind, letter);
        }
        else if (_position + 1 < _end && IsLetter(_bytes[_position + 1]))
        {
            Plain(NcTokenKind.Keyword, KeywordEnd());
        }
        else
        {
            Plain(NcTokenKind.Invalid, _position + 1, letter);
        }
    }

    // Sign, digits, point, digits. More digits than are exact make the word invalid rather than wrong.
    private readonly bool ReadNumber(int at, out int next, out NcNumber number)
    {
        next = at;
        number = default;
        if (at >= _end)
        {
            return false;
        }

        var negative = _bytes[at] == '-';
        if (negative || _bytes[at] == '+')
        {
            at++;
        }

        long digits = 0;
        var (first, significant, decimals) = (at, 0, 0);
        for (; at < _end && IsDigit(_bytes[at]) && significant <= NcNumber.MaxDigits; at++)
        {
            digits = (digits * 10) + (_bytes[at] - '0');
            significant += digits == 0 ? 0 : 1;
        }

        var whole = at - first;
        if (at < _end && _bytes[at] == '.')
        {
            for (at++; at < _end && IsDigit(_bytes[at]) && significant <= NcNumber.MaxDigits && decimals <= NcNumber.MaxDigits; at++)
            {
                digits = (digits * 10) + (_bytes[at] - '0');
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
        if (_bytes[at] == '=')
        {
            var depth = 0;
            for (; at < _end; at++)
            {
                depth += _bytes[at] is (byte)'(' or (byte)'[' ? 1 : _bytes[at] is (byte)')' or (byte)']' ? -1 : 0;
                if (depth <= 0 && _bytes[at] is (byte)' ' or (byte)'\t' or (byte)';')
                {
                    break;
                }
            }

            return at;
        }

        if (_bytes[at] is (byte)'-' or (byte)'+')
        {
            at++;
        }

        var hashes = at;
        while (at < _end && _bytes[at] == '#')
        {
            at++;
        }

        if (at < _end && _bytes[at] == '[')
        {
            return BehindBracket(at);
        }

        if (at == hashes)
        {
            return 0;
        }

        if (at < _end && _bytes[at] == '<')
        {
            return BehindName(at);
        }

        while (at < _end && IsDigit(_bytes[at]))
        {
            at++;
        }

        return at;
    }

    // Named variables and O words: #<depth>, o<pocket>.
    private readonly int BehindName(int at)
    {
        var close = _bytes[at.._end].IndexOf((byte)'>');
        return close < 0 ? _end : at + close + 1;
    }

    private readonly int KeywordEnd()
    {
        var at = _position;
        while (at < _end && (IsLetter(_bytes[at]) || IsDigit(_bytes[at]) || _bytes[at] is (byte)'_' or (byte)'$'))
        {
            at++;
        }

        if (at < _end && _bytes[at] == '(')
        {
            var depth = 0;
            for (; at < _end; at++)
            {
                depth += _bytes[at] == '(' ? 1 : _bytes[at] == ')' ? -1 : 0;
                if (depth == 0)
                {
                    return at + 1;
                }
            }

            return _end;
        }

        return at < _end && _bytes[at] == '=' ? ExpressionEnd(at) : at;
    }

    private readonly int BehindBracket(int at)
    {
        var depth = 0;
        for (; at < _end; at++)
        {
            depth += _bytes[at] == '[' ? 1 : _bytes[at] == ']' ? -1 : 0;
            if (depth == 0)
            {
                return at + 1;
            }
        }

        return _end;
    }

    private readonly int ToCommentOrEnd(int at)
    {
        var length = _bytes[at.._end].IndexOfAny((byte)'(', (byte)';');
        return length < 0 ? _end : at + length;
    }
}
