namespace ErrorMatching.Nc;

/// <summary>Counts of a program's parts, and whether copying it piece by piece, as a rewriting does, gives the same bytes.</summary>
/// <param name="Blocks">Number of blocks (lines).</param>
/// <param name="Words">Number of words: letters with a number or an expression, comma words, and words of several letters.</param>
/// <param name="RoundTrips">True if the tokens and line ends of all blocks, copied in order, are the program's bytes.</param>
public sealed record NcCensus(int Blocks, long Words, bool RoundTrips)
{
    /// <summary>Counts the parts of a program and checks that they join.</summary>
    public static NcCensus Of(NcProgram program)
    {
        if (program.BlockCount < TwoThreads.Many)
        {
            return Of(program, 0, program.BlockCount);
        }

        var (first, second) = TwoThreads.Run(0, program.BlockCount, (from, end) => Of(program, from, end));
        return new(program.BlockCount, first.Words + second.Words, first.RoundTrips && second.RoundTrips);
    }

    // A copy has the same bytes if each piece begins where the one before ends, from the first byte to the last.
    private static NcCensus Of(NcProgram program, int from, int end)
    {
        var (plain, ways, words) = (new BlockWords(), ControlWays.Of(program.Syntax), 0L);
        var (at, joins) = (from == 0 ? 0 : EndOf(program, from - 1), true);
        for (var i = from; i < end; i++)
        {
            var block = program[i];
            joins &= block.Start == at;
            at = block.Start + block.FullLength;
            if (plain.TryReadPlain(program.BytesOf(block), ways))
            {
                words += plain.Count;
                continue;
            }

            var joint = block.Start;
            foreach (ref readonly var token in program.Tokens(block))
            {
                words += token.Kind is NcTokenKind.Word
                    or NcTokenKind.ExpressionWord
                    or NcTokenKind.CommaWord
                    or NcTokenKind.PolarWord
                    or NcTokenKind.Keyword
                    ? 1
                    : 0;
                joins &= token.Start == joint;
                joint = token.End;
            }

            joins &= joint == block.End;
        }

        return new(end - from, words, joins && (end < program.BlockCount || at == program.Bytes.Length));
    }

    private static int EndOf(NcProgram program, int block) => program[block].Start + program[block].FullLength;
}
