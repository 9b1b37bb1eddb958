using System.Globalization;
using ErrorMatching.Measurement;
using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>Writes a compensation as one HTML file without network access or scripts.</summary>
public static class CompensationReportHtml
{
    // About 95 % of normally distributed errors.
    private const double Coverage = 2;

    /// <summary>Writes the page as UTF-8 without a byte order mark. The same report always gives the same bytes.</summary>
    public static byte[] Write(CompensationReport report)
    {
        ArgumentNullException.ThrowIfNull(report);
        return ReportPage.Write(
            report.Job,
            "compensated surface",
            [
                new("summary", "Summary", html => WriteSummary(html, report)),
                new("predicted", "Before, and what is expected after", html => WritePredictions(html, report.Result)),
                new("maps", "Where the error is, and what is left", html => WriteMaps(html, report.Result)),
                .. LotSection.Of(report.Result.Pieces, report.Result.Lot),
                new("sections", "Along a line", html => WriteSections(html, report.Result)),
                new("plots", "Error by point", html => WritePlots(html, report.Result)),
                new("fit", "How the error was fitted", html => WriteFit(html, report.Result)),
                new("path", "Tool path", html => WritePath(html, report)),
                new(
                    "points",
                    "Points",
                    html => SurfaceTables.WritePoints(
                        html,
                        "points-table",
                        "Measured points: their feet on the nominal surface, and their errors",
                        report.Result.Samples)),
                new(
                    "inputs",
                    "Files",
                    html => ReportInputs.Write(
                        html,
                        report.Job,
                        report.Inputs,
                        "surface compensate",
                        ("--measured", "measured"),
                        ("--cut-by", "cut-by"),
                        ("--previous", "previous"), ("--earlier", "earlier"))),
            ],
            html => ProfileLead.Write(html, report.Result, report.Verdict, report.CallsTool, report.Acceptance));
    }

    private static void WriteSummary(HtmlText html, CompensationReport report)
    {
        var (result, before, after) = (report.Result, report.Result.Before, report.Result.Predicted.Statistics);
        if (!report.CallsTool)
        {
            using (html.In("p", ("class", "verdict fails")))
            {
                html.Put("strong", $"✗ {report.Program.File} has no tool call: it stops with an alarm before it moves.");
            }
        }

        // A check mark next to an alarm would suggest cutting.
        var isReady = report.CallsTool && result.LargestMoveMm > 0 && !report.Acceptance.IsWithheld;
        using (html.In("p", ("class", isReady ? "verdict holds" : "verdict fails")))
        {
            var moved = $"a surface that is moved by at most {Micrometres.OfMm(result.LargestMoveMm)} µm.";
            html.Put("strong", isReady ? $"✓ {report.Program.File} cuts {moved}"
                : report.Acceptance.IsWithheld ? $"○ No program is written. It would cut {moved}"
                : result.LargestMoveMm > 0 ? $"○ Once the tool call is in, it cuts {moved}"
                : "○ Nothing is compensated: the finishing program cuts the nominal surface.");
            html.Text($" Expected: standard deviation {Micrometres.OfMm(before.StandardDeviationMm)} µm becomes "
                + $"{Micrometres.OfMm(after.StandardDeviationMm)} µm, profile {Micrometres.OfMm(before.ProfileIsoMm)} µm becomes "
                + $"{Micrometres.OfMm(after.ProfileIsoMm)} µm.");
        }

        ReportFacts.WriteWarnings(html, [.. report.Warnings.Select(w => w.Message)]);
        ReportFacts.WriteNotes(html, result.Notes);
        List<(string Name, string Value)> facts = [
            ("Measured piece", report.CutBy.Sentence),
            (
                "Errors",
                "Signed distances along the normal of the nominal surface, positive where material is left, less the stock of the stage."),
            ("Alignment", AlignmentWords.Of(result.Alignment)),
            (
                "Compensation",
                (
                    result.Input.Job.Compensation.Mirror
                        ? "Each place is moved by its own error to the other side"
                        : "The whole surface is moved by the mean error, as by a modified tool radius")
                + string.Create(
                    CultureInfo.InvariantCulture,
                    $", gain {result.Input.Job.Compensation.Gain:0.###}, at most {result.Input.Job.Compensation.LimitMm:0.###} mm.")),
            (
                "Calculated in",
                report.CalculatingS is { } s ? string.Create(CultureInfo.InvariantCulture, $"{s:0.00} s.") : "Not timed."),
        ];
        if (result.Input.Job is { Profile: { } tolerance, Measuring.UncertaintyMm: var u })
        {
            facts.Insert(0, ("Tolerance", ProfileWords.Of(tolerance, u)));
        }

        ReportFacts.Write(html, facts.ToArray());
    }

    private static void WritePredictions(HtmlText html, CompensationResult result)
    {
        SurfaceTables.WriteStatistics(
            html,
            "predictions",
            "Measured, and expected by either way of compensating",
            [
                ("Measured", result.Before),
                ("Expected, mirrored", result.Mirror.Statistics),
                ("Expected, tool radius", result.ToolRadius.Statistics)]);
        html.Put(
            "p",
            $"Standard uncertainty of the expected error: {Micrometres.OfMm(result.Mirror.PointUncertaintyMm)} µm at a point, "
                + $"{Micrometres.OfMm(result.Mirror.MeanUncertaintyMm)} µm for the mean. The noise is expected to come again, because "
                + $"cutting and probing do not repeat exactly, and the field to be off by its uncertainty; both are in the spread.");
    }

    private static void WriteMaps(HtmlText html, CompensationResult result)
    {
        var maps = new SurfaceMaps(result.Input.Surface);
        var (name, samples) = Corrected(result);
        var measured = maps.Panel(
            char.ToUpperInvariant(name[0]) + name[1..],
            (u, v) => 1000 * result.Systematic.At(u, v),
            [.. samples.Select(s => new PlottedPoint(ReportNumber.Count(s.Point), s.Nominal, 1000 * s.ErrorMm))]);
        var left = Expected(maps, result);
        Figure(
            html,
            () => maps.Write(html, "maps", ColorScale.OfErrors(measured.Shown.Concat(left.Shown)), [measured, left]),
            "Seen against z. Colors: the systematic error, before and as expected after the compensation, at one scale; brown is material "
                + "that is left, blue is too much removed. Numbers: "
                + (result.Lot is null ? "what was measured." : "what all pieces say of each point."));
        var uncertain = maps.Panel(
            "Standard uncertainty of the systematic error", (u, v) => 1000 * result.Systematic.StandardUncertaintyAt(u, v), []);
        Figure(
            html,
            () => maps.Write(html, "uncertain", ColorScale.OfSizes(uncertain.Shown), [uncertain]),
            "How well the systematic error is known; colors of their own.");
    }

    // What the surface to cut corrects: the measured piece, or with a lot what the next piece would be like without corrections.
    private static (string Name, IReadOnlyList<ErrorSample> Samples) Corrected(CompensationResult result) =>
        result.Lot is null ? ("measured", result.Samples) : ("without corrections", result.Expected);

    // A surface through points leaves its own distance, which is known on the net of the document only: it is slow to calculate.
    private static MapPanel Expected(SurfaceMaps maps, CompensationResult result)
    {
        const string title = "Expected after compensation";
        if (result.ThroughPoints is null)
        {
            return maps.Panel(title, (u, v) => 1000 * (result.Systematic.At(u, v) + result.MovedMmAt(u, v)), []);
        }

        var map = ErrorMap.Of(result);
        return new(title, map.Net, [.. map.MirrorMm.Select(e => 1000 * e)], []);
    }

    private static void WriteSections(HtmlText html, CompensationResult result) => Figure(
        html,
        () =>
        {
            WriteSection(html, result, alongU: true);
            WriteSection(html, result, alongU: false);
        },
        "Zero is the nominal surface. The program cuts where the dashed line is: as far on the other side as the error was. So the piece "
            + "is expected near zero; the band is twice the standard uncertainty of the systematic error.");

    private static void WriteSection(HtmlText html, CompensationResult result, bool alongU)
    {
        var (name, samples) = Corrected(result);
        var section = new SurfaceSection(result.Input.Surface, samples, alongU);
        var moved = section.Places.ToDictionary(p => p, p => 1000 * result.MovedMmAt(p.U, p.V));
        new SectionPlot(
            section,
            [
                new("expected after", "expected", p => Before(p) + moved[p])
                {
                    HasWidth = true,
                    HalfWidthUm = p => Coverage * 1000 * result.Systematic.StandardUncertaintyAt(p.U, p.V),
                },
                new("as cut: moved to the other side", "mirrored", p => moved[p]),
                new(name, "before", Before) { PointsUm = section.PointsOf(samples) },
            ]).Write(html, alongU ? "section-u" : "section-v");

        double Before(SectionPlace p) => 1000 * result.Systematic.At(p.U, p.V);
    }

    private static void WritePlots(HtmlText html, CompensationResult result)
    {
        foreach (var (id, name, prediction) in new[]
        {
            ("mirror-plot", "mirror", result.Mirror),
            ("radius-plot", "tool radius", result.ToolRadius)
        })
        {
            Figure(
                html,
                () => new ErrorByPointPlot(
                    [
                        .. result.Samples.Zip(prediction.Errors).Select(p => new PlottedError(
                            ReportNumber.Count(p.First.Point), 1000 * p.First.ErrorMm, 1000 * p.Second))])
                    .Write(html, id, $"Error by point, {name}", "measured", $"expected, {name}"),
                "What is expected is without scatter.");
        }
    }

    private static void WriteFit(HtmlText html, CompensationResult result)
    {
        var field = result.Systematic as FittedField;
        ReportFacts.Write(html,
            (
                "Systematic?",
                StructureWords.Of(result.Structure)
                    + (result.Structure is { Verdict: not SpatialVerdict.Undetermined } s
                        ? string.Create(
                            CultureInfo.InvariantCulture,
                            $" Moran's I {s.I:0.###} (no structure: {s.Expectation:0.###}), z {s.Z:0.0}, p {StructureTest.Words(s.P)}.")
                        : "")),
            (
                "Fit",
                $"{result.Input.Job.Fit.Method.Name} of the "
                    + (result.Input.Job.Fit.OfError ? "error over (u, v), added to the exact nominal surface." : "compensation points.")),
            (
                "Model",
                field is null
                    ? result.Systematic is ConstantField
                    ? "A constant."
                    : "The surface fit of that name."
                    : FieldWords.Sentence(field.Kind)),
            (
                "Breaks",
                field is null || field.BreaksU.Count + field.BreaksV.Count == 0
                    ? "None of the curvature found."
                    : string.Create(
                        CultureInfo.InvariantCulture,
                        $"u: {string.Join(", ", field.BreaksU.Select(b => b.ToString("0.####", CultureInfo.InvariantCulture)))}; v: "
                            + $"{string.Join(", ", field.BreaksV.Select(b => b.ToString("0.####", CultureInfo.InvariantCulture)))}.")),
            (
                "With lines left out",
                field is null
                    ? "–"
                    : double.IsNaN(field.LeaveLineOutMm)
                    ? "Too few lines to leave one out."
                    : $"{Micrometres.OfMm(field.LeaveLineOutMm)} µm: the mean error where whole grid lines are predicted from the others."),
            ("Residuals", field is null ? "–" : $"{Micrometres.OfMm(field.ResidualStandardDeviationMm)} µm."),
            (
                "Surface as written",
                $"{ReportNumber.Count(result.Surface.Spline.CountU)} × {ReportNumber.Count(result.Surface.Spline.CountV)} poles, degrees "
                    + $"{ReportNumber.Count(result.Surface.Spline.KnotsU.Degree)} and "
                    + $"{ReportNumber.Count(result.Surface.Spline.KnotsV.Degree)}; "
                + (result.ThroughPoints is null
                    ? $"within {(result.ApproximationMm * 1e6).ToString("0.0", CultureInfo.InvariantCulture)} nm of the nominal surface "
                        + $"moved by the field, with its parametrization and limits."
                    : "laid through the compensation points.")));
    }

    private static void WritePath(HtmlText html, CompensationReport report)
    {
        var (path, certificate) = (report.ToolPath, report.ToolPath.Certificate);
        ReportFacts.Write(html,
            ("Program", $"{report.Program.File}, SHA-256 {ReportInputs.ShortHash(report.Program.Sha256)}…"),
            (
                "Passes",
                $"{ReportNumber.Count(path.Passes, "pass", "passes")} of {ReportNumber.Count(path.Points, "point")}, "
                    + $"{path.LengthMm.ToString("0", CultureInfo.InvariantCulture)} mm."),
            ("Chordal error", $"At most {Micrometres.OfMm(certificate.ChordMm)} µm, found by checking the rounded polyline densely."),
            ("Scallop", $"At most {Micrometres.OfMm(certificate.ScallopMm)} µm."),
            (
                "Gouges",
                certificate.RaisedPoints == 0
                    ? "None"
                        + (
                            certificate.HasNoGouge
                                ? ""
                                : $" beyond the chord, by which a straight cut may lie up to {Micrometres.OfMm(certificate.ChordMm)} µm "
                                    + $"inside")
                        + $": checked against the whole surface, nowhere does the ball cut deeper into it than "
                            + $"{Micrometres.OfMm(certificate.GougeMm)} µm, chords and rounding included."
                    : $"{ReportNumber.Count(certificate.RaisedPoints, "point was", "points were")} raised by up to "
                        + $"{Micrometres.OfMm(certificate.RaisedMm)} µm where the ball does not fit: there material is left."));
    }

    private static void Figure(HtmlText html, Action draw, string caption)
    {
        using (html.In("figure"))
        {
            draw();
            html.Put("figcaption", caption);
        }
    }
}
