using System.Globalization;
using System.Text;
using ErrorMatching.Mating;
using ErrorMatching.Nc;
using ErrorMatching.Testing;

namespace ErrorMatching.Jobs.Tests;

/// <summary>Where a plan touches the part, and whether what it promises is what comes out.</summary>
public sealed class PlannedJobTests
{
    private const double Ball = 3;

    private static CancellationToken Token => TestContext.Current.CancellationToken;

    [Theory]
    [InlineData("complex-mating")]
    [InlineData("curve-mating")]
    [InlineData("circle-mating")]
    [InlineData("slot-mating")]
    [InlineData("dovetail")]
    [InlineData("klartext-mating")]
    public void The_planned_job_of_a_sample_is_a_job_whose_points_lie_on_the_outline_as_designed(string sample)
    {
        using var folder = Copied(sample);
        Directory.CreateDirectory(folder["plan"]);
        var planned = Planned(folder, null);
        Write(folder, planned);
        var files = new JobFiles(folder["plan/job-planned.json"]);
        var theoretical = files.Theoretical();
        Assert.Equal(planned.Plan.Points.Select(p => p.Label), files.Job.KeyPoints);
        var designed = new JobFiles(folder["job.json"]).Theoretical();
        foreach (var feature in planned.Plan.Features)
        {
            foreach (var point in feature.Lists.SelectMany(l => l))
            {
                Assert.Equal(1, point.Normal.Length, 1e-9);
                Assert.Equal(point.Place.X, theoretical[point.Label].Position.X, 1e-6);

                // Where a point keeps its name, it keeps its place.
                if (designed.TryGet(point.Label, out var own) && point.Reason != TouchReason.Form)
                {
                    Assert.Equal((own.Position.X, own.Position.Y), (point.Place.X, point.Place.Y));
                }
            }
        }
    }

    [Fact]
    public void The_longest_line_tells_the_form_of_all_and_curves_get_fewer_points_than_they_have()
    {
        using var folder = Copied("dovetail");
        var planned = Planned(folder, null);
        var counts = planned.Plan.Features.ToDictionary(f => f.Name, f => f.Lists.Sum(l => l.Count), StringComparer.Ordinal);
        Assert.All(counts.Where(c => c.Key[0] is 'L' or 'F' or 'T'), c => Assert.InRange(c.Value, 2, 4));
        Assert.InRange(counts["L1"], 3, 4);
        Assert.InRange(counts["C1"], 4, 7);

        // Between its key points a line is where it is designed, with their normal.
        var longest = planned.Plan.Features.Single(f => f.Name == "L1").Lists[0];
        Assert.All(longest, p => Assert.Equal((-30, 0, -1), (p.Place.Y, p.Normal.X, p.Normal.Y)));
        Assert.Equal([TouchReason.End, TouchReason.Form, TouchReason.End], [.. longest.Select(p => p.Reason)]);
        var middle = (longest[0].Place.X + longest[^1].Place.X) / 2;
        Assert.Equal(middle, longest[1].Place.X, 1.0);
    }

    // Beyond its key points a line is an extension: the variance u^2 (1 / n + d^2 / S) of a line's place at a distance d from the mean of
    // n points with the sum of squares S is least if the third point is beside the end that is extended.
    [Fact]
    public void Where_a_line_reaches_beyond_its_key_points_the_next_point_is_beside_that_end()
    {
        using var folder = Copied("dovetail");
        var (from, to) = (-8.6065, 2.0);

        // T2 ends at the cam, X10: with its last key point at X2, there are 8 mm to extend.
        var table = File.ReadAllText(folder["theoretical.csv"]);
        File.WriteAllText(folder["theoretical.csv"], table.Replace("\n13,8.0414,", "\n13,2.0,", StringComparison.Ordinal));
        var planned = Planned(folder, 0.007);
        var top = planned.Plan.Features.Single(f => f.Name == "T2").Lists[0];
        Assert.True(top.Count > 2, "T2 got no third point");
        var best = Enumerable.Range(1, (int)(to - from) - 1).Select(k => from + k).MinBy(third =>
        {
            double[] x = [from, third, to];
            var mean = x.Average();
            return (1.0 / 3) + ((10 - mean) * (10 - mean) / x.Sum(v => (v - mean) * (v - mean)));
        });
        Assert.Contains(top, p => p.Reason == TouchReason.Form && Math.Abs(p.Place.X - best) < 1.5);
    }

    [Fact]
    public void A_tighter_bound_takes_more_points_and_two_less_tell_less()
    {
        using var folder = Copied("dovetail");
        var (loose, tight) = (Planned(folder, 0.02), Planned(folder, 0.0075));
        Assert.True(loose.Plan.Points.Count() < tight.Plan.Points.Count());
        Assert.True(loose.Prediction.BoundMm > tight.Prediction.BoundMm);
        Assert.Equal(tight.Plan.Points.Count() - 2, tight.Plan.TwoLess!.Points.Count());
        Assert.True(tight.TwoLess!.BoundMm > 0.98 * tight.Prediction.BoundMm);
    }

    // The promise is checked on parts that the plan does not know: their true boundary is, so is what the match leaves of it.
    [Fact]
    public void The_match_of_a_probed_part_is_as_well_known_as_the_plan_said()
    {
        using var folder = Copied("dovetail");
        var planned = Planned(folder, null);
        Write(folder, planned);
        var job = File.ReadAllText(folder["plan/job-planned.json"]);
        File.WriteAllText(
            folder["plan/job-planned.json"],
            job.Replace("\"uncertaintyMm\": 0.002", "\"uncertaintyMm\": 0.002, \"stylusDiameterMm\": 3", StringComparison.Ordinal));
        var probed = ProbedJob.Make(
            folder["plan/job-planned.json"], new() { TouchZ = -5, ClearanceZ = 25, ToolNumber = 9 }, Token).Result!;
        var path = NcInterpreter.Run(NcProgram.Read(probed.Program.Bytes, probed.Program.Dialect.Syntax), probed.Program.Dialect);
        var part = new VirtualPart(DovetailGroove.Polygon(), Ball);
        part.Run(path, 1);
        Assert.Empty(part.Collisions);
        var bounds = new List<double>();
        for (var seed = 0; seed < 5; seed++)
        {
            File.WriteAllText(folder["probe.log"], part.Log(probed.Program.Moves.Plan, 0.002, seed));
            var run = MatingRun.Run(new JobFiles(folder["plan/job-planned.json"]), new() { Part = new(folder["probe.log"]) }, Token);
            Assert.True(run.IsUsable, run.Refusal?.ToString());
            var report = run.Result.Report;
            Assert.All(report.KeyPoints, p => Assert.Equal(DovetailGroove.DisplacedMm[p.Feature], DovetailGroove.OffMm(p), 5 * 0.002));
            bounds.Add(report.Features.Max(f => f.WorstBetween!.Interval95Mm));
        }

        // Within a half of each other: other parts, and other noise.
        Assert.InRange(bounds.Order().ElementAt(2), planned.Prediction.BoundMm!.Value / 1.5, planned.Prediction.BoundMm.Value * 1.5);
        Assert.InRange(planned.Prediction.Assembles!.Value, 0, 1);
    }

    [Fact]
    public void Paths_comments_and_comparisons_of_the_job_go_along()
    {
        using var folder = Copied("complex-mating");
        var planned = Planned(folder, null);
        var text = Encoding.UTF8.GetString(planned.Document.Span);
        Assert.Contains("\"program\": \"../counterpart.nc\"", text, StringComparison.Ordinal);
        Assert.Contains("\"theoretical\": \"plan.csv\"", text, StringComparison.Ordinal);
        Assert.Contains("// Probing 0.6 um", text, StringComparison.Ordinal);
        var lines = Encoding.UTF8.GetString(planned.Table.Span).Split('\n');
        Assert.Equal("point,feature,x,y,nx,ny,reason", lines[0]);
        Assert.Equal(planned.Plan.Points.Count() + 2, lines.Length);
        var first = lines[1].Split(',');
        Assert.Equal(["1", "L1", "-31.950000", "76.008000", "end"], [.. first[..4], first[6]]);

        // The key's tool passes L1 on its left, at X-35: there the part will be, and it is touched from the right.
        Assert.Equal(1, double.Parse(first[4], CultureInfo.InvariantCulture), 0.01);
    }

    [Fact]
    public void A_feature_beside_the_plane_and_points_out_of_reach_are_refused()
    {
        using var folder = Copied("dovetail");
        Assert.All([60.0, 400], ball => Assert.Equal(
            "out-of-reach", PlannedJob.Make(folder["job.json"], folder["plan"], ball, null, Token).Refusal!.Code));
        File.WriteAllText(
            folder["job.json"],
            File.ReadAllText(folder["job.json"]).Replace(
                "\"name\": \"T2\"", "\"name\": \"T2\", \"plane\": \"ZX\"", StringComparison.Ordinal));
        Assert.Equal("plan-plane", PlannedJob.Make(folder["job.json"], folder["plan"], 3, null, Token).Refusal!.Code);
    }

    private static PlannedJob Planned(TemporaryFolder folder, double? within)
    {
        var outcome = PlannedJob.Make(folder["job.json"], folder["plan"], Ball, within, Token);
        Assert.True(outcome.IsUsable, outcome.Refusal?.ToString());
        return outcome.Result!;
    }

    private static void Write(TemporaryFolder folder, PlannedJob planned)
    {
        Directory.CreateDirectory(folder["plan"]);
        File.WriteAllBytes(folder["plan/plan.csv"], planned.Table.ToArray());
        File.WriteAllBytes(folder["plan/job-planned.json"], planned.Document.ToArray());
    }

    private static TemporaryFolder Copied(string sample)
    {
        var folder = new TemporaryFolder();
        foreach (var file in Directory.GetFiles(Repository.PathTo("samples", sample)))
        {
            File.Copy(file, folder[Path.GetFileName(file)]);
        }

        return folder;
    }
}
