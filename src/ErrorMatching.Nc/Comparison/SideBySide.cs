using System.Text;

namespace ErrorMatching.Nc;

/// <summary>Two programs side by side: blocks of corresponding motions share a row, and so do blocks with the same text between
/// them.</summary>
public static class SideBySide
{
    /// <summary>All rows, in the order of both programs.</summary>
    public static IReadOnlyList<BlockPair> Of(MotionComparison comparison)
    {
        var (before, after) = (comparison.Before.Program, comparison.After.Program);
        var rows = new List<BlockPair>();
        var (b, a) = (0, 0);
        foreach (var (i, j) in comparison.Pairs)
        {
            var (block, other) = (comparison.Before.Motions[i].Block, comparison.After.Motions[j].Block);
            if (block >= b && other >= a)
            {
                AddBetween(before, b, block, after, a, other, rows);
                rows.Add(Row(before, block, after, other));
                (b, a) = (block + 1, other + 1);
            }
        }

        AddBetween(before, b, before.BlockCount, after, a, after.BlockCount, rows);
        return rows;
    }

    /// <summary>The words of two blocks that differ in value, without block numbers: ranges of bytes from the start of each
    /// block.</summary>
    public static (IReadOnlyList<Range> Before, IReadOnlyList<Range> After) Words(
        NcProgram before, NcBlock block, NcProgram after, NcBlock other)
    {
        var known = new Dictionary<string, int>(StringComparer.Ordinal);
        var (was, now) = (Read(before, block), Read(after, other));
        var same = CommonSubsequence.Of([.. was.Select(w => Number(w.Text, known))], [.. now.Select(w => Number(w.Text, known))]);
        var (sameBefore, sameAfter) = (same.Select(p => p.First).ToHashSet(), same.Select(p => p.Second).ToHashSet());
        return (
            [.. was.Where((_, i) => !sameBefore.Contains(i)).Select(w => w.Place)],
            [.. now.Where((_, i) => !sameAfter.Contains(i)).Select(w => w.Place)]);
    }

    private static void AddBetween(NcProgram before, int b, int endBefore, NcProgram after, int a, int endAfter, List<BlockPair> rows)
    {
        if (b == endBefore && a == endAfter)
        {
            return;
        }

        var known = new Dictionary<string, int>(StringComparer.Ordinal);
        var (first, second) = (Numbers(before, b, endBefore, known), Numbers(after, a, endAfter, known));
        var (i, j) = (b, a);
        foreach (var (nextI, nextJ) in CommonSubsequence.Of(first, second)
            .ConvertAll(p => (p.First + b, p.Second + a))
            .Append((endBefore, endAfter)))
        {
            // Equal numbers of blocks on both sides count as changed, not replaced.
            for (var isPaired = nextI - i == nextJ - j; i < nextI; i++)
            {
                rows.Add(isPaired ? Row(before, i, after, j++) : new(i, -1, false));
            }

            for (; j < nextJ; j++)
            {
                rows.Add(new(-1, j, false));
            }

            if (nextI < endBefore && nextJ < endAfter)
            {
                rows.Add(Row(before, nextI, after, nextJ));
            }

            (i, j) = (nextI + 1, nextJ + 1);
        }
    }

    private static BlockPair Row(NcProgram before, int block, NcProgram after, int other) =>
        new(
            block,
            other,
            before.BytesOf(before[block]).SequenceEqual(after.BytesOf(after[other]))
                || Read(before, before[block]).Select(w => w.Text).SequenceEqual(
                    Read(after, after[other]).Select(w => w.Text), StringComparer.Ordinal));

    private static int[] Numbers(NcProgram program, int start, int end, Dictionary<string, int> known)
    {
        var numbers = new int[end - start];
        for (var i = 0; i < numbers.Length; i++)
        {
            numbers[i] = Number(Encoding.Latin1.GetString(program.BytesOf(program[start + i])), known);
        }

        return numbers;
    }

    private static int Number(string text, Dictionary<string, int> known)
    {
        if (!known.TryGetValue(text, out var number))
        {
            known.Add(text, number = known.Count);
        }

        return number;
    }

    // The words except the block number, each as a text that does not depend on the spelling of its value.
    private static List<(string Text, Range Place)> Read(NcProgram program, NcBlock block)
    {
        var words = new List<(string, Range)>();
        foreach (var token in program.Tokens(block))
        {
            if (token.Kind != NcTokenKind.Space && token is not { Kind: NcTokenKind.Word, Letter: (byte)'N' })
            {
                var text = token.Kind == NcTokenKind.Word
                    ? $"{(char)token.Letter}{token.Number.Trim()}"
                    : Encoding.Latin1.GetString(program.Bytes.Span.Slice(token.Start, token.Length));
                words.Add((text, (token.Start - block.Start)..(token.End - block.Start)));
            }
        }

        return words;
    }
}

/// <summary>A row of two programs shown side by side.</summary>
/// <param name="Before">Position of a block in the first program; -1 if only the second has a block here.</param>
/// <param name="After">Position of a block in the second program; -1 if only the first has a block here.</param>
/// <param name="IsSame">True if both blocks have the same words with the same values, regardless of block numbers and spaces.</param>
public readonly record struct BlockPair(int Before, int After, bool IsSame);
