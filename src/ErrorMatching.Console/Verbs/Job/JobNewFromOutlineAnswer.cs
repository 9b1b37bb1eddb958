using System.Globalization;
using System.Text.Json;
using ErrorMatching.Geometry;
using ErrorMatching.Jobs;
using ErrorMatching.Reporting;

namespace ErrorMatching.Console;

/// <summary>A mating job made from a drawing and a program.</summary>
/// <param name="file">The job.</param>
/// <param name="theoretical">The file of its key points as designed.</param>
/// <param name="made">What it was made of.</param>
internal sealed class JobNewFromOutlineAnswer(string file, string theoretical, OutlineJob made) : DocumentAnswer
{
    // More are listed by --json alone.
    private const int MostShown = 200;

    public override string Schema => "errormatch/job-new-from-outline/1";

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("file", file);
        json.WriteString("theoretical", theoretical);
        json.WriteString("layer", made.Layer);
        json.WriteNumber("unitMm", made.UnitMm);
        json.WriteStartObject("frame");
        json.WriteString("mirror", MirrorWord);
        json.WriteNumber("rotateDeg", made.Frame.Rotation.Degrees);
        json.WriteStartArray("translateMm");
        json.WriteNumberValue(made.Frame.Translation.X);
        json.WriteNumberValue(made.Frame.Translation.Y);
        json.WriteEndArray();
        json.WriteEndObject();
        json.WriteNumber("toolDiameterMm", made.ToolDiameterMm);
        json.WriteNumber("coveredShare", made.CoveredShare);
        json.WriteNumber("rmsMm", made.RmsMm);
        json.WriteNumber("largestMm", made.LargestMm);
        json.WriteStartArray("features");
        foreach (var (name, kind, points, blocks) in made.Features)
        {
            json.WriteStartObject();
            json.WriteString("name", name);
            json.WriteString("kind", kind.Word);
            json.WriteNumber("points", points);
            json.WriteTexts("blocks", blocks);
            WriteLimits(json, made.Limits.TryGetValue(name, out var limits) ? limits : null);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteStartArray("tolerances");
        foreach (var tolerance in made.Tolerances)
        {
            WriteTolerance(json, tolerance);
        }

        json.WriteEndArray();
        json.WriteTexts("notes", made.Notes);
    }

    public override void WriteText(Page page)
    {
        page.Heading($"{file}: {ReportNumber.Count(made.Features.Count, "feature")} with "
            + $"{ReportNumber.Count(made.Features.Sum(f => f.Points), "key point")} from the layer {PrintedText.OneLine(made.Layer)}");
        page.Line();
        var (rotation, shift) = (made.Frame.Rotation.Degrees, made.Frame.Translation);
        page.Line(string.Create(
            CultureInfo.InvariantCulture,
            $"Laid on the program by mirror {MirrorWord}, rotation {rotation:0.####}°, shift X {shift.X:0.####} Y {shift.Y:0.####} mm, "
                + $"with a tool of {made.ToolDiameterMm:0.###} mm: {made.CoveredShare:0 %} of the outline is cut. There the program leaves "
                + $"the key points {made.RmsMm:0.0000} mm (rms) and at most {made.LargestMm:0.0000} mm off."));
        page.Line(string.Create(CultureInfo.InvariantCulture, $"One unit of the drawing is {made.UnitMm:0.######} mm."));
        page.Line();
        page.Table(
            ["feature", "kind", "points", "blocks"],
            made.Features.Select(f => (IReadOnlyList<string>)
                [f.Name, f.Kind.Word, ReportNumber.Count(f.Points), string.Join(", ", f.Blocks)]));
        page.Line();
        if (made.Tolerances.Count > 0)
        {
            WriteTolerances(page);
        }

        foreach (var note in made.Notes)
        {
            page.Line($"Note: {note}");
        }

        string[] missing = [.. made.Features.Select(f => f.Name).Where(n => !made.Limits.ContainsKey(n))];
        page.Line($"Wrote {file} and {theoretical}. " + (missing.Length == 0
            ? "All limits are the model's, and 0.005 mm stands there for the gauge. Write your own uncertainty"
            : made.Limits.Count == 0
                ? "The drawing says no limits: ±0.05 mm stands at each feature, and 0.005 mm for the gauge. Write your own"
                : $"The model says no limits of {string.Join(", ", missing)}: ±0.05 mm stands there, and 0.005 mm for the gauge. "
                    + "Write your own")
            + $", then: errormatch job check {file}");
    }

    // Those that became limits first.
    private void WriteTolerances(Page page)
    {
        OutlineTolerance[] ordered = [
            .. made.Tolerances.Where(t => t.Became != OutlineTolerance.Asked),
            .. made.Tolerances.Where(t => t.Became == OutlineTolerance.Asked)];
        var asked = made.Tolerances.Count(t => t.Became == OutlineTolerance.Asked);
        page.Line($"The model has {ReportNumber.Count(ordered.Length, "dimension or tolerance", "dimensions and tolerances")}: "
            + $"{ReportNumber.Count(ordered.Length - asked)} became limits, {ReportNumber.Count(asked)} {(asked == 1 ? "is" : "are")} "
            + "asked: decide what of them the job needs.");
        foreach (var tolerance in ordered.Take(MostShown))
        {
            var name = PrintedText.OneLine(tolerance.Name.Length > 0 ? $"{tolerance.Name}, {tolerance.Entity}" : tolerance.Entity);
            page.Line($"  {name}{Value(tolerance)}: {Became(tolerance)}{PrintedText.OneLine(tolerance.Reason)}.");
        }

        if (ordered.Length > MostShown)
        {
            page.Line($"  ... and {ReportNumber.Count(ordered.Length - MostShown)} more: --json lists them all.");
        }

        page.Line();
    }

    private string Became(OutlineTolerance tolerance)
    {
        if (tolerance.Became == OutlineTolerance.Asked)
        {
            return "asked: ";
        }

        var features = string.Join(", ", tolerance.Features.Select(f => string.Create(
            CultureInfo.InvariantCulture, $"{f} [{made.Limits[f].Lower:0.######}, {made.Limits[f].Upper:0.######}] mm")));
        return (tolerance.Became == OutlineTolerance.Limits ? "limits of " : "limits, at least as strict, of ") + features + ": ";
    }

    private static string Value(OutlineTolerance tolerance)
    {
        var (value, unit) = tolerance.ValueMm is not null ? (tolerance.ValueMm, " mm") : (tolerance.ValueDegrees, "°");
        var limits = tolerance is { Lower: { } lower, Upper: { } upper }
            ? string.Create(CultureInfo.InvariantCulture, $" ({lower:+0.######;-0.######;0}, {upper:+0.######;-0.######;0})")
            : "";
        return value is null ? "" : string.Create(CultureInfo.InvariantCulture, $" {value:0.######}{limits}{unit}");
    }

    private static void WriteLimits(Utf8JsonWriter json, (double Lower, double Upper, string From)? limits)
    {
        if (limits is not var (lower, upper, from))
        {
            json.WriteNull("toleranceMm");
            json.WriteNull("toleranceFrom");
            return;
        }

        json.WriteStartArray("toleranceMm");
        json.WriteNumberValue(lower);
        json.WriteNumberValue(upper);
        json.WriteEndArray();
        json.WriteString("toleranceFrom", from);
    }

    private static void WriteTolerance(Utf8JsonWriter json, OutlineTolerance tolerance)
    {
        json.WriteStartObject();
        json.WriteString("name", tolerance.Name);
        json.WriteString("entity", tolerance.Entity);
        json.WriteNumber("line", tolerance.Line);
        json.WriteString("kind", tolerance.Kind);
        json.WriteNumberOrNull("valueMm", tolerance.ValueMm);
        json.WriteNumberOrNull("valueDeg", tolerance.ValueDegrees);
        json.WriteNumberOrNull("lower", tolerance.Lower);
        json.WriteNumberOrNull("upper", tolerance.Upper);
        json.WriteNumberOrNull("unitMm", tolerance.UnitMm);
        json.WriteTexts("datums", tolerance.Datums);
        json.WriteTexts("faces", tolerance.Faces);
        json.WriteString("became", tolerance.Became);
        json.WriteTexts("features", tolerance.Features);
        json.WriteString("reason", tolerance.Reason);
        json.WriteEndObject();
    }

    private string MirrorWord => made.Frame.Mirror switch { Mirror.X => "x", Mirror.Y => "y", _ => "none" };
}
