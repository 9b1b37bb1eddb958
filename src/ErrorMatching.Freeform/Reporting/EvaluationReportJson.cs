using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>Writes an evaluation as JSON, with lengths in micrometers if the key says so.</summary>
public static class EvaluationReportJson
{
    /// <summary>Writes the document <c>errormatch/surface-evaluate/1</c>.</summary>
    public static byte[] Write(EvaluationReport report)
    {
        ArgumentNullException.ThrowIfNull(report);
        return ReportWriter.Document("errormatch/surface-evaluate/1", json =>
        {
            json.Job("freeform", report.Job);
            json.Inputs(report.Inputs);
            if (report.Tolerance is { } tolerance)
            {
                json.Object("verdict", () => Verdict(json, report, tolerance));
            }

            Evaluation(json, report.Measured);
            json.Optional("before", report.Before, b => Evaluation(json, b));
            Improvement(json, report.Improvement);
            json.Optional("toolRadius", report.ToolRadius, t =>
            {
                Evaluation(json, t);
                json.Optional("before", report.ToolRadiusBefore, b => Evaluation(json, b));
                Improvement(json, report.ToolRadiusImprovement);
            });
        });
    }

    /// <summary>Writes the members of statistics into the open object.</summary>
    internal static void Statistics(ReportWriter json, DeviationStatistics statistics)
    {
        json.Count("count", statistics.Count);
        json.Number("meanUm", statistics.MeanMm * 1000);
        json.Number("standardDeviationUm", statistics.StandardDeviationMm * 1000);
        json.Number("profileIsoUm", statistics.ProfileIsoMm * 1000);
        json.Number("profileRangeUm", statistics.ProfileRangeMm * 1000);
    }

    /// <summary>Reads what <see cref="Statistics"/> writes.</summary>
    internal static DeviationStatistics ReadStatistics(ReportReader json) => new(
        json.Count("count"),
        json.Micrometers("meanUm"),
        json.Micrometers("standardDeviationUm"),
        json.Micrometers("profileIsoUm"),
        json.Micrometers("profileRangeUm"));

    /// <summary>Writes the members of an alignment.</summary>
    internal static void Alignment(ReportWriter json, SurfaceAlignment? alignment)
    {
        json.Text("alignment", alignment is null ? "none" : "best-fit");
        json.Optional("transform", alignment, a =>
        {
            json.Numbers("translateMm", [a.TranslateMm.X, a.TranslateMm.Y, a.TranslateMm.Z]);
            json.Numbers("rotateDegrees", [a.RotateDegrees.X, a.RotateDegrees.Y, a.RotateDegrees.Z]);
            json.Numbers("centerMm", [a.Center.X, a.Center.Y, a.Center.Z]);
        });
    }

    /// <summary>Reads what <see cref="Alignment"/> writes.</summary>
    internal static SurfaceAlignment? ReadAlignment(ReportReader json) => json.OptionalObject("transform") is { } transform
        ? new(transform.Vector3("translateMm"), transform.Vector3("rotateDegrees"), transform.Point3("centerMm"))
        : null;

    private static void Verdict(ReportWriter json, EvaluationReport report, ProfileTolerance tolerance)
    {
        json.Text("code", ProfileWords.Of(report.Measured.Pieces.Max(p => p.Judgement!.Code)));
        json.Flag("inTolerance", report.IsInTolerance == true);
        SurfaceVerdict.Write(json, tolerance);
        json.Count("pieces", report.Measured.Pieces.Count);
        json.Count("piecesWithin", report.Measured.Pieces.Count(p => p.Judgement!.IsWithin));
        json.Text("sentence", ProfileLead.Of(report));
    }

    private static void Improvement(ReportWriter json, SurfaceImprovement? improvement) => json.Optional("improvement", improvement, i =>
    {
        json.Number("standardDeviationPercent", i.StandardDeviationPercent);
        json.Number("profileIsoPercent", i.ProfileIsoPercent);
    });

    private static void Evaluation(ReportWriter json, SurfaceEvaluation evaluation)
    {
        Statistics(json, evaluation.Together);
        json.List("pieces", evaluation.Pieces, p =>
        {
            json.Text("file", p.File);
            json.Text("sha256", p.Sha256);
            json.Text("stage", MeasuredStage.Name(p.Stage));
            json.Warnings(p.Warnings);
            Alignment(json, p.Alignment);
            Statistics(json, p.Statistics);
            if (p.Judgement is { } judgement)
            {
                json.Object("verdict", () => judgement.Write(json));
            }

            json.List("points", p.Samples, s =>
            {
                json.Count("point", s.Point);
                json.Count("i", s.I);
                json.Count("j", s.J);
                json.Number("errorUm", s.ErrorMm * 1000);
            });
        });
    }
}
