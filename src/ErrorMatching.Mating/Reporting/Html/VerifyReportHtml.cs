using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The report of a verification as one HTML file that needs no network and no script.</summary>
/// <remarks>Lengths are in millimeters, angles in degrees. Also well-formed XML; UTF-8 without a byte order mark, lines end with a line
/// feed. The same report always gives the same bytes. Plots as in figures 13, 14, 18 and 19 of Wang 2021.</remarks>
public static class VerifyReportHtml
{
    /// <summary>The report as a page.</summary>
    public static byte[] Write(VerifyReport report)
    {
        ArgumentNullException.ThrowIfNull(report);
        return ReportPage.Write(
            report.Job,
            "counterpart against part",
            [
                .. report.Pair is { Gaps.Count: > 0 } pair
                    ? (PageSection[])[
                        new(
                            "pair",
                            "The pair, assembled",
                            html => PairFigure.Write(html, pair, "the counterpart as both were measured"))]
                    : [],
                new("summary", "Summary", html => VerifySummary.Write(html, report)),
                new("features", "Features", html => VerifyTables.WriteFeatures(html, report)),
                new("pictures", "Before and after", html => VerifyPictures.Write(html, report)),
                new("points", "Key points", html => VerifyTables.WritePoints(html, report.Result)),
                new(
                    "inputs",
                    "Files",
                    html => ReportInputs.Write(
                        html,
                        report.Job,
                        report.Inputs,
                        "verify",
                        ("--before", "counterpart"),
                        ("--after", "counterpart-after"),
                        ("--part", "part"))),
            ],
            html => VerifyLead.Write(html, report));
    }
}

/// <summary>What everybody reads first on the page of a verification: the verdict by the limits, and its risk.</summary>
internal static class VerifyLead
{
    public static void Write(HtmlText html, VerifyReport report)
    {
        var verdict = report.Verdict;
        var (look, mark) = verdict.IsInTolerance switch
        {
            true => ("verdict holds", "✓ "),
            false => ("verdict fails", "✗ "),
            null => ("verdict", ""),
        };
        using (html.In("p", ("id", "verdict"), ("class", look)))
        {
            html.Put("strong", mark + VerifyWords.Of(verdict));
            if (VerifyWords.Risk(verdict) is { } risk)
            {
                html.Text(" " + risk);
            }
        }

        if (report.Pair is { } pair)
        {
            html.Put("p", VerifyWords.Of(pair, report));
        }
    }
}

/// <summary>Plot and drawings of a verification: both counterparts as measured, against the measured part.</summary>
internal static class VerifyPictures
{
    public static void Write(HtmlText html, VerifyReport report)
    {
        var result = report.Result;
        PlotPoint[] plot = [.. result.Points.Select(p => new PlotPoint(p.Label, "", p.BeforeError.NormalMm, p.AfterError.NormalMm, null))];
        var drawn = DrawnFeature.Of(
            [],
            [.. result.Points.Select(p => new DrawnPoint(p.Label, p.Part, p.Normal, 0, p.BeforeError.NormalMm, p.AfterError.NormalMm))]);
        ReportPictures.Write(
            html,
            plot,
            AssemblyScene.Of([drawn]),
            report.IsBeforeMeasured ? "without compensation (measured)" : "without compensation (as designed)",
            "with compensation (measured)");
    }
}
