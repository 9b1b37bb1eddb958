using System.Globalization;
using ErrorMatching.Freeform;
using ErrorMatching.Json;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Console;

/// <summary>The evaluated errors of measured surfaces.</summary>
/// <param name="report">The report.</param>
/// <param name="stock">The job's stock.</param>
/// <param name="folder">The folder that it was written to; null if nothing was written.</param>
/// <param name="isRequired">True if pieces that are not in tolerance must not be used.</param>
internal sealed class SurfaceEvaluateAnswer(EvaluationReport report, JobStock stock, string? folder, bool isRequired) : Answer
{
    private readonly byte[] _json = EvaluationReportJson.Write(report);

    public override Failure? Failure => isRequired && report.IsInTolerance == false
        ? new(ExitCode.Refused, [
            .. report.Measured.Pieces.Where(p => !p.Judgement!.IsWithin).Select(p => new Refusal(
                "out-of-tolerance",
                $"{p.File}: {ProfileWords.Of(report.Tolerance!, [(p.File, p.Judgement!)])}",
                new() { File = p.File }))])
        : null;

    public override byte[] ToJson() => OutcomeWriter.WithErrors(_json, Failure);

    /// <summary>The files to write.</summary>
    public IReadOnlyList<(string Path, ReadOnlyMemory<byte> Bytes)> Files =>
        [
            (In("evaluation.json"), _json),
            (In("evaluation.html"), EvaluationReportHtml.Write(report)),
            .. report.Measured.Pieces.SelectMany(Results),
        ];

    public override void WriteText(Page page)
    {
        page.Verdict(ProfileLead.Of(report), report.IsInTolerance);
        page.Line();
        page.Line(report.Before is { } was
            ? $"{report.Job.Name}: standard deviation {Um(was.Together.StandardDeviationMm)} µm before, "
                + $"{Um(report.Measured.Together.StandardDeviationMm)} µm now; profile {Um(was.Together.ProfileIsoMm)} µm before, "
                + $"{Um(report.Measured.Together.ProfileIsoMm)} µm now"
            : $"{report.Job.Name}: standard deviation {Um(report.Measured.Together.StandardDeviationMm)} µm, profile "
                + $"{Um(report.Measured.Together.ProfileIsoMm)} µm");
        page.Line();
        page.Table(
            ["", "points", "mean µm", "standard deviation µm", "profile ISO 1101 µm", "largest - smallest µm"],
            [
                .. Rows("before", report.Before),
                .. Rows("measured", report.Measured),
                .. Rows("tool radius, before", report.ToolRadiusBefore),
                .. Rows("tool radius", report.ToolRadius)]);
        if (report.Improvement is { } better)
        {
            page.Line(better.Words);
        }

        if (report.ToolRadiusImprovement is { } other)
        {
            page.Line("Compensated by tool radius instead: " + other.Words);
        }

        page.Line(
            "Errors along the normal, positive where material is left, less the stock of the stage. Profile by ISO 1101: twice the "
                + "largest absolute error. Standard deviations use n - 1.");

        if (report.Tolerance is { } tolerance)
        {
            page.Line("Tolerance: " + ProfileWords.Of(tolerance, report.Measured.Pieces[0].Judgement!.UncertaintyMm));
        }

        // If one piece has no alignment, none has.
        if (report.Measured.Pieces[0].Alignment is null)
        {
            page.Line("Alignment: " + AlignmentWords.Of(null));
        }

        foreach (var piece in report.Pieces)
        {
            if (piece.Alignment is not null)
            {
                page.Line($"Alignment of {piece.File}: {AlignmentWords.Of(piece.Alignment)}");
            }

            foreach (var warning in piece.Warnings)
            {
                page.Warning(warning.ToString());
            }
        }

        foreach (var note in report.Pieces.Select(p => p.StageNote).OfType<string>())
        {
            page.Line("Note: " + note);
        }

        page.Line();
        page.Line(
            folder is null
                ? "Nothing was written. Add --out DIR to write evaluation.json, evaluation.html with its maps, and evaluation.qif and "
                    + "evaluation.dfq for other systems."
                : $"Wrote {In("evaluation.html")}, {In("evaluation.json")}, {In(Named(0, "qif"))} and {In(Named(0, "dfq"))}"
                    + (report.Measured.Pieces.Count > 1 ? ", and the same two for each other piece." : "."));
    }

    // A file for other systems has one piece.
    private IEnumerable<(string Path, ReadOnlyMemory<byte> Bytes)> Results(EvaluatedPiece piece, int at)
    {
        var result = EvaluatedResult.Of(report.Job, stock, report.Tolerance, piece);
        return [(In(Named(at, "qif")), QifWriter.Write(result)), (In(Named(at, "dfq")), AqdefWriter.Write(result))];
    }

    private string Named(int piece, string extension) => report.Measured.Pieces.Count > 1
        ? string.Create(CultureInfo.InvariantCulture, $"evaluation-{piece + 1}.{extension}")
        : "evaluation." + extension;

    private static IEnumerable<IReadOnlyList<string>> Rows(string name, SurfaceEvaluation? evaluation)
    {
        if (evaluation is null)
        {
            yield break;
        }

        if (evaluation.Pieces.Count > 1)
        {
            foreach (var piece in evaluation.Pieces)
            {
                yield return Row(piece.File, piece.Statistics);
            }
        }

        yield return Row(evaluation.Pieces.Count > 1 ? name + ", together" : name, evaluation.Together);
    }

    private static IReadOnlyList<string> Row(string name, DeviationStatistics s) =>
        [
            name,
            s.Count.ToString(CultureInfo.InvariantCulture),
            Signed(s.MeanMm),
            Um(s.StandardDeviationMm),
            Um(s.ProfileIsoMm),
            Um(s.ProfileRangeMm)];

    private static string Um(double mm) => (mm * 1000).ToString("0.00", CultureInfo.InvariantCulture);

    private static string Signed(double mm) => (mm * 1000).ToString("+0.00;-0.00;0.00", CultureInfo.InvariantCulture);

    private string In(string name) => PathText.In(folder, name);
}
