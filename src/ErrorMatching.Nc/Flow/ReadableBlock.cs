namespace ErrorMatching.Nc;

/// <summary>Distinguishes text that a control would execute as a block from text for people.</summary>
internal static class ReadableBlock
{
    /// <summary>True if the text has words and otherwise only spaces and comments.</summary>
    /// <param name="bytes">The program's bytes.</param>
    /// <param name="start">First byte of the text.</param>
    /// <param name="end">First byte after it.</param>
    /// <param name="dialect">Knows the multi-letter words of the control.</param>
    public static bool Is(ReadOnlySpan<byte> bytes, int start, int end, NcDialect dialect)
    {
        var hasWords = false;
        foreach (var token in new NcTokenizer(bytes, start, end, dialect.Syntax))
        {
            switch (token.Kind)
            {
                case NcTokenKind.Space or NcTokenKind.Comment or NcTokenKind.BlockSkip or NcTokenKind.Label:
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

    /// <summary>True if there are words after a semicolon that ends a block: in the rest of the line or after another semicolon in
    /// it.</summary>
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
