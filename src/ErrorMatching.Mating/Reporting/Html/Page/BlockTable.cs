using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>Blocks of two programs side by side, with what differs marked.</summary>
internal static class BlockTable
{
    /// <summary>Writes the table.</summary>
    public static void Write(HtmlText html, IReadOnlyList<ReportBlock> blocks)
    {
        HtmlTable.Write(
            html,
            "blocks-table",
            "Blocks that differ. What was replaced has a dotted line below it, what stands there now a solid one.",
            [new("Line", true), new("Block"), new("Original"), new("Modified")],
            blocks,
            (row, block) =>
        {
            row.Number(ReportNumber.Count(block.Line));
            row.Header(block.Number.Length > 0 ? block.Number : ReportNumber.None);
            WriteText(html, row, block.Original, block.OriginalSpans, "del", "inserted");
            WriteText(html, row, block.Modified, block.ModifiedSpans, "ins", "removed");
        }, isLong: true);
    }

    private static void WriteText(HtmlText html, TableRow row, string text, IReadOnlyList<TextSpan> spans, string element, string absent)
    {
        using (row.Cell("block"))
        {
            if (text.Length == 0)
            {
                html.Put("em", absent);
                return;
            }

            using (html.In("code"))
            {
                var at = 0;
                foreach (var span in spans.Where(s => s.Length > 0).OrderBy(s => s.Start))
                {
                    html.Text(text.AsSpan(at, span.Start - at));
                    html.Put(element, text.Substring(span.Start, span.Length));
                    at = span.Start + span.Length;
                }

                html.Text(text.AsSpan(at));
            }
        }
    }
}
