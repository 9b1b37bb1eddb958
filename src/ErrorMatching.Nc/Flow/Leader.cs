namespace ErrorMatching.Nc;

/// <summary>What paper tapes and serial lines leave before a program's first percent sign: controls ignore everything before it.</summary>
internal static class Leader
{
    private const byte Percent = (byte)'%';

    /// <summary>Number of blocks in the leader, including the one with the percent sign; 0 if there is none. Blocks with words are never
    /// a leader: a percent sign after them ends a program.</summary>
    public static int BlocksOf(NcProgram program, NcDialect dialect)
    {
        var bytes = program.Bytes.Span;
        var isLeader = false;
        for (var i = 0; i < program.BlockCount && dialect.Syntax == NcSyntax.Iso; i++)
        {
            var block = program[i];
            var text = program.BytesOf(block);
            var at = BlockHead.Read(text, NcSyntax.Iso).At;
            if (at >= text.Length)
            {
                continue;
            }

            if (text[at] == Percent)
            {
                return isLeader ? i + 1 : 0;
            }

            if (ReadableBlock.Is(bytes, block.Start, block.End, dialect))
            {
                return 0;
            }

            isLeader = true;
            var percent = text.IndexOf(Percent);
            if (percent >= 0)
            {
                return ReadableBlock.Is(bytes, block.Start, block.Start + percent, dialect) ? 0 : i + 1;
            }
        }

        return 0;
    }
}
