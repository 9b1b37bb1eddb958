using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform.Tests;

public sealed class MeasuringPlannerTests
{
    private static readonly PartSurface[] Designs = [Surfaces.One, Surfaces.Two, Surfaces.Three];

    [Theory]
    [InlineData(0, 7, 10, null, 70)]
    [InlineData(1, 7, 7, null, 49)]
    [InlineData(2, 7, null, 68, 68)]
    public void The_three_designs_get_the_paper_s_numbers_of_points(int design, int curves, int? each, int? points, int expected)
    {
        var plan = MeasuringPlanner.Plan(Designs[design], Surfaces.Measuring(curves, each, points), 0.2);
        Assert.Empty(plan.Refusals);
        Assert.Equal(expected, plan.Points.Count);
        Assert.Equal(Enumerable.Range(1, expected), plan.Points.Select(p => p.Number));
        Assert.Equal(curves, plan.Curves);
        Assert.Equal(expected, plan.Points.Select(p => (p.I, p.J)).Distinct().Count());
    }

    [Fact]
    public void A_curve_that_turns_more_gets_more_of_the_shared_points()
    {
        var plan = MeasuringPlanner.Plan(Surfaces.Three, Surfaces.Measuring(7, null, 68));
        int Count(int j) => plan.Points.Count(p => p.J == j);

        // Convex at y = 0, almost straight in the middle, concave at y = 63.
        Assert.True(Count(0) > Count(3) && Count(6) > Count(3));
    }

    [Fact]
    public void Both_ends_of_every_curve_and_both_outer_curves_are_measured()
    {
        var plan = MeasuringPlanner.Plan(Surfaces.Three, Surfaces.Measuring(7, null, 68));
        foreach (var curve in plan.Points.GroupBy(p => p.J).OrderBy(c => c.Key))
        {
            var along = curve.OrderBy(p => p.I).ToArray();
            Assert.Equal((0, 1), (along[0].U, along[^1].U));
            Assert.Equal((PlanReason.End, PlanReason.End), (along[0].Reason, along[^1].Reason));
        }

        Assert.Equal((0, 1), (plan.Points.Min(p => p.V), plan.Points.Max(p => p.V)));
    }

    [Fact]
    public void Points_share_the_turned_angle_and_the_length_of_a_parabola_equally()
    {
        // z = a x² + b x: the direction is atan(2 a x + b), the length is that of a parabola in closed form.
        const double a = -1 / 50.0, b = 0.5;
        var x = Curve(MeasuringPlanner.Plan(Surfaces.One, Surfaces.Measuring(7, 10)), 3).Select(p => p.Position.X).ToArray();
        var (angle, length) = (Angle(Surfaces.Width) - Angle(0), Length(Surfaces.Width) - Length(0));
        for (var i = 1; i < x.Length; i++)
        {
            var share = (0.7 * (Angle(x[i]) - Angle(x[i - 1])) / angle) + (0.3 * (Length(x[i]) - Length(x[i - 1])) / length);
            Assert.Equal(1.0 / 9, share, 1e-4);
        }

        static double Angle(double t) => -Math.Atan((2 * a * t) + b);

        static double Length(double t)
        {
            var s = (2 * a * t) + b;
            return ((s * Math.Sqrt(1 + (s * s))) + Math.Asinh(s)) / (4 * a);
        }
    }

    [Fact]
    public void Points_are_denser_where_the_slope_turns()
    {
        var x = Curve(MeasuringPlanner.Plan(Surfaces.One, Surfaces.Measuring(7, 10)), 0).Select(p => p.Position.X).ToArray();

        // The parabola bends most at its top, x = 12.5, and least at x = 75.
        Assert.True(x[1] - x[0] < 0.6 * (x[^1] - x[^2]));
    }

    [Fact]
    public void Straight_curves_are_divided_evenly()
    {
        var plan = MeasuringPlanner.Plan(Surfaces.Flat, Surfaces.Measuring(3, 6));
        Assert.All(plan.Points, p => Assert.Equal(p.I * 15.0, p.Position.X, 1e-9));
        Assert.All(plan.Points, p => Assert.Equal(p.J * 31.5, p.Position.Y, 1e-9));
    }

    [Fact]
    public void A_break_at_a_knot_gets_a_point_of_its_own_on_every_curve()
    {
        // Flat up to the knot, a parabola behind it: the curvature jumps.
        var plan = MeasuringPlanner.Plan(
            Surfaces.Profile(KnotVector.Clamped(2, [0, 0.4, 1]), x => x < 40 ? 0 : -10), Surfaces.Measuring(4, 6));
        Assert.Equal(0.4, Assert.Single(plan.BreaksU));
        Assert.Equal([0.4, 0.4, 0.4, 0.4], plan.Points.Where(p => p.Reason == PlanReason.Break).Select(p => p.U));
        Assert.Empty(plan.BreaksV);
    }

    [Fact]
    public void Knots_without_a_jump_of_curvature_are_no_breaks()
    {
        // Poles on a straight line make a straight line whatever the knots.
        var plan = MeasuringPlanner.Plan(Surfaces.Profile(KnotVector.Clamped(2, [0, 0.25, 0.5, 1]), x => x / 3), Surfaces.Measuring(4, 6));
        Assert.Empty(plan.BreaksU);
    }

    [Fact]
    public void A_break_that_smooth_knots_spread_is_found_by_its_jump_of_curvature()
    {
        // A cubic with 60 pieces over a plane that goes over into a parabola at x = 30:
        // nowhere a jump, but most of the change within a fiftieth.
        double[] breaks = [.. Enumerable.Range(0, 151).Select(i => i / 150.0)];
        var surface = Surfaces.Profile(KnotVector.Clamped(3, breaks), x => x < 30 ? 0 : -(x - 30) * (x - 30) / 100);
        var plan = MeasuringPlanner.Plan(surface, Surfaces.Measuring(4, 8));
        Assert.Equal(0.4, Assert.Single(plan.BreaksU), 0.012);
    }

    [Fact]
    public void Waves_are_no_breaks()
    {
        double[] breaks = [.. Enumerable.Range(0, 101).Select(i => i / 100.0)];
        var plan = MeasuringPlanner.Plan(
            Surfaces.Profile(KnotVector.Clamped(3, breaks), x => Math.Sin(x / 75 * 6 * Math.PI)), Surfaces.Measuring(4, 8));
        Assert.Empty(plan.BreaksU);
    }

    [Fact]
    public void Fewer_points_than_ends_and_breaks_are_refused_with_the_number_that_is_needed()
    {
        var plan = MeasuringPlanner.Plan(
            Surfaces.Profile(KnotVector.Clamped(2, [0, 0.4, 1]), x => x < 40 ? 0 : -10), Surfaces.Measuring(4, 2));
        var refusal = Assert.Single(plan.Refusals);
        Assert.Equal("too-few-points", refusal.Code);
        Assert.Contains("at least 3", refusal.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(0.01)]
    [InlineData(0.001)]
    [InlineData(0.0001)]
    public void As_many_points_are_planned_as_reach_the_wanted_error(double wanted)
    {
        var surface = Wave();
        var plan = MeasuringPlanner.Plan(surface, Surfaces.Measuring(2) with { Curves = null, ReconstructionErrorMm = wanted });
        Assert.Empty(plan.Refusals);
        Assert.True(plan.ReconstructionErrorMm <= wanted);

        // The interpolation of a sine of amplitude A and wave number k by cubics of spacing h errs by A (k h)^4 3/128 at its top; the plan
        // needs no more than twice the points that this asks for.
        var spacing = Math.Pow(wanted * 128 / (3 * 0.5), 0.25) / (4 * Math.PI / Surfaces.Width);
        Assert.InRange(plan.Points.Count(p => p.J == 0), 0.7 * Surfaces.Width / spacing, (2 * Surfaces.Width / spacing) + 4);
    }

    [Fact]
    public void A_wanted_error_that_no_number_of_points_reaches_is_refused()
    {
        var plan = MeasuringPlanner.Plan(Wave(), Surfaces.Measuring(2) with { Curves = null, ReconstructionErrorMm = 1e-15 });
        Assert.Equal("error-not-reached", Assert.Single(plan.Refusals).Code);
    }

    [Fact]
    public void Points_stay_inside_of_a_trimmed_region_and_off_its_edges()
    {
        // A circle of 25 mm about the middle.
        Point2[] circle = [
            .. Enumerable.Range(0, 360).Select(d => new Point2(
                0.5 + (25 / Surfaces.Width * Math.Cos(d * Math.PI / 180)), 0.5 + (25 / Surfaces.Depth * Math.Sin(d * Math.PI / 180))))];
        var plan = MeasuringPlanner.Plan(Surfaces.Flat with { Region = new([circle]) }, Surfaces.Measuring(5, 6));
        Assert.Empty(plan.Refusals);
        Assert.Equal(30, plan.Points.Count);
        Assert.Equal(PlanLayout.TrimSetInMm, plan.TrimSetInMm);
        foreach (var curve in plan.Points.GroupBy(p => p.J))
        {
            var y = curve.First().Position.Y - (Surfaces.Depth / 2);
            var half = Math.Sqrt((25 * 25) - (y * y));
            Assert.Equal((Surfaces.Width / 2) - half + 0.5, curve.Min(p => p.Position.X), 0.02);
            Assert.Equal((Surfaces.Width / 2) + half - 0.5, curve.Max(p => p.Position.X), 0.02);
        }
    }

    [Fact]
    public void Points_are_set_in_from_the_rim_by_what_is_asked_for()
    {
        var plan = MeasuringPlanner.Plan(Surfaces.Flat, Surfaces.Measuring(3, 3), rimSetInMm: 1.5);
        Assert.Equal([1.5, 37.5, 73.5], Curve(plan, 0).Select(p => p.Position.X), (a, b) => Math.Abs(a - b) < 1e-9);
        Assert.Equal(1.5, plan.Points.Min(p => p.Position.Y), 1e-9);
        Assert.Equal(61.5, plan.Points.Max(p => p.Position.Y), 1e-9);
    }

    [Fact]
    public void A_strip_narrower_than_what_is_kept_from_its_edges_is_refused()
    {
        var region = new SurfaceRegion([[new(0, 0.5), new(1, 0.5), new(1, 0.51), new(0, 0.51)]]);
        var refusal = Assert.Single(MeasuringPlanner.Plan(Surfaces.One with { Region = region }, Surfaces.Measuring(7, 10, null)).Refusals);
        Assert.Equal("no-room", refusal.Code);
        Assert.Contains(" 0.5 mm", refusal.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Normals_point_out_of_the_material()
    {
        Assert.All(MeasuringPlanner.Plan(Surfaces.One, Surfaces.Measuring(4, 4)).Points, p => Assert.True(p.Normal.Z > 0.3));
        Assert.All(
            MeasuringPlanner.Plan(Surfaces.One with { Outside = -1 }, Surfaces.Measuring(4, 4)).Points,
            p => Assert.True(p.Normal.Z < -0.3));
    }

    private static PartSurface Wave()
    {
        double[] breaks = [.. Enumerable.Range(0, 301).Select(i => i / 300.0)];
        return Surfaces.Profile(KnotVector.Clamped(3, breaks), x => 0.5 * Math.Sin(4 * Math.PI * x / Surfaces.Width));
    }

    private static IEnumerable<PlanPoint> Curve(MeasuringPlan plan, int j) => plan.Points.Where(p => p.J == j).OrderBy(p => p.I);
}
