namespace ErrorMatching.Nc;

/// <content>Every byte outside the coordinate words of moved blocks must be the original's.</content>
public sealed partial class Prover
{
    private bool CompareBytes(int markerBlock, HashSet<int> changed)
    {
        var identical = true;
        var (was, now) = (before.Program, after.Program);
        for (var i = 0; i < was.BlockCount; i++)
        {
            var (a, b) = (was[i], now[InResult(i, markerBlock)]);
            if (was.Bytes.Span.Slice(a.Start, a.FullLength).SequenceEqual(now.Bytes.Span.Slice(b.Start, b.FullLength)))
            {
                continue;
            }

            if (!changed.Contains(i))
            {
                Fail(i, "its text differs although its motion does not.");
                identical = false;
            }
            else if (!Skeleton(was, a).SequenceEqual(Skeleton(now, b)))
            {
                Fail(i, "something other than coordinates changed in it.");
                identical = false;
            }
        }

        return identical;
    }

    // The block without its coordinate and center words and without spaces: what must not change.
    private static List<byte> Skeleton(NcProgram program, NcBlock block)
    {
        var rest = new List<byte>(block.FullLength);
        foreach (var token in program.Tokens(block))
        {
            if (token.Kind != NcTokenKind.Space && !(token.Kind == NcTokenKind.Word && token.Letter is >= (byte)'X' and <= (byte)'Z' or >= (byte)'I' and <= (byte)'K' or (byte)'R'))
            {
                rest.AddRange(program.Bytes.Span.Slice(token.Start, token.Length));
            }
        }

        rest.AddRange(program.Bytes.Span[block.End..(block.Start + block.FullLength)]);
        return rest;
    }
}
