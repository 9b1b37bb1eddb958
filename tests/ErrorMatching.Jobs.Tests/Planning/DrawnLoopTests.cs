using ErrorMatching.Geometry;
using ErrorMatching.Mating;
using ErrorMatching.Nc;
using ErrorMatching.Testing;

namespace ErrorMatching.Jobs.Tests;

/// <summary>The whole way of a new user: a drawing, a program, a plan, a probe, a match, and what the program then cuts.</summary>
public sealed class DrawnLoopTests
{
    private const double Ball = 3;
    private const double ToolRadius = 4;

    private static CancellationToken Token => TestContext.Current.CancellationToken;

    [Fact]
    public void From_a_drawing_and_a_program_to_a_proved_counterpart_without_a_coordinate_typed()
    {
        using var folder = new TemporaryFolder();
        foreach (var file in new[] { "outline.dxf", "counterpart.nc" })
        {
            File.Copy(Repository.PathTo("samples", "dovetail", file), folder[file]);
        }

        var drawn = OutlineJob.Make(
            new(folder["job.json"], folder["outline.dxf"], folder["counterpart.nc"], "fanuc") { Layer = "OUTLINE" }, Token).Result!;
        File.WriteAllBytes(folder["job.json"], drawn.Job.ToArray());
        File.WriteAllBytes(folder["theoretical.csv"], drawn.Theoretical.ToArray());

        // What no drawing says: the gauge.
        File.WriteAllText(
            folder["job.json"],
            File.ReadAllText(folder["job.json"]).Replace(
                "\"uncertaintyMm\": 0.005", "\"uncertaintyMm\": 0.002, \"stylusDiameterMm\": 3", StringComparison.Ordinal));
        Directory.CreateDirectory(folder["plan"]);
        var planned = PlannedJob.Make(folder["job.json"], folder["plan"], null, null, Token).Result!;
        File.WriteAllBytes(folder["plan/plan.csv"], planned.Table.ToArray());
        File.WriteAllBytes(folder["plan/job-planned.json"], planned.Document.ToArray());
        var probed = ProbedJob.Make(
            folder["plan/job-planned.json"], new() { TouchZ = -5, ClearanceZ = 25, ToolNumber = 9 }, Token).Result!;

        var material = DovetailGroove.Polygon();
        var part = new VirtualPart(material, Ball);
        part.Run(PathOf(probed.Program.Bytes), 1);
        Assert.Empty(part.Collisions);
        File.WriteAllText(folder["probe.log"], part.Log(probed.Program.Moves.Plan, 0.001));
        var run = MatingRun.Run(new JobFiles(folder["plan/job-planned.json"]), new() { Part = new(folder["probe.log"]) }, Token);
        Assert.True(run.IsUsable, run.Refusal?.ToString());
        var report = run.Result.Report;
        Assert.True(report.Proof.Holds);

        // Contacts are on the part's true boundary, and the new program cuts the counterpart there.
        var boundary = new VirtualPart(material, 0);
        var (before, after) = (PathOf(File.ReadAllBytes(folder["counterpart.nc"])), PathOf(run.Result.Program));
        var compensated = report.Features.Where(f => f.Decision == Decision.Compensated).Select(f => f.Name).ToHashSet();
        Assert.NotEmpty(compensated);
        foreach (var point in report.KeyPoints)
        {
            Assert.InRange(Math.Abs(boundary.Room(point.Actual)), 0, 0.004);
            if (compensated.Contains(point.Feature))
            {
                Assert.InRange(Distance(after, point.Actual) - ToolRadius, -0.006, 0.006);
            }
        }

        Assert.Contains(report.KeyPoints, p => Math.Abs(Distance(before, p.Actual) - ToolRadius) > 0.05);
    }

    private static NcPath PathOf(ReadOnlyMemory<byte> program) =>
        NcInterpreter.Run(NcProgram.Read(program), NcDialects.FanucMill);

    private static double Distance(NcPath path, Point2 place) => path.Motions.Where(m => m is { IsCut: true, MovesInPlane: true }).Min(
        m => m.IsArc ? m.Arc.DistanceTo(place) : m.Segment.DistanceTo(place));
}
