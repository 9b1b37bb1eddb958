namespace ErrorMatching.Nc;

/// <summary>Finds the blocks that the flow must see: those that assign, branch, call, return, end, or begin a program.</summary>
internal static class FlowTrigger
{
    /// <summary>True if a block must be given to <see cref="NcFlow.ExecuteStatements"/>. Returning true for another block only costs
    /// time.</summary>
    public static bool Concerns(ReadOnlySpan<byte> text, NcDialect dialect)
    {
        if (!dialect.HasMacros)
        {
            return text.Contains((byte)'%');
        }

        var syntax = dialect.Syntax;
        if (LanguageSpelling.Of(syntax) is { } language)
        {
            return Concerns(text, dialect, language);
        }

        var lastClose = text.LastIndexOf((byte)')');
        for (var at = 0; at < text.Length; at++)
        {
            var c = text[at];
            if (c == ';')
            {
                return false;
            }

            if (c == '(' && syntax != NcSyntax.Siemens && at < lastClose)
            {
                // Text after a comment inside a comment can be either; the tokens decide.
                var close = text[at..].IndexOf((byte)')');
                if (text.Slice(at + 1, close).Contains((byte)'('))
                {
                    return true;
                }

                at += close;
                continue;
            }

            if (c is (byte)'#' or (byte)'%'
                || (syntax == NcSyntax.Iso && c == '<')
                || (syntax == NcSyntax.Siemens && c is (byte)'=' or (byte)':' or (byte)'_'))
            {
                return true;
            }

            if (SyntaxBytes.IsLetter(c) && ConcernsWord(text, at, (byte)(c & ~0x20), dialect))
            {
                return true;
            }
        }

        return false;
    }

    private static bool Concerns(ReadOnlySpan<byte> text, NcDialect dialect, LanguageSpelling language)
    {
        foreach (ref readonly var token in new NcTokenizer(text, 0, text.Length, dialect.Syntax))
        {
            var concerns = token.Kind switch
            {
                NcTokenKind.Assignment or NcTokenKind.Percent => true,
                NcTokenKind.Label => language.IsHeading(text.Slice(token.Start, token.Length)),
                NcTokenKind.Keyword => language.NameOf(text.Slice(token.Start, token.Length)) is var name
                    && (dialect.IsFlow(name) || dialect.IsFlow(name.TrimEnd("0123456789"u8)) || dialect.MeaningOf(name).Steers()),
                NcTokenKind.Word when token.Letter == 'O' => true,
                NcTokenKind.Word when token.Letter == 'M' =>
                    dialect.FunctionOf((int)Math.Clamp(token.Number.Digits, -1, int.MaxValue)).Steers(),
                _ => false,
            };
            if (concerns)
            {
                return true;
            }
        }

        return false;
    }

    private static bool ConcernsWord(ReadOnlySpan<byte> text, int at, byte letter, NcDialect dialect)
    {
        var number = BlockHead.NumberAt(text, at + 1);
        var next = number.Start < text.Length ? text[number.Start] : (byte)0;
        return letter switch
        {
            (byte)'O' => true,
            (byte)'M' => number.Length == 0 || dialect.FunctionOf((int)Math.Min(number.Value, int.MaxValue)).Steers(),
            (byte)'G' when number.Length == 0 => dialect.Syntax == NcSyntax.Iso,
            (byte)'G' => Calls(text, number.Start + number.Length, number.Value, dialect),
            (byte)'L' => dialect.Syntax == NcSyntax.Siemens,
            _ => SyntaxBytes.IsLetter(next),
        };
    }

    private static bool Calls(ReadOnlySpan<byte> text, int behind, long code, NcDialect dialect)
    {
        var tenth = behind + 1 < text.Length && text[behind] == '.' && SyntaxBytes.IsDigit(text[behind + 1]) ? text[behind + 1] - '0' : 0;
        return code < 1000 && dialect.MeaningOf((10 * (int)code) + tenth).Steers();
    }
}
