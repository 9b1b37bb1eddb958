using System.Text;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>The blocks in which two programs differ, with context, for reports to show side by side.</summary>
internal static class ProgramRows
{
    /// <summary>Rows of context before and after a row that differs.</summary>
    private const int Context = 3;

    /// <summary>The rows, in the order of the programs.</summary>
    public static IReadOnlyList<ReportBlock> Of(MotionComparison comparison)
    {
        var rows = SideBySide.Of(comparison);
        var blocks = new List<ReportBlock>();
        var next = 0;
        for (var i = 0; i < rows.Count; i++)
        {
            if (!rows[i].IsSame)
            {
                for (next = Math.Max(next, i - Context); next <= Math.Min(i + Context, rows.Count - 1); next++)
                {
                    blocks.Add(Block(comparison.Before.Program, comparison.After.Program, rows[next]));
                }
            }
        }

        return blocks;
    }

    private static ReportBlock Block(NcProgram before, NcProgram after, BlockPair row)
    {
        if (row.Before < 0)
        {
            var block = after[row.After];
            return new(after.NumberOf(block), block.Line, "", Text(after, block), [], [new(0, block.Length)]);
        }

        var was = before[row.Before];
        if (row.After < 0)
        {
            return new(before.NumberOf(was), was.Line, Text(before, was), "", [new(0, was.Length)], []);
        }

        var now = after[row.After];
        var (old, fresh) = row.IsSame ? ([], []) : SideBySide.Words(before, was, after, now);
        return new(before.NumberOf(was), was.Line, Text(before, was), Text(after, now), Spans(old, was), Spans(fresh, now));
    }

    private static List<TextSpan> Spans(IReadOnlyList<Range> words, NcBlock block)
    {
        var spans = new List<TextSpan>();
        foreach (var word in words)
        {
            var (start, length) = word.GetOffsetAndLength(block.Length);
            spans.Add(new(start, length));
        }

        return spans;
    }

    // One character per byte, so that spans match in both.
    private static string Text(NcProgram program, NcBlock block) => Encoding.Latin1.GetString(program.BytesOf(block));
}
