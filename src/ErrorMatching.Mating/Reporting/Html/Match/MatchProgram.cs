using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The section with the blocks that differ, original and modified side by side.</summary>
internal static class MatchProgram
{
    public static void Write(HtmlText html, MatchReport report)
    {
        var program = report.Program;
        ReportFacts.Write(
            html,
            ("Program", program.File),
            ("SHA-256", program.Sha256),
            ("Changed", $"{ReportNumber.Count(program.ChangedBlocks, "block")}, {ReportNumber.Count(program.ChangedWords, "word")}"));
        if (program.Blocks.Count == 0)
        {
            html.Put("p", "No block differs: the program is the original, byte for byte.");
            return;
        }

        using (html.In("details", ("open", "open")))
        {
            html.Put("summary", $"{ReportNumber.Count(program.Blocks.Count, "block")} side by side");
            BlockTable.Write(html, program.Blocks);
        }
    }
}
