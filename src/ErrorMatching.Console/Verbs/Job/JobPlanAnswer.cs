using System.Globalization;
using System.Text.Json;
using ErrorMatching.Jobs;
using ErrorMatching.Mating;
using ErrorMatching.Reporting;

namespace ErrorMatching.Console;

/// <summary>Where to touch the part of a mating job.</summary>
/// <param name="planned">The plan.</param>
/// <param name="plan">The table that was written; null if none was.</param>
/// <param name="job">The job that was written; null if none was.</param>
internal sealed class JobPlanAnswer(PlannedJob planned, string? plan, string? job) : DocumentAnswer
{
    // Medians of a few drawn parts differ by as much without a reason.
    private const double Alike = 1.03;

    public override string Schema => "errormatch/job-plan/1";

    public override void WriteJson(Utf8JsonWriter json)
    {
        json.WriteString("job", planned.Job.File);
        json.WriteNumber("stylusDiameterMm", planned.Plan.StylusDiameterMm);
        json.WriteBoolean("stylusAssumed", planned.IsStylusAssumed);
        json.WriteNumber("count", planned.Plan.Points.Count());
        Write(json, "prediction", planned.Prediction);
        Write(json, "twoLess", planned.TwoLess);
        json.WriteStartArray("points");
        foreach (var feature in planned.Plan.Features)
        {
            foreach (var point in feature.Lists.SelectMany(l => l))
            {
                json.WriteStartObject();
                json.WriteString("point", point.Label);
                json.WriteString("feature", feature.Name);
                Pair("place", point.Place.X, point.Place.Y);
                Pair("normal", point.Normal.X, point.Normal.Y);
                json.WriteNumber("approachMm", point.ApproachMm);
                json.WriteString("reason", PlannedJob.NameOf(point.Reason));
                json.WriteEndObject();
            }
        }

        json.WriteEndArray();
        json.WriteStartArray("notes");
        foreach (var note in Notes())
        {
            json.WriteStringValue(note);
        }

        json.WriteEndArray();
        json.WriteStartArray("files");
        foreach (var file in new[] { plan, job }.OfType<string>())
        {
            json.WriteStringValue(file);
        }

        json.WriteEndArray();

        void Pair(string name, double x, double y)
        {
            json.WriteStartObject(name);
            json.WriteNumber("x", x);
            json.WriteNumber("y", y);
            json.WriteEndObject();
        }
    }

    public override void WriteText(Page page)
    {
        var count = planned.Plan.Points.Count();
        page.Heading(Sentence(count, planned.Prediction));
        if (planned.TwoLess is { } less)
        {
            page.Line(less.BoundMm < Alike * planned.Prediction.BoundMm
                ? $"With {ReportNumber.Count(count - 2, "point")}: as well, as far as {planned.Prediction.Parts} drawn parts can tell."
                : Sentence(count - 2, less));
        }

        page.Line();
        page.Table(
            ["point", "feature", "x", "y", "normal x", "normal y", "reason"],
            planned.Plan.Features.SelectMany(f => f.Lists.SelectMany(l => l).Select(p => (IReadOnlyList<string>)
            [
                p.Label, f.Name, Text(p.Place.X), Text(p.Place.Y), Text(p.Normal.X), Text(p.Normal.Y), PlannedJob.NameOf(p.Reason),
            ])));
        page.Line();
        foreach (var note in Notes())
        {
            page.Line($"Note: {note}");
        }

        page.Line("Predicted for parts that deviate as much as their limits allow, by the uncertainty that the job states. Another part "
            + "gives another bound: the match states it.");
        page.Line(plan is null
            ? $"Nothing was written. Add --out DIR to write {PlannedJob.PlanFile} and a job with these points."
            : $"Wrote {plan} and {job}. Next: measure these points, or let the machine: errormatch job probe {job} --out DIR");
    }

    private IEnumerable<string> Notes() => planned.IsStylusAssumed
        ? planned.Plan.Notes.Prepend(string.Create(
            CultureInfo.InvariantCulture,
            $"Nobody stated the ball of the probe: all points can be reached with {planned.Plan.StylusDiameterMm:0.###} mm. Give "
                + $"--stylus-diameter for another one."))
        : planned.Plan.Notes;

    private string Sentence(int count, PlanPrediction prediction)
    {
        var points = ReportNumber.Count(count, "point");
        var bound = prediction switch
        {
            { Parts: 0 } => "no part could be matched that was tried: see errormatch job check",
            { BoundMm: { } mm } => string.Create(
                CultureInfo.InvariantCulture, $"the boundary will be known within ±{mm:0.0000} mm everywhere (95 %)"),
            _ => "of some places nothing will be known: state the form error (\"formMm\") of lines with two points, or touch them more "
                + "often",
        };
        var pair = planned.Job.Features.Any(f => f.GapMm > 0) && prediction.Assembles is { } chance
            ? string.Create(CultureInfo.InvariantCulture, $"; the pair goes together with {Math.Floor(100 * chance):0} %")
            : "";
        var parts = prediction.Parts is > 0 and < PlanPrediction.Draws
            ? $" Only {ReportNumber.Count(prediction.Parts, "part")} of {PlanPrediction.Draws} drawn ones could be matched: see errormatch "
                + "job check."
            : "";
        return $"With {points}: {bound}{pair}.{parts}";
    }

    private static string Text(double value) => (Math.Round(value, 4) + 0.0).ToString("0.0000", CultureInfo.InvariantCulture);

    private static void Write(Utf8JsonWriter json, string name, PlanPrediction? prediction)
    {
        if (prediction is null)
        {
            json.WriteNull(name);
            return;
        }

        json.WriteStartObject(name);
        Number("bound95Mm", prediction.BoundMm);
        Number("assembles", prediction.Assembles);
        json.WriteNumber("parts", prediction.Parts);
        json.WriteEndObject();

        void Number(string key, double? value)
        {
            if (value is { } number)
            {
                json.WriteNumber(key, number);
            }
            else
            {
                json.WriteNull(key);
            }
        }
    }
}
