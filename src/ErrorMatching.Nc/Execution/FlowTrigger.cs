namespace ErrorMatching.Nc;

/// <summary>Which blocks the machine must see: those that assign, branch, call, return, end, or begin a program.</summary>
internal static class FlowTrigger
{
    /// <summary>True if a block must be given to <see cref="NcFlow.Before"/>. Answering true for another block costs time and nothing else.</summary>
    public static bool Concerns(ReadOnlySpan<byte> text, NcSyntax syntax)
    {
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
                // What stands behind a comment in a comment can be either; the tokens decide.
                var close = text[at..].IndexOf((byte)')');
                if (text.Slice(at + 1, close).Contains((byte)'('))
                {
                    return true;
                }

                at += close;
                continue;
            }

            if (c is (byte)'#' or (byte)'%' || (syntax == NcSyntax.Siemens && c is (byte)'=' or (byte)':' or (byte)'_'))
            {
                return true;
            }

            if (SyntaxBytes.IsLetter(c) && ConcernsWord(text, at, (byte)(c & ~0x20), syntax))
            {
                return true;
            }
        }

        return false;
    }

    private static bool ConcernsWord(ReadOnlySpan<byte> text, int at, byte letter, NcSyntax syntax)
    {
        var number = BlockHead.NumberAt(text, at + 1);
        var next = number.Start < text.Length ? text[number.Start] : (byte)0;
        return letter switch
        {
            (byte)'O' => true,
            (byte)'M' => number.Length == 0 || number.Value is 2 or 17 or 30 or 98 or 99,
            (byte)'G' => syntax == NcSyntax.Iso && (number.Length == 0 || number.Value is 65 or 66 or 67),
            (byte)'L' => syntax == NcSyntax.Siemens,
            _ => SyntaxBytes.IsLetter(next),
        };
    }
}
