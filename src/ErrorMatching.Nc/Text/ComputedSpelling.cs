namespace ErrorMatching.Nc;

/// <summary>Values that the control computes, and words of several letters, in ISO and LinuxCNC spelling.</summary>
internal static class ComputedSpelling
{
    /// <summary>The end of a computed value (#100, -#[1], [#1+2], =R1+5, sin[30]); 0 if none begins here.</summary>
    public static int ComputedEnd(this in BlockScanner text, int at)
    {
        if (text.Bytes[at] == '=')
        {
            return text.Syntax == NcSyntax.LinuxCnc ? 0 : text.BehindEquals(at);
        }

        if (text.Bytes[at] is (byte)'-' or (byte)'+')
        {
            at = text.SkipSpaces(at + 1);
        }

        var hashes = at;
        while (at < text.End && text.Bytes[at] == '#')
        {
            at = text.SkipSpaces(at + 1);
        }

        if (at >= text.End)
        {
            return hashes < at ? text.End : 0;
        }

        if (text.Bytes[at] == '[')
        {
            return SyntaxBytes.BehindBracket(text.Bytes, at, text.End);
        }

        // LinuxCNC takes the number of a variable from a function, too: #atan[1]/[1].
        if (at == hashes || (text.Syntax == NcSyntax.LinuxCnc && SyntaxBytes.IsLetter(text.Bytes[at])))
        {
            return text.Syntax == NcSyntax.LinuxCnc ? text.FunctionEnd(at) : 0;
        }

        if (text.Bytes[at] == '<')
        {
            return text.BehindName(at);
        }

        while (at < text.End && SyntaxBytes.IsDigit(text.Bytes[at]))
        {
            at++;
        }

        return at;
    }

    // LinuxCNC allows functions without enclosing brackets: X sin[30], Z atan[1]/[2].
    private static int FunctionEnd(this in BlockScanner text, int at)
    {
        var name = at;
        while (at < text.End && SyntaxBytes.IsLetter(text.Bytes[at]))
        {
            at++;
        }

        if (!IsFunction(text.Bytes[name..at]))
        {
            return 0;
        }

        at = text.SkipSpaces(at);
        if (at >= text.End || text.Bytes[at] != '[')
        {
            return 0;
        }

        at = SyntaxBytes.BehindBracket(text.Bytes, at, text.End);
        var slash = text.SkipSpaces(at);
        if (slash < text.End && text.Bytes[slash] == '/' && text.SkipSpaces(slash + 1) is var second && second < text.End
            && text.Bytes[second] == '[')
        {
            at = SyntaxBytes.BehindBracket(text.Bytes, second, text.End);
        }

        return at;
    }

    private static bool IsFunction(ReadOnlySpan<byte> name)
    {
        foreach (var known in (ReadOnlySpan<string>)["ABS", "ACOS", "ASIN", "ATAN", "COS", "EXP", "EXISTS", "FIX", "FUP", "LN", "ROUND",
            "SIN", "SQRT", "TAN"])
        {
            if (System.Text.Ascii.EqualsIgnoreCase(name, known))
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>The end of an assignment. LinuxCNC allows words after it: #1=5 X#1.</summary>
    public static int AssignmentEnd(this in BlockScanner text, int at)
    {
        var variable = text.ComputedEnd(at);
        var equals = variable > at ? text.SkipSpaces(variable) : text.End;
        if (equals >= text.End || text.Bytes[equals] != '=')
        {
            return text.ToCommentOrEnd(at + 1);
        }

        var value = text.SkipSpaces(equals + 1);
        if (value < text.End && text.ReadNumber(value, out var behind, out _))
        {
            return behind;
        }

        return value < text.End && text.ComputedEnd(value) is > 0 and var end ? end : text.ToCommentOrEnd(at + 1);
    }

    /// <summary>The end of a word of several letters.</summary>
    public static int KeywordEnd(this in BlockScanner text, int at)
    {
        while (at < text.End && SyntaxBytes.IsNamePart(text.Bytes[at]))
        {
            at++;
        }

        if (at < text.End && text.Bytes[at] == '(')
        {
            return SyntaxBytes.BehindBracket(text.Bytes, at, text.End);
        }

        return at < text.End && text.Bytes[at] == '=' ? text.BehindEquals(at) : at;
    }
}
