using System.Globalization;
using System.Text.Json;
using ErrorMatching.Freeform;
using ErrorMatching.Json;
using ErrorMatching.Reporting;

namespace ErrorMatching.Console;

/// <summary>A probing program.</summary>
/// <param name="job">The job.</param>
/// <param name="plan">Its plan.</param>
/// <param name="probing">The program.</param>
/// <param name="after">The program that it is appended to; null if it is separate.</param>
/// <param name="folder">The folder that it was written to; null if nothing was written.</param>
internal sealed class SurfaceProbeAnswer(
    FreeformJob job, MeasuringPlan plan, ProbingProgram probing, string? after, string? folder) : DocumentAnswer
{
    private const string FileName = "probe.nc";

    public override string Schema => "errormatch/surface-probe/1";

    /// <summary>The files to write; none without a folder.</summary>
    /// <param name="program">The program, alone or appended to the other one.</param>
    public IReadOnlyList<(string Path, ReadOnlyMemory<byte> Bytes)> Files(ReadOnlyMemory<byte> program) =>
        folder is null
            ? []
            : [
                (PathText.In(folder, SurfacePlanAnswer.FileName), PlanCsv.Write(plan)),
                (PathText.In(folder, FileName), program),
                .. probing.Beside is { } beside ? [(PathText.In(folder, beside.Name), beside.Bytes)]
                    : Array.Empty<(string, ReadOnlyMemory<byte>)>(),
            ];

    public override void WriteJson(Utf8JsonWriter json)
    {
        SurfacePlanAnswer.WriteSummary(json, job, plan);
        json.WriteString("dialect", probing.Dialect.Name);
        json.WriteString("template", probing.Template.File);
        json.WriteString("plan", probing.Moves.Plan);
        json.WriteString("after", after);
        json.WriteTexts("assumed", probing.Moves.Assumed);
        json.WriteStartArray("files");
        foreach (var (path, _) in Files(default))
        {
            json.WriteStringValue(path);
        }

        json.WriteEndArray();
    }

    public override void WriteText(Page page)
    {
        page.Heading(string.Create(
            CultureInfo.InvariantCulture,
            $"{job.Name}: "
                + $"{ReportNumber.Count(plan.Points.Count, "point is", "points are")} touched "
                + $"by a program for {probing.Dialect.Name}"));
        page.Line();
        SurfacePlanAnswer.WriteSummary(page, plan);
        page.Line($"Template {probing.Template.File}: {probing.Template.About}");
        page.Line(string.Create(
            CultureInfo.InvariantCulture,
            $"All coordinates are those of the ball's center; the measuring move goes along the normal from "
                + $"{job.Measuring.ApproachMm:0.###} mm before the surface to {job.Measuring.OvertravelMm:0.###} mm behind it and stops "
                + $"with an alarm if it finds nothing."));
        if (probing.Moves.Assumed.Count > 0)
        {
            page.Line($"Nobody stated {string.Join(", ", probing.Moves.Assumed)}: the program stops before its first move for somebody to "
                + "check.");
        }

        page.Line(
            after is null
                ? "The work offset is G54: a template of your own names another."
                : $"It follows {after} in one program, in the work offset of that, and stops behind the last point for the finishing "
                    + $"program.");
        page.Line();
        page.Line(folder is null
            ? $"Nothing was written. Add --out DIR to write {FileName} and {SurfacePlanAnswer.FileName}."
            : $"Wrote {string.Join(", ", Files(default).Select(f => f.Path))}. Next: run probe.nc, fetch its "
                + $"log, then: errormatch surface compensate {job.File} --measured LOG --out {folder}");
    }
}
