namespace ErrorMatching.Nc;

/// <summary>Whether a stretch of text would be a block to a control, as against text for people.</summary>
internal static class ReadableBlock
{
    /// <summary>True if the stretch has words, and nothing but words, spaces and comments.</summary>
    /// <param name="bytes">The program's bytes.</param>
    /// <param name="start">First byte of the stretch.</param>
    /// <param name="end">First byte behind it.</param>
    /// <param name="dialect">Says which words of several letters the control has.</param>
    public static bool Is(ReadOnlySpan<byte> bytes, int start, int end, NcDialect dialect)
    {
        var hasWords = false;
        foreach (var token in new NcTokenizer(bytes, start, end, dialect.Syntax))
        {
            switch (token.Kind)
            {
                case NcTokenKind.Space or NcTokenKind.Comment or NcTokenKind.BlockSkip:
                    break;
                case NcTokenKind.Word or NcTokenKind.ExpressionWord or NcTokenKind.CommaWord or NcTokenKind.Assignment:
                    hasWords = true;
                    break;
                case NcTokenKind.Keyword when IsWord(bytes.Slice(token.Start, token.Length), dialect):
                    hasWords = true;
                    break;
                case NcTokenKind.Expression when hasWords:
                    break;
                default:
                    return false;
            }
        }

        return hasWords;
    }

    /// <summary>
    /// True if words stand behind a semicolon that ends a block: in the rest of the line or behind another semicolon in it.
    /// </summary>
    public static bool StandsBehind(ReadOnlySpan<byte> bytes, NcToken semicolon, NcDialect dialect)
    {
        for (var at = semicolon.Start; at >= 0;)
        {
            if (Is(bytes, at + 1, semicolon.End, dialect))
            {
                return true;
            }

            at = NextSemicolon(bytes, at + 1, semicolon.End, dialect.Syntax);
        }

        return false;
    }

    private static int NextSemicolon(ReadOnlySpan<byte> bytes, int start, int end, NcSyntax syntax)
    {
        foreach (var token in new NcTokenizer(bytes, start, end, syntax))
        {
            if (token.Kind == NcTokenKind.Comment && bytes[token.Start] == ';')
            {
                return token.Start;
            }
        }

        return -1;
    }

    private static bool IsWord(ReadOnlySpan<byte> keyword, NcDialect dialect)
    {
        var name = keyword[..BlockHead.NameLength(keyword, 0)];
        return dialect.MeaningOf(name) != NcMeaning.Unknown || dialect.IsFlow(name) || dialect.IsFlow(name.TrimEnd("0123456789"u8));
    }
}
