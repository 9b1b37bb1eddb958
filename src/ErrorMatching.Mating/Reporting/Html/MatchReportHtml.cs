using ErrorMatching.Measurement;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The report of a match as one HTML file that needs no network and no script.</summary>
/// <remarks>Lengths are in millimeters, angles in degrees. Also well-formed XML; UTF-8 without a byte order mark, lines end with a line
/// feed. The same report always gives the same bytes. The verdict comes first, then pictures, numbers and proof. Every deviation is
/// actual - nominal, but for the appendix with the tables of figure 9 of Wang 2021.</remarks>
public static class MatchReportHtml
{
    /// <summary>The report as a page.</summary>
    public static byte[] Write(MatchReport report)
    {
        ArgumentNullException.ThrowIfNull(report);
        return ReportPage.Write(
            report.Job,
            "matching the counterpart to the part",
            [
                new("pictures", "Before and after", html => MatchPictures.Write(html, report)),
                .. report.Pair is { Gaps.Count: > 0 } pair
                    ? (PageSection[])[
                        new(
                            "pair",
                            "The pair, assembled",
                            html => PairFigure.Write(html, pair, "the counterpart that the program will cut"))]
                    : [],
                new("summary", "Summary", html => MatchSummary.Write(html, report)),
                new("decisions", "Decisions", html => MatchDecisions.Write(html, report)),
                .. report.Correction is { } correction
                    ? (PageSection[])[new("correction", "Offsets", html => MatchCorrection.Write(html, correction))]
                    : [],
                new("key-points", "Key points", html => MatchKeyPoints.Write(html, report)),
                new("quantities", "Lengths and angles", html => MatchQuantities.Write(html, report)),
                .. report.Lot is { } lot ? LotSection.Of(lot.Pieces, lot.Next, "Off its design") : [],
                new("proof", "Proof", html => MatchProof.Write(html, report)),
                new("program", "Program", html => MatchProgram.Write(html, report)),
                new("measuring", "Measuring", html => MatchMeasuring.Write(html, report)),
                new(
                    "inputs",
                    "Files",
                    html => ReportInputs.Write(
                        html,
                        report.Job,
                        report.Inputs,
                        "match",
                        ("--part", "part"),
                        ("--counterpart", "counterpart"),
                        ("--program", "program"),
                        ("--previous", "previous"), ("--latest", "latest"))),
                new("paper", "As in the paper", html => MatchAsInPaper.Write(html, report)),
            ],
            html => MatchLead.Write(html, report));
    }
}

/// <summary>What a setter reads first: the verdict on the pair, the risk, and the worst error left.</summary>
internal static class MatchLead
{
    public static void Write(HtmlText html, MatchReport report)
    {
        var verdict = report.Verdict;
        using (html.In("p", ("id", "verdict"), ("class", verdict.IsToCut ? "verdict holds" : "verdict fails")))
        {
            html.Put("strong", $"{(verdict.IsToCut ? "✓" : "✗")} {VerdictWords.Of(verdict)}");
            string?[] more = [report.Acceptance.Sentence, VerdictWords.Risk(report), VerdictWords.Worst(verdict)];
            html.Text(string.Join(" ", more.OfType<string>().Concat(VerdictWords.Trust(verdict))));
            if (report.Warnings.Count > 0)
            {
                html.Text(" ");
                html.Put(
                    "a",
                    report.Warnings.Count == 1 ? "Read the warning first." : $"Read the {report.Warnings.Count} warnings first.",
                    ("href", "#summary"));
            }
        }

        if (report.Pair is { } pair)
        {
            html.Put("p", PairWords.Of(pair, verdict.AllLimits), ("id", "pair-verdict"));
        }
    }
}

/// <summary>The section that says by what the correction is made, and why not by less.</summary>
internal static class MatchCorrection
{
    public static void Write(HtmlText html, ReportCorrection correction)
    {
        html.Put("p", CorrectionWords.ToDo(correction) ?? "No offset is touched.");
        foreach (var sentence in CorrectionWords.Why(correction))
        {
            html.Put("p", sentence);
        }
    }
}

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
