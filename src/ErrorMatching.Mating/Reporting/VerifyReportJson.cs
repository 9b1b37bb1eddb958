using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The report of a verification as JSON, schema <c>errormatch/verify/1</c>.</summary>
/// <remarks>Lengths are in millimeters, angles in degrees, numbers rounded to the ninth decimal. UTF-8 without a byte order mark, lines
/// end with a line feed.</remarks>
public static class VerifyReportJson
{
    /// <summary>Name of the schema.</summary>
    public const string Schema = "errormatch/verify/1";

    /// <summary>The report as a document.</summary>
    public static byte[] Write(VerifyReport report)
    {
        ArgumentNullException.ThrowIfNull(report);
        return ReportWriter.Document(Schema, w =>
        {
            w.Job("mating", report.Job);
            w.Inputs(report.Inputs);
            w.List("points", report.Result.Points, p =>
            {
                w.Text("point", p.Label);
                w.Point("part", p.Part);
                w.Vector("normal", p.Normal);
                w.Object("before", () => WriteError(w, p.BeforeError));
                w.Object("after", () => WriteError(w, p.AfterError));
            });
            w.List("features", report.Result.Features, f =>
            {
                w.Text("name", f.Name);
                w.Text("quantity", f.Quantity.Word);
                w.Number("wanted", f.Wanted);
                w.Number("before", f.Before);
                w.Number("after", f.After);
                w.Number("improvementPercent", f.ImprovementPercent);
                w.Texts("points", f.Points);
            });
            w.Flag("beforeMeasured", report.IsBeforeMeasured);
            w.Number("maxBeforeMm", report.Result.MaxBeforeMm);
            w.Number("maxAfterMm", report.Result.MaxAfterMm);
            w.Number("rmsBeforeMm", report.Result.RmsBeforeMm);
            w.Number("rmsAfterMm", report.Result.RmsAfterMm);
            w.List("boundaries", report.Boundaries, b =>
            {
                w.Text("name", b.Name);
                w.Numbers("toleranceMm", [b.Band.LowerMm, b.Band.UpperMm]);
                w.List("points", b.Points, p =>
                {
                    w.Text("point", p.Label);
                    w.Point("theoretical", p.Theoretical);
                });
                w.Points("outline", b.Outline);
            });
            w.Texts("warnings", report.Warnings);
        });
    }

    private static void WriteError(ReportWriter w, MatingError error)
    {
        w.Number("dx", error.Vector.X);
        w.Number("dy", error.Vector.Y);
        w.Number("normalMm", error.NormalMm);
    }
}
