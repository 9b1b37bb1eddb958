using System.Globalization;
using System.Text.Json;
using ErrorMatching.Freeform;
using ErrorMatching.Geometry;
using ErrorMatching.Json;
using ErrorMatching.Nc;
using ErrorMatching.Reporting;

namespace ErrorMatching.Console;

/// <summary>A tool path over a surface.</summary>
/// <param name="job">The job.</param>
/// <param name="path">The path.</param>
/// <param name="dialect">The control's dialect.</param>
/// <param name="stage">The cutting stage.</param>
/// <param name="callsTool">True if the program calls its tool; false if it starts with a stop and an alarm.</param>
/// <param name="folder">The folder that the program was written to; null if nothing was written.</param>
internal sealed class SurfaceToolpathAnswer(
    FreeformJob job, ToolPath path, NcDialect dialect, CuttingStage stage, bool callsTool, string? folder)
    : DocumentAnswer
{
    public override string Schema => "errormatch/surface-toolpath/1";

    /// <summary>The program's path.</summary>
    public string File => PathText.In(folder, FinishingProgram.FileOf(stage));

    private string Stage => Path.GetFileNameWithoutExtension(FinishingProgram.FileOf(stage));

    public override void WriteJson(Utf8JsonWriter json)
    {
        var c = path.Certificate;
        json.WriteString("job", job.Name);
        json.WriteString("stage", Stage);
        json.WriteString("dialect", dialect.Name);
        json.WriteString("file", folder is null ? null : File);
        json.WriteBoolean("toolCall", callsTool);
        json.WriteNumber("stockMm", path.StockMm);
        json.WriteNumber("passes", path.Passes);
        json.WriteNumber("points", path.Points);
        json.WriteNumber("lengthMm", path.LengthMm);
        json.WriteNumber("cuttingMinutes", path.LengthMm / job.Tool.FeedMmPerMin);
        json.WriteStartObject("certificate");
        Measured(json, "scallop", c.ScallopMm, job.Toolpath.ScallopMm, c.ScallopAt);
        Measured(json, "chord", c.ChordMm, job.Toolpath.ChordMm, c.ChordAt);
        json.WriteNumber("noCenterNearerThanMm", path.RadiusMm + path.StockMm - c.GougeMm);
        json.WriteNumber("raisedPoints", c.RaisedPoints);
        json.WriteNumber("raisedMm", c.RaisedMm);
        json.WriteEndObject();
        new ReportWriter(json).Warnings(callsTool ? [] : [ReportWarning.Of(SurfaceWarningForms.NoToolCall)]);
    }

    public override void WriteText(Page page)
    {
        var c = path.Certificate;
        if (!callsTool)
        {
            page.Heading($"{job.Name}: {File} has no tool call and stops with an alarm");
            page.Line();
            page.Warning(FinishingProgram.NoToolCall);
            page.Line();
        }

        page.Heading(string.Create(
            CultureInfo.InvariantCulture,
            $"{job.Name}: {Stage} in {ReportNumber.Count(path.Passes, "pass", "passes")} with "
                + $"{ReportNumber.Count(path.Points, "point")}, {path.LengthMm:0} mm or "
                + $"{path.LengthMm / job.Tool.FeedMmPerMin:0.0} min at the feed"));
        page.Line();
        page.Table(
            ["measured on the rounded numbers", "mm", "allowed", "at x", "y", "z"],
            [
                Row("scallop", c.ScallopMm, job.Toolpath.ScallopMm, c.ScallopAt),
                Row("chordal error", c.ChordMm, job.Toolpath.ChordMm, c.ChordAt)]);
        page.Line(string.Create(
            CultureInfo.InvariantCulture,
            $"Coordinates have {path.Decimals} decimals ({dialect.Name}); the program moves the "
                + $"{(job.Toolpath.ProgramsTip ? "tip" : "center")} of the ball and leaves {path.StockMm:0.###} mm. No center is nearer "
                + $"to the surface than {path.RadiusMm + path.StockMm - c.GougeMm:0.000###} mm."));
        if (c.RaisedPoints > 0)
        {
            page.Warning(string.Create(
                CultureInfo.InvariantCulture,
                $"{ReportNumber.Count(c.RaisedPoints, "point was", "points were")} raised by up to "
                    + $"{c.RaisedMm:0.0000} mm where the ball does not fit, near x "
                    + $"{c.RaisedAt.X:0.000}, y {c.RaisedAt.Y:0.000}: more stock is left there."));
        }

        page.Line();
        page.Line(folder is null ? "Nothing was written. Add --out DIR to write the program."
            : callsTool ? $"Wrote {File}. Next: look at it with errormatch nc check {File} --dialect {dialect.Name}."
            : $"Wrote {File}. Next: name the tool in {job.File} (toolpath.tool), and run this again.");
    }

    private static void Measured(Utf8JsonWriter json, string name, double mm, double allowed, Point3 at)
    {
        json.WriteStartObject(name);
        json.WriteNumber("mm", mm);
        json.WriteNumber("allowedMm", allowed);
        json.WriteNumber("x", at.X);
        json.WriteNumber("y", at.Y);
        json.WriteNumber("z", at.Z);
        json.WriteEndObject();
    }

    private static IReadOnlyList<string> Row(string name, double mm, double allowed, Point3 at) =>
        [
            name,
            mm.ToString("0.000000", CultureInfo.InvariantCulture),
            allowed.ToString("0.000###", CultureInfo.InvariantCulture),
            Coordinate(at.X),
            Coordinate(at.Y),
            Coordinate(at.Z)];

    private static string Coordinate(double mm) => mm.ToString("0.000", CultureInfo.InvariantCulture);
}
