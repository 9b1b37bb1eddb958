using System.Globalization;
using System.Text.Json;
using ErrorMatching.Jobs;
using ErrorMatching.Reporting;

namespace ErrorMatching.Console;

/// <summary>The program that touches the key points of a part.</summary>
/// <param name="probed">The program.</param>
/// <param name="written">The files that were written, the program first.</param>
internal sealed class JobProbeAnswer(ProbedJob probed, IReadOnlyList<string> written) : DocumentAnswer
{
    public override string Schema => "errormatch/job-probe/1";

    private string Piece => probed.OfCounterpart ? "counterpart" : "part";

    public override void WriteJson(Utf8JsonWriter json)
    {
        var moves = probed.Program.Moves;
        json.WriteString("job", probed.Job.File);
        json.WriteString("piece", Piece);
        json.WriteString("dialect", probed.Program.Dialect.Name);
        json.WriteString("template", probed.Program.Template.File);
        json.WriteString("plan", moves.Plan);
        json.WriteNumber("count", probed.Points.Count);
        json.WriteNumber("stylusDiameterMm", moves.StylusDiameterMm);
        json.WriteNumber("touchZ", probed.TouchZ);
        json.WriteNumber("clearanceZ", moves.ClearanceZ);
        json.WriteNumber("overtravelMm", moves.OvertravelMm);
        json.WriteNumber("feedMmPerMin", moves.FeedMmPerMin);
        json.WriteTexts("assumed", moves.Assumed);
        json.WriteTexts("notes", probed.Notes);
        json.WriteStartArray("points");
        foreach (var (touch, point) in moves.Touches.Zip(probed.Points))
        {
            json.WriteStartObject();
            json.WriteNumber("number", touch.Number);
            json.WriteString("point", point.Label);
            json.WriteNumber("approachMm", point.ApproachMm);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteTexts("files", written);
    }

    public override void WriteText(Page page)
    {
        var moves = probed.Program.Moves;
        page.Heading($"{probed.Job.Name}: {ReportNumber.Count(probed.Points.Count, "point is", "points are")} touched by a program for "
            + probed.Program.Dialect.Name);
        page.Line();
        page.Line(string.Create(
            CultureInfo.InvariantCulture,
            $"The center of a ball of {moves.StylusDiameterMm:0.###} mm moves at Z{probed.TouchZ:0.###}, from outside of the {Piece} along "
                + $"its normal, and travels at Z{moves.ClearanceZ:0.###}. A miss of {moves.OvertravelMm:0.###} mm stops the control."));
        var offset = probed.Program.Dialect.HasCodes ? "work offset (G54)" : "preset";
        page.Line((probed.OfCounterpart
            ? $"X and Y are those of the counterpart's program: touch it in the {offset} in which it was cut. "
            : $"X and Y are those of the part as designed: set its {offset} there. ")
            + "The length of the probe is to the center of its ball; the shank must not be thicker than the ball.");
        page.Line($"Template {probed.Program.Template.File}: {probed.Program.Template.About}");
        if (moves.Assumed.Count > 0)
        {
            page.Line($"Nobody stated {string.Join(", ", moves.Assumed)}: the program stops before its first move for somebody to check. "
                + "Options state it, see --help, but for what a template takes for granted of its control.");
        }

        foreach (var note in probed.Notes)
        {
            page.Line($"Note: {note}");
        }

        page.Line("No machine of ours has run it: make the first run with reduced feed, a hand on the stop.");
        page.Line(written.Count == 0
            ? $"Nothing was written. Add --out DIR to write {probed.FileName}."
            : $"Wrote {string.Join(" and ", written)}. Next: run it, fetch its log, then: "
                + (probed.OfCounterpart
                    ? $"errormatch verify {probed.Job.File} --before BEFORE --after LOG"
                    : $"errormatch match {probed.Job.File} --part LOG --out DIR"));
    }
}
