using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;
using ErrorMatching.Testing;

namespace ErrorMatching.Freeform.Tests;

/// <summary>Rapid moves of cutting programs against surface and stock: the margin of the clearance, and a referee that reads the program
/// back and measures its rapid moves against places of the surface.</summary>
public sealed class TravelHeightTests
{
    // Before finishing lies what semi-finishing leaves, before semi-finishing what roughing leaves: the stock, and as much again where its
    // ball did not fit. Before roughing all above one radius was removed. The clearance counts from what the stage itself leaves.
    [Theory]
    [InlineData(CuttingStage.Finishing, 2 * 0.2)]
    [InlineData(CuttingStage.SemiFinishing, (2 * 0.35) - 0.2)]
    [InlineData(CuttingStage.Roughing, 3 - 0.35)]
    public void Exactly_enough_clearance_passes_and_an_increment_less_is_refused(CuttingStage stage, double least)
    {
        foreach (var (dialect, increment) in new[] { (NcDialects.LinuxCnc, 0.0001), (NcDialects.FanucMill, 0.001) })
        {
            var path = Plan(Shapes.Plane(10, 4, 1.23456), Job(least), stage, dialect).Path!;

            // The plane is bounded exactly. Rounding takes the height up.
            var lowest = 1.23456 + 3 + least + (stage == CuttingStage.Finishing ? 0 : stage == CuttingStage.SemiFinishing ? 0.2 : 0.35);
            Assert.InRange(path.TravelCenterZ, lowest - 1e-9, lowest + increment + 1e-9);

            Assert.Equal("clearance-too-low", Plan(Shapes.Plane(10, 4), Job(least - increment), stage, dialect).Refusal!.Code);
        }
    }

    [Theory]
    [InlineData(
        CuttingStage.Finishing,
        "toolpath.clearanceMm is 0.1 mm. Up to 0.4 mm of material lie over the surface before this stage: 0.2 mm of stock "
            + "(stockMm.semiFinishing), and as much again where the ball of that stage did not fit. Over the highest place, ",
        "Z1, the ball would travel 0.3 mm too low. Write at least 0.4.")]
    [InlineData(
        CuttingStage.SemiFinishing,
        "toolpath.clearanceMm is 0.1 mm. Up to 0.7 mm of material lie over the surface before this stage: 0.35 mm of stock "
            + "(stockMm.roughing), and as much again",
        "the ball would travel 0.4 mm too low. Write at least 0.5 over the 0.2 mm that this stage leaves.")]
    [InlineData(
        CuttingStage.Roughing,
        "toolpath.clearanceMm is 0.1 mm. Up to 3 mm of material lie over the surface before this stage: one radius of the ball of 6 mm, "
            + "above which all is removed before roughing.",
        "the ball would travel 2.55 mm too low. Write at least 2.65 over the 0.35 mm that this stage leaves.")]
    public void The_refusal_says_which_height_where_how_much_is_missing_and_what_to_write(
        CuttingStage stage, string begins, string ends)
    {
        var refusal = Plan(Shapes.Plane(10, 4, 1), Job(0.1), stage, NcDialects.LinuxCnc).Refusal!;
        Assert.StartsWith(begins, refusal.Message, StringComparison.Ordinal);
        Assert.EndsWith(ends, refusal.Message, StringComparison.Ordinal);
        Assert.Equal("$.toolpath.clearanceMm", refusal.Place.Path);
    }

    [Fact]
    public void Ridges_count_where_no_stock_was_left_and_so_does_what_the_surface_was_moved_by()
    {
        const string NoStock = "\"roughing\": 0, \"semiFinishing\": 0";
        Assert.True(Plan(Shapes.Plane(10, 4), Job(0.1, NoStock, 0.1), CuttingStage.Finishing, NcDialects.LinuxCnc).IsUsable);
        Assert.Contains(
            "ridges of 0.1 mm (toolpath.scallopMm)",
            Plan(Shapes.Plane(10, 4), Job(0.0999, NoStock, 0.1), CuttingStage.Finishing, NcDialects.LinuxCnc).Refusal!.Message,
            StringComparison.Ordinal);

        Assert.True(ToolPathPlanner.Plan(Shapes.Plane(10, 4), Job(0.45), CuttingStage.Finishing, NcDialects.LinuxCnc, 0.05).IsUsable);
        Assert.Contains(
            " 0.0501 mm ",
            ToolPathPlanner.Plan(Shapes.Plane(10, 4), Job(0.45), CuttingStage.Finishing, NcDialects.LinuxCnc, 0.0501).Refusal!.Message,
            StringComparison.Ordinal);
    }

    // A ridge of 2 mm, 0.06 mm wide, between all samples that anybody would take.
    [Fact]
    public void A_ridge_between_all_samples_is_seen()
    {
        var surface = Surfaces.Profile(
            KnotVector.Clamped(1, [0, 0.31237, 0.31277, 0.31317, 1]), x => Math.Abs(x - (0.31277 * Surfaces.Width)) < 0.001 ? 2 : 0);
        var plan = MeasuringPlanner.Plan(surface, Surfaces.Measuring(2, 5), 0.2);

        Assert.InRange(plan.ClearanceZ, 2 + 0.2 + 10 + 3, 2 + 0.2 + 10 + 3 + 0.01);
    }

    [Theory]
    [InlineData(1, 6, 0.4, 0.2)]
    [InlineData(3, 6, 2, 0.1)]
    [InlineData(4, 6, 0.4, 0.2)]
    [InlineData(4, 12, 1, 0.5)]
    [InlineData(5, 2, 0.4, 0.3)]
    [InlineData(6, 1, 0.9, 0.8)]
    public void No_rapid_move_of_the_program_meets_surface_and_stock(int shape, double ball, double roughing, double semi)
    {
        var surface = shape switch
        {
            4 => Shapes.Cylinder(9, 6, hollow: true),

            // Walls of 76 degrees on both sides of a round bottom.
            5 => Shapes.Graph((x, _) => 0.2 * (x - 10) * (x - 10), 20, 4),
            6 => Shapes.Graph((x, y) => 0.1 * (x - 5) * (y - 3) * (y - 3), 10, 6),
            _ => Shapes.Design(shape),
        };
        foreach (var (stage, before) in new[]
        {
            (CuttingStage.Finishing, 2 * semi),
            (CuttingStage.SemiFinishing, 2 * roughing),
            (CuttingStage.Roughing, Math.Max(roughing, ball / 2)),
        })
        {
            foreach (var clearance in new[] { before, 10 }.Take(Depth.Of(1, 2)))
            {
                var job = Job(clearance, FormattableString.Invariant($"\"roughing\": {roughing}, \"semiFinishing\": {semi}"), 0.09, ball);
                var planned = Plan(surface, job, stage, NcDialects.LinuxCnc);
                Assert.True(planned.IsUsable, planned.Refusal?.Message);
                Referee(surface, FinishingProgram.Write(planned.Path, job, NcDialects.LinuxCnc, stage), (ball / 2) + before);
            }
        }
    }

    // Each rapid move is a line; the nearest of many places of the surface must be outside of the ball that runs along it.
    private static void Referee(PartSurface surface, byte[] program, double nearest)
    {
        const int N = 30;
        Point3[] places = [
            .. from i in Enumerable.Range(0, N + 1)
               from j in Enumerable.Range(0, N + 1)
               select surface.Spline.PointAt((double)i / N, (double)j / N)];
        var run = NcInterpreter.Run(NcProgram.Read(program, NcSyntax.LinuxCnc), NcDialects.LinuxCnc);
        Assert.Empty(run.Problems);
        var rapids = run.Motions.Where(m => m.Kind == MotionKind.Rapid && m.UnknownStart == AxisSet.None).ToArray();
        Assert.True(rapids.Length >= 3);
        foreach (var rapid in rapids)
        {
            var way = rapid.End - rapid.Start;
            var square = Math.Max(way.Dot(way), 1e-12);
            foreach (var place in places)
            {
                var off = place - rapid.Start;
                var distance = (off - (way * Math.Clamp(off.Dot(way) / square, 0, 1))).Length;
                Assert.True(distance >= nearest - 1e-9, $"{distance} mm from {place} on the way from {rapid.Start} to {rapid.End}");
            }
        }
    }

    private static ToolPathResult Plan(PartSurface surface, FreeformJob job, CuttingStage stage, NcDialect dialect) =>
        ToolPathPlanner.Plan(surface, job, stage, dialect);

    private static FreeformJob Job(
        double clearance, string stock = "\"roughing\": 0.35, \"semiFinishing\": 0.2", double scallop = 0.02, double ball = 6) =>
        FreeformJob.Parse(
            Encoding.UTF8.GetBytes(FormattableString.Invariant(
                $$"""
                { "kind": "freeform", "name": "Heights", "surface": "surface.igs", "stockMm": { {{stock}} },
                  "tool": { "kind": "ball", "diameterMm": {{ball}} }, "spindleRpm": 10000, "feedMmPerMin": 1200,
                  "measuring": { "curves": 7, "pointsPerCurve": 10, "stylusDiameterMm": 6, "dialect": "siemens-840d" },
                  "toolpath": { "dialect": "linuxcnc", "clearanceMm": {{clearance}}, "scallopMm": {{scallop}}, "chordMm": 0.01,
                    "tool": { "number": 1, "lengthOffset": 1 } } }
                """)),
            "job.json");
}
