using System.Globalization;
using System.Text;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary>Two programs side by side where they differ, with <see cref="Context"/> rows of context. A row starts with <c>~</c> if it
/// changed, with <c>-</c> if only the first program has it, with <c>+</c> if only the second has it. Changed words are colored on a
/// terminal and in braces elsewhere.</summary>
internal static class ShownBlocks
{
    private const int Context = 3;
    private const int RowsShown = 200;
    private const int WidestColumn = 60;

    /// <summary>Writes the rows.</summary>
    public static void Write(Page page, MotionComparison comparison)
    {
        var (before, after) = (comparison.Before.Program, comparison.After.Program);
        var rows = SideBySide.Of(comparison);
        var shown = Shown(rows);
        var cells = shown.Take(RowsShown)
            .Select(
                i => (
                    Index: i,
                    Row: rows[i],
                    Words: rows[i] is { IsSame: false, Before: >= 0, After: >= 0 } r
                        ? SideBySide.Words(before, before[r.Before], after, after[r.After])
                        : ([], [])))
            .ToArray();
        var width = cells.Select(c => c.Row.Before < 0 ? 0 : Marked(page, before, c.Row.Before, c.Words.Item1, isOld: true).Length)
            .DefaultIfEmpty()
            .Max();
        width = Math.Min(width, WidestColumn);
        var digits = Math.Max(before.BlockCount, after.BlockCount).ToString(CultureInfo.InvariantCulture).Length;
        if (cells.Length == 0)
        {
            page.Line("The programs differ in numbers, spaces and spelling only.");
        }

        var last = -1;
        foreach (var (index, row, words) in cells)
        {
            if (index != last + 1)
            {
                page.Line("...");
            }

            var mark = row.IsSame ? " " : row.Before < 0 ? "+" : row.After < 0 ? "-" : "~";
            var (left, right) = (
                Side(page, before, row.Before, words.Item1, isOld: true), Side(page, after, row.After, words.Item2, isOld: false));
            var (gap, was, now) = (new string(' ', Math.Max(0, width - left.Length)), Line(row.Before, digits), Line(row.After, digits));
            page.Line($"{mark} {was}  {left.Text}{gap}  {now}  {right.Text}".TrimEnd());
            last = index;
        }

        if (shown.Count > RowsShown)
        {
            page.Line(string.Create(
                CultureInfo.InvariantCulture, $"... and {shown.Count - RowsShown} more rows; --html FILE writes them all."));
        }
    }

    // The rows that differ, and their context.
    private static List<int> Shown(IReadOnlyList<BlockPair> rows)
    {
        var shown = new List<int>();
        for (var i = 0; i < rows.Count; i++)
        {
            for (var j = Math.Max(i - Context, shown.Count == 0 ? 0 : shown[^1] + 1); !rows[i].IsSame
                && j <= Math.Min(i + Context, rows.Count - 1); j++)
            {
                shown.Add(j);
            }
        }

        return shown;
    }

    private static string Line(int block, int digits) =>
        (block < 0 ? "" : (block + 1).ToString(CultureInfo.InvariantCulture)).PadLeft(digits);

    private static (string Text, int Length) Side(Page page, NcProgram program, int block, IReadOnlyList<Range> words, bool isOld) =>
        block < 0 ? ("", 0) : Marked(page, program, block, words, isOld);

    private static (string Text, int Length) Marked(Page page, NcProgram program, int block, IReadOnlyList<Range> words, bool isOld)
    {
        var bytes = program.BytesOf(program[block]);
        var (text, length, at) = (new StringBuilder(), 0, 0);
        foreach (var word in words)
        {
            var (start, count) = word.GetOffsetAndLength(bytes.Length);
            Add(Clean(bytes[at..start]));
            var (marked, extra) = page.Marked(Clean(bytes.Slice(start, count)), isOld);
            text.Append(marked);
            length += count + extra;
            at = start + count;
        }

        Add(Clean(bytes[at..]));
        return (text.ToString(), length);

        void Add(string plain)
        {
            text.Append(plain);
            length += plain.Length;
        }
    }

    // One character per byte, with no control characters for a terminal.
    private static string Clean(ReadOnlySpan<byte> bytes) => string.Create(bytes.Length, bytes, (text, source) =>
    {
        for (var i = 0; i < text.Length; i++)
        {
            var c = (char)source[i];
            text[i] = c == '\t' ? ' ' : char.IsControl(c) ? '\uFFFD' : c;
        }
    });
}
