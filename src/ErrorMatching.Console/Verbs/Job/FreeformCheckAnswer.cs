using System.Globalization;
using System.Text.Json;
using ErrorMatching.Freeform;
using ErrorMatching.Nc;
using ErrorMatching.Reporting;

namespace ErrorMatching.Console;

/// <summary>The content of a valid free-form job.</summary>
internal sealed class FreeformCheckAnswer(FreeformJob job) : DocumentAnswer
{
    public override string Schema => "errormatch/job-check/1";

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("file", job.File);
        json.WriteString("sha256", job.Sha256);
        json.WriteBoolean("valid", true);
        json.WriteStartObject("summary");
        json.WriteString("kind", JobKind.Freeform);
        json.WriteString("name", job.Name);
        json.WriteString("workOrder", job.WorkOrder);
        json.WriteString("measuringDialect", job.Measuring.Dialect);
        json.WriteString("toolpathDialect", job.Toolpath.Dialect);
        json.WriteString("method", Method);
        json.WriteNumber("gain", job.Compensation.Gain);
        json.WriteString("fit", job.Fit.Method.Name);
        json.WriteString("of", job.Fit.OfError ? "error" : "points");
        if (job.Profile is { } profile)
        {
            json.WriteNumber("profileToleranceMm", profile.WidthMm);
        }

        json.WriteEndObject();
        new NamedFiles(Files).WriteJson(json);
    }

    public override void WriteText(Page page)
    {
        page.Heading($"{job.File} is a valid free-form job: {job.Name}");
        page.Line();
        page.Table(["what", ""],
        [
            ["measuring", $"{Points}, stylus {Mm(job.Measuring.StylusDiameterMm)}, dialect {job.Measuring.Dialect}"],
            ["stock", $"roughing {Mm(job.Stock.RoughingMm)}, semi-finishing {Mm(job.Stock.SemiFinishingMm)}"],
            ["tool", $"ball {Mm(job.Tool.DiameterMm)}, {Number(job.Tool.SpindleRpm)} rpm, {Number(job.Tool.FeedMmPerMin)} mm/min"],
            [
                "tool path",
                $"along {(job.Toolpath.AlongU ? "u" : "v")}, scallop {Mm(job.Toolpath.ScallopMm)}, chord {Mm(job.Toolpath.ChordMm)}, "
                    + $"dialect {job.Toolpath.Dialect}"],
            [
                "compensation",
                $"{Method}, gain {Number(job.Compensation.Gain)}, at most {Mm(job.Compensation.LimitMm)}; {job.Fit.Method.Name} fit of "
                    + $"the {(job.Fit.OfError ? "error" : "points")}"],
            .. job.Profile is { } profile
                ? new[] { new[] { "tolerance", ProfileWords.Of(profile, job.Measuring.UncertaintyMm) } }
                : [],
        ]);
        page.Line();
        new NamedFiles(Files).WriteText(page);
    }

    private string Method => job.Compensation.Mirror ? "mirror" : "tool-radius";

    private string Points => job.Measuring switch
    {
        { ReconstructionErrorMm: { } error } => $"as many points as {Mm(error)} takes",
        { PointsPerCurve: { } each } m => $"{m.Curves} curves of {each} points",
        var m => $"{ReportNumber.Count(m.Points ?? 0, "point")} on {ReportNumber.Count(m.Curves ?? 0, "curve")}",
    };

    private IEnumerable<(string Role, string File)> Files => new (string Role, string? File)[]
    {
        ("surface", job.Surface.File),
        ("template", job.Measuring.Template),
        ("measuring-dialect", NcDialects.IsFile(job.Measuring.Dialect) ? job.Measuring.Dialect : null),
        ("toolpath-dialect", NcDialects.IsFile(job.Toolpath.Dialect) ? job.Toolpath.Dialect : null),
    }.Where(f => f.File is not null).Select(f => (f.Role, job.PathOf(f.File!)));

    private static string Mm(double value) => Number(value) + " mm";

    private static string Number(double value) => value.ToString("0.######", CultureInfo.InvariantCulture);
}
