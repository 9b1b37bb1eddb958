using System.Buffers;

namespace ErrorMatching.Nc;

/// <summary>Counts of a program's parts, and whether copying it piece by piece, as a rewriting does, gives the same bytes.</summary>
/// <param name="Blocks">Number of blocks (lines).</param>
/// <param name="Words">Number of words: letters with a number or an expression, comma words, and words of several letters.</param>
/// <param name="RoundTrips">True if the tokens and line ends of all blocks, copied in order, are the program's bytes.</param>
public sealed record NcCensus(int Blocks, long Words, bool RoundTrips)
{
    /// <summary>Counts and copies a program.</summary>
    public static NcCensus Of(NcProgram program)
    {
        var bytes = program.Bytes.Span;
        var copy = new ArrayBufferWriter<byte>(bytes.Length + 1);
        var words = 0L;
        for (var i = 0; i < program.BlockCount; i++)
        {
            var block = program[i];
            foreach (var token in program.Tokens(block))
            {
                words += token.Kind is NcTokenKind.Word
                    or NcTokenKind.ExpressionWord
                    or NcTokenKind.CommaWord
                    or NcTokenKind.PolarWord
                    or NcTokenKind.Keyword
                    ? 1
                    : 0;
                copy.Write(bytes.Slice(token.Start, token.Length));
            }

            copy.Write(bytes[block.End..(block.Start + block.FullLength)]);
        }

        return new(program.BlockCount, words, copy.WrittenSpan.SequenceEqual(bytes));
    }
}
