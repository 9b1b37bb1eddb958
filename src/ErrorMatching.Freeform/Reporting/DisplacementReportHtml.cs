using System.Globalization;
using ErrorMatching.Measurement;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>Writes the report of a displaced finishing program as one HTML file without network access or scripts.</summary>
public static class DisplacementReportHtml
{
    private const int MostBlocks = 1000;

    /// <summary>The page: UTF-8 without a byte order mark; the same report always gives the same bytes.</summary>
    public static byte[] Write(DisplacementReport report) => ReportPage.Write(
        report.Job,
        "displaced finishing program",
        [
            new("summary", "Summary", html => WriteSummary(html, report)),
            .. LotSection.Of(report.Compensation.Pieces, report.Compensation.Lot),
            new("points", "Measured points", html => WritePoints(html, report)),
            new("blocks", "Changed blocks", html => WriteBlocks(html, report)),
            new(
                "inputs",
                "Files",
                html => ReportInputs.Write(
                    html,
                    report.Job,
                    report.Inputs,
                    "surface displace",
                    ("--measured", "measured"),
                    ("--cut-by", "cut-by"),
                    ("--previous", "previous"), ("--earlier", "earlier"),
                    ("--program", "program"))),
        ],
        html => ProfileLead.Write(html, report.Compensation, report.Verdict, isReady: true, report.Acceptance));

    private static void WriteSummary(HtmlText html, DisplacementReport report)
    {
        var (displaced, before, after) = (report.Displaced, report.Compensation.Before, report.Compensation.Predicted.Statistics);
        using (html.In("p", ("class", displaced.LargestMoveMm > 0 ? "verdict holds" : "verdict fails")))
        {
            html.Put(
                "strong",
                displaced.LargestMoveMm > 0
                    ? $"✓ {report.File} follows the compensation, by at most {Micrometres(displaced.LargestMoveMm)} µm."
                    : "○ Nothing is compensated: the program stays as it is.");
            html.Text(
                $" Expected: standard deviation {Micrometres(before.StandardDeviationMm)} µm becomes "
                    + $"{Micrometres(after.StandardDeviationMm)} µm, profile {Micrometres(before.ProfileIsoMm)} µm becomes "
                    + $"{Micrometres(after.ProfileIsoMm)} µm.");
        }

        ReportFacts.WriteWarnings(html, [.. report.Compensation.Warnings.Select(w => w.Message)]);
        ReportFacts.WriteNotes(html, report.Compensation.Notes);
        ReportFacts.Write(
            html,
            (
                "Points",
                $"{ReportNumber.Count(displaced.OnSurface)} touch the surface; {ReportNumber.Count(displaced.Followed)} near by go along."),
            ("Between points", $"A straight cut misses the compensation by at most {Micrometres(displaced.LargestMisfitMm)} µm."),
            (
                "Proof",
                $"Holds: of {ReportNumber.Count(displaced.Proof.Motions, "motion")} {ReportNumber.Count(displaced.Proof.MovedMotions)} "
                    + $"moved, none further than {ReportNumber.Fine(displaced.Proof.MaxDeviationFromWantedMm)} mm from where it was "
                        + $"wanted; "
                    + $"every byte besides is the original's{(displaced.Marker is null ? "" : ", but for the marker comment")}."),
            ("Measured piece", report.CutBy.Sentence),
            ("Marker comment", displaced.Proof.Marker ?? "none, since nothing was changed"),
            ("Gain", report.Compensation.Input.Job.Compensation.Gain.ToString("0.###", CultureInfo.InvariantCulture)));
    }

    private static void WritePoints(HtmlText html, DisplacementReport report) =>
        HtmlTable.Write(
            html,
            "points-table",
            "Feet of the measured points on the nominal surface, and their errors along its normal",
            [new("Point"), new("X, mm", true), new("Y, mm", true), new("Z, mm", true), new("Error, µm", true)],
            report.Compensation.Samples,
            (row, s) =>
        {
            row.Header(ReportNumber.Count(s.Point));
            row.Number(ReportNumber.Plain(s.Nominal.X));
            row.Number(ReportNumber.Plain(s.Nominal.Y));
            row.Number(ReportNumber.Plain(s.Nominal.Z));
            row.Number(Micrometres(s.ErrorMm));
        }, isLong: true);

    private static void WriteBlocks(HtmlText html, DisplacementReport report)
    {
        // Without the marker, each block has its original position.
        var (before, after, blocks) = (
            report.Displaced.Before.Program, report.Displaced.Rewrite.Program, report.Displaced.Rewrite.ChangedBlocks);
        html.Put(
            "p",
            $"{ReportNumber.Count(report.Displaced.Rewrite.ChangedWords, "word")} in {ReportNumber.Count(blocks.Count)} "
                + $"blocks{(blocks.Count > MostBlocks ? $"; the first {ReportNumber.Count(MostBlocks)} are listed" : "")}.");
        HtmlTable.Write(
            html,
            "blocks-table",
            "Blocks of the original program that were changed",
            [new("Line", true), new("Before"), new("After")],
            blocks.Take(MostBlocks),
            (row, block) =>
        {
            row.Number(ReportNumber.Count(block + 1));
            row.Code(before.TextOf(before[block]));
            row.Code(after.TextOf(after[block]));
        }, isLong: true);
    }

    private static string Micrometres(double mm) => (1000 * mm).ToString("0.00", CultureInfo.InvariantCulture);
}
