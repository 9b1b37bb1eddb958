using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>Writes an evaluation as one HTML file without network access or scripts.</summary>
public static class EvaluationReportHtml
{
    /// <summary>Writes the page as UTF-8 without a byte order mark. The same report always gives the same bytes.</summary>
    public static byte[] Write(EvaluationReport report)
    {
        ArgumentNullException.ThrowIfNull(report);
        return ReportPage.Write(
            report.Job,
            "the surface as measured",
            [
                new("summary", "Summary", html => WriteSummary(html, report)),
                new("statistics", "Mean, standard deviation, profile", html => WriteStatistics(html, report)),
                new("maps", "Where the errors are", html => WriteMaps(html, report)),
                new("plots", "Error by point", html => WritePlots(html, report)),
                new("points", "Points", html => WritePoints(html, report)),
                new(
                    "inputs",
                    "Files",
                    html => ReportInputs.Write(
                        html,
                        report.Job,
                        report.Inputs,
                        "surface evaluate",
                        ("--measured", "measured"),
                        ("--before", "before"),
                        ("--tool-radius", "toolRadius"),
                        ("--tool-radius-before", "toolRadiusBefore"))),
            ],
            html => ProfileLead.Write(html, report));
    }

    private static void WriteSummary(HtmlText html, EvaluationReport report)
    {
        var after = report.Measured.Together;
        if (report.Before?.Together is { } before)
        {
            var better = after.StandardDeviationMm < before.StandardDeviationMm && after.ProfileIsoMm < before.ProfileIsoMm;
            using (html.In("p", ("class", better ? "verdict holds" : "verdict fails")))
            {
                html.Put(
                    "strong",
                    better
                        ? "✓ The surface is better than before."
                        : "✗ The surface is not better than before in every respect. Find out why before the next piece.");
                html.Text(
                    $" Standard deviation {Micrometres.OfMm(before.StandardDeviationMm)} µm, now "
                        + $"{Micrometres.OfMm(after.StandardDeviationMm)} µm. Profile {Micrometres.OfMm(before.ProfileIsoMm)} µm, now "
                        + $"{Micrometres.OfMm(after.ProfileIsoMm)} µm.");
            }
        }
        else
        {
            html.Put(
                "p",
                $"Mean {Micrometres.SignedOfMm(after.MeanMm)} µm, standard deviation {Micrometres.OfMm(after.StandardDeviationMm)} µm, "
                    + $"profile {Micrometres.OfMm(after.ProfileIsoMm)} µm.");
        }

        ReportFacts.WriteWarnings(html, [.. report.Pieces.SelectMany(p => p.Warnings)]);
        ReportFacts.WriteNotes(html, [.. report.Pieces.Select(p => p.StageNote).OfType<string>()]);
        List<(string Name, string Value)> facts = [
            (
                "Errors",
                "Signed distances along the normal of the nominal surface, positive where material is left, less the stock of the stage."),
            ("Improvement", Improvement(report)),
            ("Alignment", Alignment(report)),
            (
                "Profile",
                "By ISO 1101 with a zone about the nominal surface: twice the largest absolute error. Standard deviations use n − 1."),
        ];
        if (report.Tolerance is { } tolerance)
        {
            facts.Insert(
                0, ("Tolerance", ProfileWords.Of(tolerance, report.Measured.Pieces[0].Judgement!.UncertaintyMm, "µm")));
        }

        ReportFacts.Write(html, facts.ToArray());
    }

    private static string Improvement(EvaluationReport report)
    {
        (string Way, SurfaceImprovement? By)[] ways = [
            ("", report.Improvement), ("Compensated by tool radius instead: ", report.ToolRadiusImprovement)];
        string[] said = [.. ways.Where(w => w.By is not null).Select(w => w.Way + w.By!.Words)];
        return said.Length == 0 ? "Not known: nothing was given to compare with." : string.Join(" ", said);
    }

    // If one piece has no alignment, none has.
    private static string Alignment(EvaluationReport report) => report.Pieces.First().Alignment is null
        ? AlignmentWords.Of(null)
        : string.Join(" ", report.Pieces.Select(p => $"{p.File}: {AlignmentWords.Of(p.Alignment)}"));

    private static void WriteStatistics(HtmlText html, EvaluationReport report)
    {
        SurfaceTables.WriteStatistics(
            html, "statistics-table", "All pieces together", report.Parts.Select(b => (b.Name, b.Evaluation.Together)));
        if (report.Parts.Any(b => b.Evaluation.Pieces.Count > 1))
        {
            SurfaceTables.WriteStatistics(
                html,
                "pieces-table",
                "Piece by piece",
                report.Parts.SelectMany(b => b.Evaluation.Pieces.Select(p => ($"{b.Name}: {p.File}", p.Statistics))));
            foreach (var (name, evaluation) in report.Parts)
            {
                html.Put(
                    "p",
                    $"{name}: standard deviations of the pieces differ by {Micrometres.OfMm(evaluation.RangeOfStandardDeviationsMm)} µm.");
            }
        }
    }

    private static void WriteMaps(HtmlText html, EvaluationReport report)
    {
        var limit = 1000 * report.Pieces.SelectMany(p => p.Samples).Max(s => Math.Abs(s.ErrorMm));
        var map = new HeatMap(report.Surface, limit);
        var number = 0;
        foreach (var (name, evaluation) in report.Parts)
        {
            foreach (var piece in evaluation.Pieces)
            {
                var field = FieldFit.Fit(piece.Samples);
                using (html.In("figure"))
                {
                    map.Write(
                        html,
                        $"map{++number}",
                        $"{name}: {piece.File}",
                        (u, v) => 1000 * field.At(u, v),
                        [.. piece.Samples.Select(s => new PlottedPoint(ReportNumber.Count(s.Point), s.Nominal, 1000 * s.ErrorMm))]);
                    html.Put(
                        "figcaption", "Colors between the points are the smooth field that fits them best; numbers are what was measured.");
                }
            }
        }
    }

    private static void WritePlots(HtmlText html, EvaluationReport report)
    {
        var number = WritePlots(html, report.Before, report.Measured, "", 0);
        if (report.ToolRadius is { } radius)
        {
            WritePlots(html, report.ToolRadiusBefore, radius, "tool radius, ", number);
        }
    }

    // As in figures 10 to 12 of Lee 2019: (a) by tool radius, (b) by mirroring.
    private static int WritePlots(HtmlText html, SurfaceEvaluation? was, SurfaceEvaluation now, string way, int number)
    {
        for (var k = 0; k < now.Pieces.Count; k++)
        {
            var after = now.Pieces[k].Samples.ToDictionary(s => s.Point);
            var isCompared = was is not null && k < was.Pieces.Count;
            var first = isCompared ? was!.Pieces[k].Samples : now.Pieces[k].Samples;
            using (html.In("figure"))
            {
                new ErrorByPointPlot(
                    [
                        .. first.Select(s => new PlottedError(
                            ReportNumber.Count(s.Point),
                            1000 * s.ErrorMm,
                            isCompared && after.TryGetValue(s.Point, out var a) ? 1000 * a.ErrorMm : (double?)null))])
                    .Write(
                        html,
                        $"plot{++number}",
                        $"Error at each point, {way}{now.Pieces[k].File}",
                        isCompared ? "before" : "measured",
                        isCompared ? "after" : "not measured");
            }
        }

        return number;
    }

    private static void WritePoints(HtmlText html, EvaluationReport report)
    {
        var number = 0;
        foreach (var (name, evaluation) in report.Parts)
        {
            foreach (var piece in evaluation.Pieces)
            {
                SurfaceTables.WritePoints(html, $"points{++number}", $"{name}: {piece.File}", piece.Samples);
            }
        }
    }
}
