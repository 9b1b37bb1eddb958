using System.Text;
using ErrorMatching.Nc;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>A block of the program before and after, to show side by side.</summary>
/// <param name="Number">Its number as written (<c>N110</c>); empty if it has none.</param>
/// <param name="Line">Its line in the original program, from 1.</param>
/// <param name="Original">Its text in the original program; empty for an inserted block.</param>
/// <param name="Modified">Its text in the new program.</param>
/// <param name="OriginalSpans">The replaced parts of the original text.</param>
/// <param name="ModifiedSpans">Their replacements in the new text.</param>
public sealed record ReportBlock(
    string Number,
    int Line,
    string Original,
    string Modified,
    IReadOnlyList<TextSpan> OriginalSpans,
    IReadOnlyList<TextSpan> ModifiedSpans)
{
    /// <summary>Writes it into the open object.</summary>
    internal void Write(ReportWriter w)
    {
        w.Text("number", Number);
        w.Count("line", Line);
        w.Text("original", Original);
        w.Text("modified", Modified);
        w.List("originalSpans", OriginalSpans, s => s.Write(w));
        w.List("modifiedSpans", ModifiedSpans, s => s.Write(w));
    }

    /// <summary>Reads what <see cref="Write"/> writes.</summary>
    internal static ReportBlock Read(ReportReader r)
    {
        var (original, modified) = (r.Text("original"), r.Text("modified"));
        return new(
            r.Text("number"),
            r.Count("line"),
            original,
            modified,
            r.List("originalSpans", s => TextSpan.Read(s, original)),
            r.List("modifiedSpans", s => TextSpan.Read(s, modified)));
    }
}

/// <summary>A range of a text.</summary>
/// <param name="Start">Index of its first character, from 0.</param>
/// <param name="Length">Number of characters.</param>
public sealed record TextSpan(int Start, int Length)
{
    /// <summary>Writes it into the open object.</summary>
    internal void Write(ReportWriter w)
    {
        w.Count("start", Start);
        w.Count("length", Length);
    }

    /// <summary>Reads what <see cref="Write"/> writes.</summary>
    /// <param name="r">The object.</param>
    /// <param name="text">The text that the range is in.</param>
    internal static TextSpan Read(ReportReader r, string text)
    {
        var (start, length) = (r.Count("start"), r.Count("length"));
        return start <= text.Length - length ? new(start, length) : throw r.Refusal("length", "too-large", "a range of the text");
    }
}

/// <summary>Shows the changes of a rewrite block by block, with the changed words marked.</summary>
internal static class BlockDifference
{
    /// <summary>The changed blocks, in the order of the program.</summary>
    /// <param name="before">The original program.</param>
    /// <param name="rewrite">The changes.</param>
    public static IReadOnlyList<ReportBlock> Of(NcProgram before, Rewrite rewrite)
    {
        var blocks = new List<ReportBlock>();
        var next = 0;
        foreach (var index in rewrite.ChangedBlocks.Order())
        {
            var block = before[index];
            var (was, now) = (new List<TextSpan>(), new List<TextSpan>());
            var shift = 0;
            for (; next < rewrite.Patches.Count && rewrite.Patches[next].Start <= block.End; next++)
            {
                var patch = rewrite.Patches[next];
                var start = patch.Start - block.Start;
                was.Add(new(start, patch.Length));
                now.Add(new(start + shift, patch.Bytes.Length));
                shift += patch.Bytes.Length - patch.Length;
            }

            var modified = rewrite.Program[index];
            blocks.Add(new(
                before.NumberOf(block),
                block.Line,
                CharacterPerByte(before, block),
                CharacterPerByte(rewrite.Program, modified),
                was,
                now));
        }

        return blocks;
    }

    // One character per byte, so that spans match in both; comments in other encodings show their bytes.
    private static string CharacterPerByte(NcProgram program, NcBlock block) =>
        System.Text.Encoding.Latin1.GetString(program.BytesOf(block));
}

/// <summary>The blocks in which two programs differ, with context, for reports to show side by side.</summary>
internal static class DifferenceRows
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
