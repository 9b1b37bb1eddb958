namespace ErrorMatching.Nc;

/// <content>Values that the control computes, and words of several letters, in ISO and LinuxCNC spelling.</content>
public ref partial struct NcTokenizer
{
    // The end of a computed value (#100, -#[1], [#1+2], =R1+5, sin[30]), or 0 where none begins.
    private readonly int ComputedEnd(int at)
    {
        if (_bytes[at] == '=')
        {
            return BehindEquals(at);
        }

        if (_bytes[at] is (byte)'-' or (byte)'+')
        {
            at = SkipSpaces(at + 1);
        }

        var hashes = at;
        while (at < _end && _bytes[at] == '#')
        {
            at = SkipSpaces(at + 1);
        }

        if (at >= _end)
        {
            return hashes < at ? _end : 0;
        }

        if (_bytes[at] == '[')
        {
            return SyntaxBytes.BehindBracket(_bytes, at, _end);
        }

        if (at == hashes)
        {
            return _syntax == NcSyntax.LinuxCnc ? FunctionEnd(at) : 0;
        }

        if (_bytes[at] == '<')
        {
            return BehindName(at);
        }

        while (at < _end && SyntaxBytes.IsDigit(_bytes[at]))
        {
            at++;
        }

        return at;
    }

    // LinuxCNC takes functions without brackets around them: X sin[30], Z atan[1]/[2].
    private readonly int FunctionEnd(int at)
    {
        var name = at;
        while (at < _end && SyntaxBytes.IsLetter(_bytes[at]))
        {
            at++;
        }

        if (!IsFunction(_bytes[name..at]))
        {
            return 0;
        }

        at = SkipSpaces(at);
        if (at >= _end || _bytes[at] != '[')
        {
            return 0;
        }

        at = SyntaxBytes.BehindBracket(_bytes, at, _end);
        var slash = SkipSpaces(at);
        if (slash < _end && _bytes[slash] == '/' && SkipSpaces(slash + 1) is var second && second < _end && _bytes[second] == '[')
        {
            at = SyntaxBytes.BehindBracket(_bytes, second, _end);
        }

        return at;
    }

    private static bool IsFunction(ReadOnlySpan<byte> name)
    {
        foreach (var known in (ReadOnlySpan<string>)["ABS", "ACOS", "ASIN", "ATAN", "COS", "EXP", "EXISTS", "FIX", "FUP", "LN", "ROUND", "SIN", "SQRT", "TAN"])
        {
            if (System.Text.Ascii.EqualsIgnoreCase(name, known))
            {
                return true;
            }
        }

        return false;
    }

    // LinuxCNC allows words behind an assignment: #1=5 X#1.
    private readonly int AssignmentEnd(int at)
    {
        var variable = ComputedEnd(at);
        var equals = variable > at ? SkipSpaces(variable) : _end;
        if (equals >= _end || _bytes[equals] != '=')
        {
            return ToCommentOrEnd(at + 1);
        }

        var value = SkipSpaces(equals + 1);
        if (value < _end && ReadNumber(value, out var behind, out _))
        {
            return behind;
        }

        return value < _end && ComputedEnd(value) is > 0 and var end ? end : ToCommentOrEnd(at + 1);
    }

    private readonly int BehindEquals(int at)
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

    // Named variables and O words: #<depth>, o<pocket>.
    private readonly int BehindName(int at)
    {
        var close = _bytes[at.._end].IndexOf((byte)'>');
        return close < 0 ? _end : at + close + 1;
    }

    private readonly int KeywordEnd()
    {
        var at = _position;
        while (at < _end && SyntaxBytes.IsNamePart(_bytes[at]))
        {
            at++;
        }

        if (at < _end && _bytes[at] == '(')
        {
            return SyntaxBytes.BehindBracket(_bytes, at, _end);
        }

        return at < _end && _bytes[at] == '=' ? BehindEquals(at) : at;
    }

    private readonly int ToCommentOrEnd(int at)
    {
        var length = _bytes[at.._end].IndexOfAny((byte)'(', (byte)';');
        return length < 0 ? _end : at + length;
    }
}
