using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Freeform.Tests;

public sealed class ProbeAccessTests
{
    [Fact]
    public void A_hollow_tighter_than_the_ball_is_refused_by_the_names_of_its_points()
    {
        // z = (x - 37.5)²/4: the radius at the bottom is 2 mm, less than the ball's 3.
        var plan = MeasuringPlanner.Plan(Surfaces.Quadratic((x, _) => (x - 37.5) * (x - 37.5) / 4), Surfaces.Measuring(2, 5));
        var bottom = plan.Points.Where(p => p.I == 2).ToArray();
        Assert.All(
            bottom,
            p => Assert.Contains(
                plan.Refusals,
                r => r.Code == "untouchable-point"
                    && r.Message.StartsWith(FormattableString.Invariant($"point {p.Number} "), StringComparison.Ordinal)));
        Assert.Contains(plan.Refusals, r => r.Message.Contains("radius of 2 mm", StringComparison.Ordinal));
    }

    [Fact]
    public void A_hollow_wider_than_the_ball_is_touched()
    {
        // A parabola whose radius is 20 mm at the bottom and larger beside it.
        var plan = MeasuringPlanner.Plan(Surfaces.Quadratic((x, _) => (x - 37.5) * (x - 37.5) / 40), Surfaces.Measuring(3, 7), 0.2);
        Assert.Empty(plan.Refusals);
    }

    [Fact]
    public void A_surface_that_faces_down_is_refused()
    {
        var plan = MeasuringPlanner.Plan(Surfaces.Flat with { Outside = -1 }, Surfaces.Measuring(2, 2));
        Assert.Equal(4, plan.Refusals.Count);
        Assert.All(plan.Refusals, r => Assert.Contains("points down", r.Message, StringComparison.Ordinal));
    }

    [Fact]
    public void A_floor_beside_a_high_wall_is_touched_only_where_the_ball_has_room()
    {
        // A floor that goes over into a wall of 30 mm within 2 mm about x = 37.5.
        double[] breaks = [.. Enumerable.Range(0, 401).Select(i => i / 400.0)];
        var surface = Surfaces.Profile(KnotVector.Clamped(3, breaks), x => 30 / (1 + Math.Exp(-(x - 37.5) * 4)));
        var plan = MeasuringPlanner.Plan(surface, Surfaces.Measuring(2, 16));
        foreach (var point in plan.Points)
        {
            var refused = plan.Refusals.Any(r => r.Message.StartsWith(
                FormattableString.Invariant($"point {point.Number} "), StringComparison.Ordinal));
            if (point.Position.X < 37.5 - 5 || point.Position.X > 37.5 + 5)
            {
                Assert.False(refused, $"{point.Position.X}");
            }
            else if (point.Position.X is > 35.6 and < 36.8)
            {
                Assert.True(refused, $"{point.Position.X}");
            }
        }

        Assert.NotEmpty(plan.Refusals);
    }

    [Fact]
    public void A_wall_that_leans_away_is_touched_along_its_normal()
    {
        // 80 degrees steep.
        var plan = MeasuringPlanner.Plan(Surfaces.Quadratic((x, _) => x * Math.Tan(80 * Math.PI / 180)), Surfaces.Measuring(2, 4), 0.2);
        Assert.Empty(plan.Refusals);
        Assert.All(plan.Points, p => Assert.Equal(-Math.Sin(80 * Math.PI / 180), p.Normal.X, 1e-9));
    }

    [Fact]
    public void Travel_is_clear_of_the_highest_point_by_the_clearance()
    {
        var plan = MeasuringPlanner.Plan(Surfaces.One, Surfaces.Measuring(7, 10), 0.2);

        // The top of the parabola is z = 3.125 at x = 12.5. Bounds are at most 0.01 mm too high, and never too low.
        Assert.InRange(plan.ClearanceZ, 3.125 + 0.2 + 10 + 3, 3.125 + 0.2 + 10 + 3 + 0.01);
    }

    // After semi-finishing lies its stock, as much again where its ball did not fit, and the error that is plausible: 0.2, 0.2 and 0.1 mm.
    // After finishing only ridges and that error. Heights count from the stock.
    [Theory]
    [InlineData("semi-finishing", 0.2 + 0.1)]
    [InlineData("finishing", 0.03 + 0.1)]
    public void Exactly_enough_clearance_and_approach_pass_and_an_increment_less_is_refused(string after, double least)
    {
        Assert.Empty(Plan(after, least, least).Refusals);
        Assert.Equal(["clearance-too-low"], Plan(after, least - 0.001, least).Refusals.Select(r => r.Code));
        Assert.Equal(["approach-too-short"], Plan(after, least, least - 0.001).Refusals.Select(r => r.Code));
    }

    [Fact]
    public void A_refused_height_is_named_with_its_place_what_is_missing_and_what_to_write()
    {
        var refusals = Plan("semi-finishing", 0.05, 0.12).Refusals;
        Assert.Equal(["$.measuring.clearanceMm", "$.measuring.approachMm"], refusals.Select(r => r.Place.Path));
        Assert.Equal(
            "measuring.clearanceMm is 0.05 mm. Up to 0.5 mm of material may lie over the surface: 0.2 mm of stock (stockMm.semiFinishing), "
                + "and as much again where the ball of that stage did not fit, and 0.1 mm by which the piece may be off "
                + "(compensation.limitMm). Over the highest place, X0 Y0 Z0, the ball would be 0.25 mm too low. Write at least 0.3 over "
                + "the 0.2 mm of stock.",
            refusals[0].Message);
        Assert.Contains(
            "On the fast way down, at point 1 at X0 Y0 Z0 as at all others, the ball would be 0.18 mm too low.",
            refusals[1].Message,
            StringComparison.Ordinal);
    }

    // The referee reads the program back, and measures all moves but those that touch against places of the surface with its stock.
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    public void No_move_of_the_program_but_touching_meets_surface_and_stock(int shape)
    {
        const int N = 60;
        var surface = shape switch
        {
            1 => Surfaces.One,
            2 => Surfaces.Two,
            3 => Surfaces.Three,
            _ => Surfaces.Quadratic((x, _) => (x - 37.5) * (x - 37.5) / 40),
        };
        var plan = MeasuringPlanner.Plan(surface, Surfaces.Measuring(4, 6) with { ApproachMm = 0.2, ClearanceMm = 0.01 }, 0.2);
        Assert.Empty(plan.Refusals);
        var run = Programs.Path(Programs.Of("linuxcnc", plan).Bytes, NcDialects.LinuxCnc);
        Point3[] places = [
            .. from i in Enumerable.Range(0, N + 1)
               from j in Enumerable.Range(0, N + 1)
               select surface.Spline.PointAt((double)i / N, (double)j / N)];
        var moves = run.Motions.Where(m => m.Kind != MotionKind.Probe && m.UnknownStart == AxisSet.None).ToArray();

        // For each point across, down and up. Where the first move and those back from a touch begin, only the machine knows.
        Assert.Equal((3 * 24) - 1, moves.Length);
        foreach (var move in moves)
        {
            var way = move.End - move.Start;
            var square = Math.Max(way.Dot(way), 1e-12);
            var nearest = places.Min(p => (p - move.Start - (way * Math.Clamp((p - move.Start).Dot(way) / square, 0, 1))).Length);
            Assert.True(nearest >= 3 + 0.2 - 0.0015, $"{nearest} mm on the way from {move.Start} to {move.End}");
        }
    }

    private static MeasuringPlan Plan(string after, double clearance, double approach) => MeasuringPlanner.Plan(
        Surfaces.Flat,
        FreeformJob.Parse(
            Encoding.UTF8.GetBytes(FormattableString.Invariant(
                $$"""
                { "kind": "freeform", "name": "Heights", "surface": "surface.igs", "stockMm": { "roughing": 0.4, "semiFinishing": 0.2 },
                  "tool": { "kind": "ball", "diameterMm": 6 }, "spindleRpm": 10000, "feedMmPerMin": 1200,
                  "measuring": { "curves": 2, "pointsPerCurve": 3, "stylusDiameterMm": 6, "dialect": "siemens-840d",
                    "measuredAfter": "{{after}}", "clearanceMm": {{clearance}}, "approachMm": {{approach}} },
                  "toolpath": { "dialect": "linuxcnc", "scallopMm": 0.03 }, "compensation": { "limitMm": 0.1 } }
                """)),
            "job.json"));
}
