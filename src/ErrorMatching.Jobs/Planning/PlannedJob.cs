using System.Globalization;
using System.Text;
using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>Where to touch the part of a mating job: <c>errormatch job plan</c>. The plan is the theoretical file of a job of its
/// own.</summary>
public sealed record PlannedJob
{
    /// <summary>Header of the table of points: as designed, in mm, with the unit normal out of the part's material.</summary>
    public const string Header = "point,feature,x,y,nx,ny,reason";

    /// <summary>Name of the file of the plan.</summary>
    public const string PlanFile = "plan.csv";

    /// <summary>Diameter of the ball that is assumed if nobody states one, mm: the largest in common use, which reaches least.</summary>
    public const double AssumedStylusMm = 6;

    // The normal of a point that only aligns is not known.
    private const string Datum = "datum";

    private PlannedJob()
    {
    }

    /// <summary>The job that was planned.</summary>
    public required MatingJob Job { get; init; }

    /// <summary>The plan.</summary>
    public required TouchPlan Plan { get; init; }

    /// <summary>True if nobody stated the diameter of the ball.</summary>
    public required bool IsStylusAssumed { get; init; }

    /// <summary>What the plan will tell.</summary>
    public PlanPrediction Prediction => Plan.Prediction!;

    /// <summary>What the plan with two points less will tell; null if each point is needed.</summary>
    public PlanPrediction? TwoLess => Plan.TwoLess?.Prediction;

    /// <summary>The table of points.</summary>
    public required ReadOnlyMemory<byte> Table { get; init; }

    /// <summary>The job with the points of the plan, which belongs beside the table.</summary>
    public required ReadOnlyMemory<byte> Document { get; init; }

    /// <summary>The files that were read.</summary>
    public required IReadOnlyList<string> Read { get; init; }

    /// <summary>The name of the planned job's file.</summary>
    /// <param name="job">The job's file.</param>
    public static string FileOf(string job) => Path.GetFileNameWithoutExtension(job) + "-planned.json";

    /// <summary>Plans the points of a job.</summary>
    /// <param name="file">The job.</param>
    /// <param name="folder">The folder that the planned job is for.</param>
    /// <param name="stylusDiameterMm">Diameter of the ball, mm; null for the job's.</param>
    /// <param name="withinMm">Half the 95 % interval of the error anywhere along the boundary that is wanted, mm; null for a fifth of what
    /// the limits of each feature allow.</param>
    /// <param name="cancellation">Cancels between steps.</param>
    /// <returns>The plan, or why there is none.</returns>
    /// <exception cref="InputException">A file cannot be opened or used.</exception>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public static Outcome<PlannedJob> Make(
        string file, string folder, double? stylusDiameterMm, double? withinMm, CancellationToken cancellation)
    {
        var bytes = InputFile.Open(file, p => JsonInput.Load(p));
        var files = new JobFiles(MatingJob.Parse(bytes, PathText.Of(file)));
        var job = files.Job;
        var theoretical = files.Theoretical();
        var program = files.Interpret(cancellation);
        var diameter = stylusDiameterMm ?? job.Gauge.StylusDiameterMm;
        var target = Path.Combine(folder, FileOf(file));
        var outcome = TouchPlanner.Choose(job, program.Path, theoretical, diameter ?? AssumedStylusMm, withinMm, Predicted);
        return outcome.Result is not { } plan
            ? Outcome.Refused<PlannedJob>(InputRefusals.Of(outcome.Refusals, job.File, program.File))
            : new PlannedJob
            {
                Job = job,
                Plan = plan,
                IsStylusAssumed = diameter is null,
                Table = TableOf(job, plan, theoretical),
                Document = DocumentOf(bytes, job, plan, target),
                Read = files.Opened,
            };

        PlanPrediction Predicted(TouchPlan planned, int parts)
        {
            cancellation.ThrowIfCancellationRequested();
            var nominal = MeasurementReader.Read(TableOf(job, planned, theoretical), PlanFile, MeasurementFormat.Points);
            return PlanPrediction.Predict(
                new(MatingJob.Parse(DocumentOf(bytes, job, planned, target), target), nominal, nominal, null, program.File, program.Bytes)
                {
                    OwnDialect = program.OwnDialect,
                    Library = program.Called.Find,
                },
                planned,
                parts);
        }
    }

    private static byte[] TableOf(MatingJob job, TouchPlan plan, MeasurementFile theoretical)
    {
        var text = new StringBuilder(Header).Append('\n');
        foreach (var feature in plan.Features)
        {
            foreach (var p in feature.Lists.SelectMany(l => l))
            {
                text.Append(
                    CultureInfo.InvariantCulture,
                    $"{Cell(p.Label)},{Cell(feature.Name)},{Mm(p.Place.X)},{Mm(p.Place.Y)},{Unit(p.Normal.X)},{Unit(p.Normal.Y)},"
                        + $"{NameOf(p.Reason)}\n");
            }
        }

        var planned = plan.Points.Select(p => p.Label).ToHashSet(StringComparer.Ordinal);
        foreach (var label in job.NeededPoints.Except(job.KeyPoints, StringComparer.Ordinal).Where(l => !planned.Contains(l)))
        {
            var at = theoretical[label].Position;
            text.Append(CultureInfo.InvariantCulture, $"{Cell(label)},,{Mm(at.X)},{Mm(at.Y)},,,{Datum}\n");
        }

        return Encoding.UTF8.GetBytes(text.ToString());
    }

    // What a table would take for more than one cell is quoted.
    private static string Cell(string text) =>
        text.AsSpan().ContainsAny(",\"\n") ? "\"" + text.Replace("\"", "\"\"", StringComparison.Ordinal) + "\"" : text;

    /// <summary>The word for a reason: end, form or kept.</summary>
    public static string NameOf(TouchReason reason) => reason switch
    {
        TouchReason.End => "end",
        TouchReason.Form => "form",
        _ => "kept",
    };

    private static string Mm(double value) => (Math.Round(value, 6) + 0.0).ToString("0.000000", CultureInfo.InvariantCulture);

    private static string Unit(double value) => (Math.Round(value, 9) + 0.0).ToString("0.000000000", CultureInfo.InvariantCulture);

    // The job with other points: all else stays, comments included.
    private static byte[] DocumentOf(ReadOnlyMemory<byte> bytes, MatingJob job, TouchPlan plan, string target)
    {
        var text = Encoding.UTF8.GetBytes(Encoding.UTF8.GetString(bytes.Span).TrimStart('\uFEFF').ReplaceLineEndings("\n"));
        var root = JsonInput.Read(text, job.File);
        var theoretical = root["part"]["theoretical"];
        var order = root["gauge"].Find("labels") is { Kind: JsonItemKind.List } labels
            ? new JsonEdit(labels.Bytes, JsonEdit.List(plan.Points.Select(p => p.Label)))
            : null;
        return JsonEdit.Apply(
            text,
            [
                .. MovedPaths.Of(job, root, target).Where(e => !e.At.Equals(theoretical.Bytes)),
                new(theoretical.Bytes, JsonEdit.Text(PlanFile)),
                .. (root.Find("verify")?.Items ?? []).Select(v => v.Find("points")).OfType<JsonItem>()
                    .Select(l => Compared(l, job, plan)).OfType<JsonEdit>(),
                .. root["features"].Items.Zip(plan.Features).Select(f => new JsonEdit(f.First["points"].Bytes, ListOf(f.Second.Lists))),
                .. new[] { order, root.Find("without") is { } without ? new JsonEdit(without.Bytes, "[]") : null }.OfType<JsonEdit>(),
            ]);
    }

    // What a comparison takes of a feature's points is what the plan has of them; all of its points if it has none.
    private static JsonEdit? Compared(JsonItem list, MatingJob job, TouchPlan plan)
    {
        string[] labels = [.. list.Items.SelectMany(i => LabelRange.Expand(i.Text))];
        var planned = plan.Points.Select(p => p.Label).ToHashSet(StringComparer.Ordinal);
        if (Array.TrueForAll(labels, planned.Contains))
        {
            return null;
        }

        var left = Array.FindAll(labels, planned.Contains);
        var feature = job.Features.Select((f, i) => (Feature: f, Index: i)).FirstOrDefault(f => f.Feature.Points.Contains(labels[0]));
        return new(list.Bytes, JsonEdit.List(
            left.Length > 0 ? left : plan.Features[feature.Index].Lists.SelectMany(l => l).Select(p => p.Label)));
    }

    private static string ListOf(IReadOnlyList<IReadOnlyList<PlannedPoint>> lists)
    {
        string[] each = [.. lists.Select(l => JsonEdit.List(l.Select(p => p.Label)))];
        return each.Length == 1 ? each[0] : "[" + string.Join(", ", each) + "]";
    }
}
