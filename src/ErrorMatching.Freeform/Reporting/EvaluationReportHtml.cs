using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>Writes an evaluation as one HTML file without network access or scripts.</summary>
public static class EvaluationReportHtml
{
    // About 95 % of normally distributed errors.
    private const double Coverage = 2;

    /// <summary>Writes the page as UTF-8 without a byte order mark. The same report always gives the same bytes.</summary>
    public static byte[] Write(EvaluationReport report)
    {
        ArgumentNullException.ThrowIfNull(report);
        var fields = new Dictionary<EvaluatedPiece, FittedField>(ReferenceEqualityComparer.Instance);
        foreach (var piece in report.Pieces)
        {
            fields.TryAdd(piece, FieldFit.Fit(piece.Samples));
        }

        return ReportPage.Write(
            report.Job,
            "the surface as measured",
            [
                new("summary", "Summary", html => WriteSummary(html, report)),
                new("statistics", "Mean, standard deviation, profile", html => WriteStatistics(html, report)),
                new("maps", "Where the errors are", html => WriteMaps(html, report, fields)),
                new("sections", "Along a line", html => WriteSections(html, report, fields)),
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

        ReportFacts.WriteWarnings(html, [.. report.Pieces.SelectMany(p => p.Warnings).Select(w => w.Message)]);
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
                0, ("Tolerance", ProfileWords.Of(tolerance, report.Measured.Pieces[0].Judgement!.UncertaintyMm)));
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

    private static void WriteMaps(HtmlText html, EvaluationReport report, Dictionary<EvaluatedPiece, FittedField> fields)
    {
        // A piece before and the piece of the same number after are side by side, all at one scale.
        var maps = new SurfaceMaps(report.Surface);
        var rows = new List<MapPanel[]>();
        foreach (var (before, after) in new[] { (report.Before, report.Measured), (report.ToolRadiusBefore, report.ToolRadius) })
        {
            for (var k = 0; k < Math.Max(before?.Pieces.Count ?? 0, after?.Pieces.Count ?? 0); k++)
            {
                rows.Add([.. new[] { before, after }
                    .Where(e => e is not null && k < e.Pieces.Count)
                    .Select(e => Panel(maps, report.Parts.First(p => p.Evaluation == e).Name, e!.Pieces[k], fields[e.Pieces[k]]))]);
            }
        }

        var scale = ColorScale.OfErrors(rows.SelectMany(r => r).SelectMany(p => p.Shown));
        for (var k = 0; k < rows.Count; k++)
        {
            using (html.In("figure"))
            {
                maps.Write(html, "map" + ReportNumber.Count(k + 1), scale, rows[k]);
                html.Put(
                    "figcaption",
                    "Seen against z. Colors: the smooth field that fits the points best, all maps at one scale; brown is material that is "
                        + "left, blue is too much removed. Numbers: what was measured.");
            }
        }
    }

    private static MapPanel Panel(SurfaceMaps maps, string name, EvaluatedPiece piece, FittedField field) => maps.Panel(
        $"{name}: {Path.GetFileName(piece.File)}",
        (u, v) => 1000 * field.At(u, v),
        [.. piece.Samples.Select(s => new PlottedPoint(ReportNumber.Count(s.Point), s.Nominal, 1000 * s.ErrorMm))]);

    // The first piece of each: more would repeat each other.
    private static void WriteSections(HtmlText html, EvaluationReport report, Dictionary<EvaluatedPiece, FittedField> fields)
    {
        var (before, after) = (report.Before?.Pieces[0], report.Measured.Pieces[0]);
        using (html.In("figure"))
        {
            foreach (var alongU in new[] { true, false })
            {
                var section = new SurfaceSection(report.Surface, (before ?? after).Samples, alongU);
                SectionCurve[] curves = before is null
                    ? [Curve(section, "measured", "before", after)]
                    : [Curve(section, "before", "before", before), Curve(section, "after", "expected", after)];
                new SectionPlot(section, curves).Write(html, alongU ? "section-u" : "section-v");
            }

            html.Put(
                "figcaption",
                "Zero is the nominal surface. Lines: the smooth field that fits the points best, with a band of twice its standard "
                    + "uncertainty. Circles: the points that were measured there.");
        }

        SectionCurve Curve(SurfaceSection section, string name, string look, EvaluatedPiece piece) =>
            new(name, look, p => 1000 * fields[piece].At(p.U, p.V))
            {
                HasWidth = true,
                HalfWidthUm = p => Coverage * 1000 * fields[piece].StandardUncertaintyAt(p.U, p.V),
                PointsUm = section.PointsOf(piece.Samples),
            };
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
