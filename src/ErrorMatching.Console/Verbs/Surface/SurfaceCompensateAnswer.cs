using System.Globalization;
using ErrorMatching.Freeform;
using ErrorMatching.Jobs;
using ErrorMatching.Json;
using ErrorMatching.Reporting;

namespace ErrorMatching.Console;

/// <summary>A compensation: its report, and the files that it was written to.</summary>
/// <param name="finished">The finishing program with its report.</param>
/// <param name="folder">The folder that the files are in; null if nothing was written.</param>
/// <param name="failure">Why no program is written; null if it is.</param>
internal sealed class SurfaceCompensateAnswer(FinishedSurface finished, string? folder, Failure? failure) : Answer
{
    private readonly byte[] _json = finished.ReportJson();

    public override Failure? Failure => failure;

    public override byte[] ToJson() => OutcomeWriter.WithErrors(_json, Failure);

    /// <summary>The files that are cut with, or that describe what is cut.</summary>
    public static IEnumerable<string> Targets(string? folder) => folder is null
        ? []
        : new[] { "compensation.csv", "surface.stp", "surface.igs", FinishedSurface.Name }.Select(n => PathText.In(folder, n));

    /// <summary>The files to write. The program is last: if it exists, so does its report.</summary>
    public IReadOnlyList<(string Path, ReadOnlyMemory<byte> Bytes)> Files()
    {
        // The page takes as long as all the others, so it is created concurrently.
        var page = Task.Run(finished.ReportHtml);
        var result = finished.Report.Result;
        if (finished.Report.Acceptance.IsWithheld)
        {
            return [(In("report.json"), _json), (In("report.html"), page.GetAwaiter().GetResult())];
        }

        var (points, step, iges) = (CompensationCsv.Write(result), StepWriter.Write(result.Surface), IgesWriter.Write(result.Surface));
        return
        [
            (In("compensation.csv"), points),
            (In("surface.stp"), step),
            (In("surface.igs"), iges),
            (In("report.json"), _json),
            (In("report.html"), page.GetAwaiter().GetResult()),
            (In(FinishedSurface.Name), finished.Program),
        ];
    }

    public override void WriteText(Page page)
    {
        var (report, result, certificate) = (finished.Report, finished.Report.Result, finished.Report.ToolPath.Certificate);

        // Green on a program that stops with an alarm would suggest cutting.
        page.Verdict(
            ProfileLead.Of(result, report.Verdict, report.CallsTool),
            report.Verdict?.Predicted.IsWithin is var isWithin && isWithin == true && !report.CallsTool ? null : isWithin);
        if (report.Acceptance.Sentence is { } accepted)
        {
            page.Line(accepted);
        }

        if (!report.CallsTool)
        {
            page.Heading($"{report.Job.Name}: {In(FinishedSurface.Name)} has no tool call and stops with an alarm");
            page.Line();
            page.Warning(FinishingProgram.NoToolCall);
        }

        page.Line();
        page.Line(
            $"{report.Job.Name}: the surface is moved by at most {Um(result.LargestMoveMm)} µm; standard deviation "
                + $"{Um(result.Before.StandardDeviationMm)} µm, expected after {Um(result.Predicted.Statistics.StandardDeviationMm)} µm");
        page.Line();
        page.Table(
            ["", "points", "mean µm", "standard deviation µm", "profile ISO 1101 µm", "largest - smallest µm"],
            [
                Row("measured", result.Before),
                Row("expected, mirror", result.Mirror.Statistics),
                Row("expected, tool radius", result.ToolRadius.Statistics)]);
        page.Line(
            "Errors along the normal, positive where material is left, less the stock of the stage. The job's method: "
                + result.Predicted.Method + ".");
        page.Line(
            $"Standard uncertainty of what is expected: {Um(result.Predicted.MeanUncertaintyMm)} µm of the mean, "
                + $"{Um(result.Predicted.PointUncertaintyMm)} µm of a point.");
        page.Line("Measured piece: " + report.CutBy.Sentence);
        if (result.Input.Job is { Profile: { } tolerance, Measuring.UncertaintyMm: var uncertainty })
        {
            page.Line("Tolerance: " + ProfileWords.Of(tolerance, uncertainty));
        }

        page.Line("Alignment: " + AlignmentWords.Of(result.Alignment));
        page.Line("Systematic? " + StructureWords.Of(result.Structure));
        page.Line();
        page.Line(string.Create(
            CultureInfo.InvariantCulture,
            $"Tool path: {ReportNumber.Count(report.ToolPath.Passes, "pass", "passes")}, "
                + $"{ReportNumber.Count(report.ToolPath.Points, "point")}, {report.ToolPath.LengthMm:0} mm; chord at "
                + $"most {Um(certificate.ChordMm)} µm, scallop at most {Um(certificate.ScallopMm)} µm{Gouges(certificate)}."));
        foreach (var warning in result.Warnings)
        {
            page.Warning(warning.ToString());
        }

        foreach (var note in result.Notes)
        {
            page.Line("Note: " + note);
        }

        page.Line();
        if (report.Acceptance.IsWithheld)
        {
            page.Line(folder is null
                ? "Nothing was written. Add --out DIR to write the reports."
                : $"Wrote {In("report.html")} and {In("report.json")}.");
            return;
        }

        page.Line(folder is null
            ? "Nothing was written. Add --out DIR to write the compensation points, the surface, the finishing program and the reports."
            : $"Wrote {In("finishing.nc")}, {In("surface.stp")}, {In("surface.igs")}, {In("compensation.csv")}, {In("report.html")} and "
                + $"{In("report.json")}.");
        if (folder is not null)
        {
            page.Line(report.CallsTool
                ? $"Next: open {In("report.html")} in a browser, cut with {In("finishing.nc")}, measure again, and compare by errormatch "
                    + $"surface evaluate."
                : $"Next: open {In("report.html")} in a browser, name the tool in {report.Job.File} (toolpath.tool), and run this again.");
        }
    }

    private static IReadOnlyList<string> Row(string name, DeviationStatistics s) =>
        [
            name,
            s.Count.ToString(CultureInfo.InvariantCulture),
            Signed(s.MeanMm),
            Um(s.StandardDeviationMm),
            Um(s.ProfileIsoMm),
            Um(s.ProfileRangeMm)];

    private static string Gouges(ToolPathCertificate certificate) => certificate switch
    {
        { RaisedPoints: > 0 } => string.Create(
            CultureInfo.InvariantCulture,
            $", {ReportNumber.Count(certificate.RaisedPoints, "point")} raised by "
                + $"up to {Um(certificate.RaisedMm)} µm where the ball does not fit"),
        { HasNoGouge: true } => ", no gouge",
        _ => $", no gouge beyond the chord: a straight cut may lie up to {Um(certificate.ChordMm)} µm inside the surface",
    };

    private static string Um(double mm) => (mm * 1000).ToString("0.00", CultureInfo.InvariantCulture);

    private static string Signed(double mm) => (mm * 1000).ToString("+0.00;-0.00;0.00", CultureInfo.InvariantCulture);

    private string In(string name) => PathText.In(folder, name);
}
