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
