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
            json.WriteStartArray("blocks");
            foreach (var block in blocks)
            {
                json.WriteStringValue(block);
            }

            json.WriteEndArray();
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteStartArray("notes");
        foreach (var note in made.Notes)
        {
            json.WriteStringValue(note);
        }

        json.WriteEndArray();
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
        foreach (var note in made.Notes)
        {
            page.Line($"Note: {note}");
        }

        page.Line($"Wrote {file} and {theoretical}. The drawing says no limits: ±0.05 mm stands at each feature, and 0.005 mm for the "
            + $"gauge. Write your own, then: errormatch job check {file}");
    }

    private string MirrorWord => made.Frame.Mirror switch { Mirror.X => "x", Mirror.Y => "y", _ => "none" };
}
