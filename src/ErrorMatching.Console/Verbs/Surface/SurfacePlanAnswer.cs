using System.Globalization;
using System.Text.Json;
using ErrorMatching.Freeform;
using ErrorMatching.Json;
using ErrorMatching.Reporting;

namespace ErrorMatching.Console;

/// <summary>The touch points of a surface.</summary>
/// <param name="job">The job.</param>
/// <param name="plan">The plan.</param>
/// <param name="folder">The folder that it was written to; null if nothing was written.</param>
internal sealed class SurfacePlanAnswer(FreeformJob job, MeasuringPlan plan, string? folder) : DocumentAnswer
{
    /// <summary>Name of the plan's table.</summary>
    public const string FileName = "plan.csv";

    private const int RowsShown = 12;

    public override string Schema => "errormatch/surface-plan/1";

    /// <summary>Writes the members that a plan and its probing program share.</summary>
    public static void WriteSummary(Utf8JsonWriter json, FreeformJob job, MeasuringPlan plan)
    {
        json.WriteString("job", job.File);
        json.WriteString("name", job.Name);
        json.WriteString("surface", plan.Surface.Name);
        json.WriteNumber("count", plan.Points.Count);
        json.WriteNumber("curves", plan.Curves);
        json.Number("stockMm", plan.StockMm);
        json.Number("reconstructionErrorMm", plan.ReconstructionErrorMm);
        json.Number("rimSetInMm", plan.RimSetInMm);
        json.Number("trimSetInMm", plan.TrimSetInMm);
        json.Numbers("breaksU", plan.BreaksU);
        json.Numbers("breaksV", plan.BreaksV);
        json.Number("clearanceZ", plan.ClearanceZ);
        json.Number("travelMm", plan.TravelMm);
    }

    /// <summary>Writes as text what a plan and its probing program share.</summary>
    public static void WriteSummary(Page page, MeasuringPlan plan)
    {
        var each = plan.Points.GroupBy(p => p.J).Select(g => g.Count()).Distinct().Order().ToArray();
        page.Line(string.Create(
            CultureInfo.InvariantCulture,
            $"{plan.Curves} curves of {(each.Length == 1 ? $"{each[0]}" : $"{each[0]} to {each[^1]}")} points; stock on the surface "
                + $"{plan.StockMm:0.###} mm; stylus ball {plan.Measuring.StylusDiameterMm:0.###} mm."));
        page.Line(string.Create(
            CultureInfo.InvariantCulture,
            $"The points alone know the nominal surface to {1000 * plan.ReconstructionErrorMm:0.000} µm (predicted: piecewise cubic "
                + $"through them, the fits are smoother)."));
        page.Line(plan.BreaksU.Count + plan.BreaksV.Count == 0
            ? "No curvature breaks."
            : string.Create(
                CultureInfo.InvariantCulture,
                $"Curvature breaks with points of their own: "
                    + $"{string.Join(", ", plan.BreaksU.Select(b => Break("u", b)).Concat(plan.BreaksV.Select(b => Break("v", b))))}."));
        var trimmed = plan.TrimSetInMm > 0
            ? $" and {plan.TrimSetInMm.ToString("0.###", CultureInfo.InvariantCulture)} mm from trimmed edges"
            : "";
        page.Line(string.Create(
            CultureInfo.InvariantCulture,
            $"Points stay {plan.RimSetInMm:0.###} mm from the ends of the surface{trimmed}. The ball's center travels {plan.TravelMm:0} "
                + $"mm, across at Z{plan.ClearanceZ:0.###}."));
    }

    public override void WriteJson(Utf8JsonWriter json)
    {
        WriteSummary(json, job, plan);
        json.WriteStartArray("points");
        foreach (var point in plan.Points)
        {
            json.WriteStartObject();
            json.WriteNumber("point", point.Number);
            json.WriteNumber("i", point.I);
            json.WriteNumber("j", point.J);
            json.Number("u", point.U);
            json.Number("v", point.V);
            json.Numbers("position", [point.Position.X, point.Position.Y, point.Position.Z]);
            json.Numbers("normal", [point.Normal.X, point.Normal.Y, point.Normal.Z]);
            json.WriteString("reason", PlanCsv.NameOf(point.Reason));
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteStartArray("files");
        if (folder is not null)
        {
            json.WriteStringValue(PathText.In(folder, FileName));
        }

        json.WriteEndArray();
    }

    public override void WriteText(Page page)
    {
        page.Heading(string.Create(CultureInfo.InvariantCulture, $"{job.Name}: "
            + $"{ReportNumber.Count(plan.Points.Count, "point")} on {plan.Surface.Name}"));
        page.Line();
        page.Table(
            ["point", "i", "j", "x", "y", "z", "nx", "ny", "nz", "reason"],
            plan.Points.Take(RowsShown).Select(p => (IReadOnlyList<string>)
            [
                Whole(p.Number), Whole(p.I), Whole(p.J), Show.Mm(p.Position.X), Show.Mm(p.Position.Y), Show.Mm(p.Position.Z),
                Show.Mm(p.Normal.X), Show.Mm(p.Normal.Y), Show.Mm(p.Normal.Z), PlanCsv.NameOf(p.Reason),
            ]));
        if (plan.Points.Count > RowsShown)
        {
            page.Line(string.Create(
                CultureInfo.InvariantCulture, $"... and {plan.Points.Count - RowsShown} more, all of them in {FileName}."));
        }

        page.Line();
        WriteSummary(page, plan);
        if (plan.FacesDown)
        {
            page.Line(
                "The surface faces down: only a machine that reaches it from below can measure it. Turn the piece over for a probing "
                    + "program and a tool path.");
        }

        page.Line();
        page.Line(folder is null
            ? $"Nothing was written. Add --out DIR to write {FileName}."
            : $"Wrote {PathText.In(folder, FileName)}."
                + (plan.FacesDown ? "" : $" Next: errormatch surface probe {job.File} --out {folder}"));
    }

    private static string Whole(int value) => value.ToString(CultureInfo.InvariantCulture);

    private static string Break(string parameter, double at) => $"{parameter} = {at.ToString("0.####", CultureInfo.InvariantCulture)}";
}
