using System.Globalization;
using System.Text;
using System.Text.Json.Nodes;
using ErrorMatching.Geometry;
using ErrorMatching.Testing;

namespace ErrorMatching.Jobs.Tests;

/// <summary>How many equally spaced points tell as much as those of a plan: on parts that the plan does not know, drawn here.</summary>
public sealed class PlanComparisonTests(ITestOutputHelper output)
{
    private const double Ball = 3, UncertaintyMm = 0.002, HalfWidthMm = 0.05;

    // From half as many points to twice as many, and where along the outline the first one lies.
    private static readonly double[] Spacings = [1.6, 1.3, 1.1, 1, 0.9, 0.8, 0.7, 0.6, 0.5];
    private static readonly double[] Phases = [0.1, 0.35, 0.6, 0.85];

    private static CancellationToken Token => TestContext.Current.CancellationToken;

    [Fact]
    public void A_plan_needs_fewer_points_than_an_equal_spacing()
    {
        var ratios = new List<double>();
        for (var seed = 1; seed <= Depth.Of(1, 10); seed++)
        {
            using var folder = new TemporaryFolder();
            var outline = Outline(folder, seed);
            Directory.CreateDirectory(folder["plan"]);
            var planned = PlannedJob.Make(folder["job.json"], folder["plan"], Ball, null, Token).Result!;
            File.WriteAllBytes(folder["plan/plan.csv"], planned.Table.ToArray());
            File.WriteAllBytes(folder["plan/job-planned.json"], planned.Document.ToArray());
            var bound = Bound(folder["plan/job-planned.json"], outline, seed);
            var count = planned.Plan.Points.Count();
            var total = outline.Sum(l => l.Length);
            var needed = double.NaN;
            foreach (var share in Spacings.Take(Depth.Of(4, Spacings.Length)))
            {
                var of = Phases.Take(Depth.Of(2, Phases.Length))
                    .Select(p => Equal(folder, outline, share * total / count, p, seed)).ToArray();
                var (points, bounds) = (of.Average(e => e.Count), of.Select(e => e.Bound).Order().ElementAt(of.Length / 2));
                output.WriteLine(string.Create(
                    CultureInfo.InvariantCulture, $"{seed}: {points:0.0} equally spaced points tell ±{bounds:0.0000} mm"));
                if (bounds <= bound)
                {
                    needed = points;
                    break;
                }
            }

            needed = double.IsNaN(needed) ? 2 * count : needed;
            ratios.Add(count / needed);

            // What a careful person does: as many on each line, its ends included.
            var each = Enumerable.Range(2, Depth.Of(1, 5)).Select(n => (N: n, Bound: OnEach(folder, outline, n, seed)))
                .Select(e => string.Create(CultureInfo.InvariantCulture, $"{e.N * outline.Length}: ±{e.Bound:0.0000}"));
            output.WriteLine($"{seed}: as many on each line, points and bound {string.Join(", ", each)}");
            output.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"{seed}: {outline.Length} lines, {count} planned points tell ±{bound:0.0000} mm (promised "
                    + $"±{planned.Prediction.BoundMm:0.0000}), as {needed:0.0} equally spaced ones do: {count / needed:0.00}"));
        }

        ratios.Sort();
        output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"median {ratios[ratios.Count / 2]:0.00}"));
        Assert.InRange(ratios[ratios.Count / 2], 0, 1);
    }

    private sealed record Line(Point2 Start, Point2 End)
    {
        public double Length => Start.DistanceTo(End);

        public Vector2 Along => (End - Start).Normalize();
    }

    // Lines that turn left and right, cut under cutter compensation, so that the path is the boundary. Key points keep off the corners.
    private static Line[] Outline(TemporaryFolder folder, int seed)
    {
        var random = new Random(seed);
        var (at, heading) = (new Point2(0, 0), 0.0);
        var lines = new List<Line>();
        for (var k = random.Next(5, 10); k > 0; k--)
        {
            var end = at + (new Vector2(Math.Cos(heading), Math.Sin(heading)) * (12 + (40 * random.NextDouble())));
            lines.Add(new(at, end));
            (at, heading) = (end, heading >= 0 ? -(20 + (30 * random.NextDouble())) * Math.PI / 180 : 0.6 * random.NextDouble());
        }

        var program = new StringBuilder("%\nN10 G21 G17 G90 G54\nN20 G0 X-30 Y-10 Z5\nN30 G1 Z-5 F200\nN40 G41 D1 X-10 Y0\n");
        Number(program.Append("N50 G1 X"), lines[0].Start.X - 5);
        Number(program.Append(" Y"), lines[0].Start.Y);
        program.Append('\n');
        for (var k = 0; k < lines.Count; k++)
        {
            Number(program.Append(CultureInfo.InvariantCulture, $"N{100 + (10 * k)} X"), lines[k].End.X);
            Number(program.Append(" Y"), lines[k].End.Y);
            program.Append('\n');
        }

        program.Append("N900 G40 G91 X20 Y20\nN910 G90 G0 Z50\nN920 M30\n%\n");
        File.WriteAllText(folder["counterpart.nc"], program.ToString());
        Write(folder[""], [.. lines.Select(l => OnLine(l, 3))], [.. lines], "job.json");
        return [.. lines];
    }

    private static void Number(StringBuilder text, double value) => text.Append(CultureInfo.InvariantCulture, $"{value:0.0000}");

    // A job whose lines are touched at given lengths.
    private static void Write(string folder, double[][] along, Line[] lines, string name)
    {
        var (features, table, label) = (new JsonArray(), new StringBuilder("point,x_mm,y_mm\n"), 0);
        for (var k = 0; k < lines.Length; k++)
        {
            var labels = new JsonArray();
            foreach (var s in along[k])
            {
                var place = lines[k].Start + (lines[k].Along * s);
                labels.Add($"P{++label}");
                table.Append(CultureInfo.InvariantCulture, $"P{label},{place.X:0.000000},{place.Y:0.000000}\n");
            }

            features.Add(new JsonObject
            {
                ["name"] = $"L{k + 1}",
                ["kind"] = "line",
                ["points"] = labels,
                ["blocks"] = new JsonArray($"N{100 + (10 * k)}"),
                ["toleranceMm"] = new JsonArray(-HalfWidthMm, HalfWidthMm),
            });
        }

        File.WriteAllText(Path.Combine(folder, Path.ChangeExtension(name, "csv")), table.ToString());
        File.WriteAllText(Path.Combine(folder, name), new JsonObject
        {
            ["kind"] = "mating",
            ["name"] = "Comparison",
            ["workOrder"] = "W",
            ["part"] = new JsonObject { ["theoretical"] = Path.ChangeExtension(name, "csv"), ["measured"] = "part.csv" },
            ["gauge"] = new JsonObject { ["format"] = "points", ["uncertaintyMm"] = UncertaintyMm },
            ["alignment"] = new JsonObject { ["kind"] = "none" },
            ["features"] = features,
            ["counterpart"] = new JsonObject
            {
                ["program"] = "counterpart.nc",
                ["dialect"] = "fanuc",
                ["toolDiameterMm"] = 6,
                ["frame"] = new JsonObject { ["mirror"] = "none", ["rotateDeg"] = 0, ["translateMm"] = new JsonArray(0, 0) },
            },
            ["compensation"] = new JsonObject
            {
                ["from"] = "part",
                ["gain"] = 1,
                ["amount"] = "whole",
                ["along"] = "normal",
                ["limitMm"] = 1,
            },
        }.ToJsonString());
    }

    // Points at one distance from each other along the whole outline; each line needs at least two.
    private static (int Count, double Bound) Equal(TemporaryFolder folder, Line[] outline, double spacing, double phase, int seed)
    {
        var (passed, along) = (0.0, new List<double[]>());
        foreach (var line in outline)
        {
            var places = new List<double>();
            for (var at = ((Math.Ceiling((passed / spacing) - phase) + phase) * spacing) - passed; at <= line.Length; at += spacing)
            {
                places.Add(Math.Clamp(at, 4, line.Length - 4));
            }

            places = [.. places.Distinct()];
            along.Add(places.Count > 1 ? [.. places] : [4, line.Length - 4]);
            passed += line.Length;
        }

        Write(folder[""], [.. along], outline, "equal.json");
        return (along.Sum(a => a.Length), Bound(folder["equal.json"], outline, seed));
    }

    // Equally spaced between the ends of what can be touched.
    private static double[] OnLine(Line line, int count) =>
        [.. Enumerable.Range(0, count).Select(i => 4 + ((line.Length - 8) * i / (count - 1)))];

    private static double OnEach(TemporaryFolder folder, Line[] outline, int count, int seed)
    {
        Write(
            folder[""],
            [.. outline.Select(l => OnLine(l, count))],
            outline,
            "each.json");
        return Bound(folder["each.json"], outline, seed);
    }

    // The median over parts of what the report says is not known of the boundary.
    private static double Bound(string job, Line[] outline, int seed)
    {
        var files = new JobFiles(job);
        var theoretical = files.Theoretical();
        var bounds = new List<double>();
        for (var part = 0; part < Depth.Of(5, 20); part++)
        {
            var random = new Random((1000 * seed) + part);
            var shapes = outline.Select(_ => (
                Shift: HalfWidthMm * Normal(random), Tilt: HalfWidthMm / 2 * Normal(random),
                Bow: UncertaintyMm * Normal(random), Phase: 2 * Math.PI * random.NextDouble())).ToArray();
            var text = new StringBuilder("point,x_mm,y_mm\n");
            foreach (var (feature, f) in files.Job.Features.Select((f, i) => (f, i)))
            {
                foreach (var label in feature.Points)
                {
                    var place = theoretical[label].Position is var p ? new Point2(p.X, p.Y) : default;
                    var s = (place - outline[f].Start).Dot(outline[f].Along) / outline[f].Length;
                    var off = shapes[f].Shift + (shapes[f].Tilt * ((2 * s) - 1))
                        + (shapes[f].Bow * Math.Sin((2 * Math.PI * s) + shapes[f].Phase) / Math.Sqrt(2)) + (UncertaintyMm * Normal(random));
                    var at = place + (outline[f].Along.Left * off);
                    text.Append(CultureInfo.InvariantCulture, $"{label},{at.X:0.000000},{at.Y:0.000000}\n");
                }
            }

            var measured = Path.Combine(Path.GetDirectoryName(job)!, "measured.csv");
            File.WriteAllText(measured, text.ToString());
            var report = MatingRun.Run(new JobFiles(job), new() { Part = new(measured) }, Token).Result!.Report;
            bounds.Add(report.Features.Max(f => f.WorstBetween is { IsKnown: true } w ? w.Interval95Mm : 1));
        }

        bounds.Sort();
        return bounds[bounds.Count / 2];
    }

    private static double Normal(Random random) =>
        Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
}
