namespace ErrorMatching.Mating;

/// <summary>The section with the blocks that differ, original and modified side by side.</summary>
internal static class MatchProgram
{
    public static void Write(HtmlText html, MatchReport report)
    {
        var program = report.Program;
        ReportFacts.Write(html, ("Program", program.File), ("SHA-256", program.Sha256), ("Changed", $"{ReportNumber.Count(program.ChangedBlocks, "block")}, {ReportNumber.Count(program.ChangedWords, "word")}"));
        if (program.Blocks.Count == 0)
        {
            html.Put("p", "No block differs: the program is the original, byte for byte.");
            return;
        }

        using (html.In("details", ("open", "open")))
        {
            html.Put("summary", $"{ReportNumber.Count(program.Blocks.Count, "block")} side by side");
            HtmlTable.Write(html, "blocks-table", "Blocks that differ. What was replaced has a dotted line below it, what stands there now a solid one.", [new("Line", true), new("Block"), new("Original"), new("Modified")], program.Blocks, (row, block) =>
            {
                row.Number(ReportNumber.Count(block.Line));
                row.Header(block.Number.Length > 0 ? block.Number : ReportNumber.None);
                WriteText(html, row, block.Original, block.OriginalSpans, "del", "inserted");
                WriteText(html, row, block.Modified, block.ModifiedSpans, "ins", "removed");
            }, isLong: true);
        }
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
