using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;
using static ErrorMatching.Freeform.Tests.MeasuredDesign;

namespace ErrorMatching.Freeform.Tests;

/// <summary>Which measurements are not compensated.</summary>
public sealed class CompensationRefusalTests
{
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    public void What_was_measured_after_another_stage_is_not_taken_for_an_error(int among)
    {
        // A limit that lets it pass, and one right measurement beside it.
        var piece = new MeasuredDesign(PaperDesign.One, "\"limitMm\": 0.2", "\"limitMm\": 0.5");
        var finished = piece.Over(0, Tilted, "after.csv");
        var refusal = Assert.Single((among == 0 ? piece.Compensate(finished) : piece.Compensate(piece.With(Tilted), finished)).Refusals);
        Assert.Equal("other-stage", refusal.Code);
        Assert.Contains("after.csv", refusal.Message, StringComparison.Ordinal);
        Assert.Contains("after finishing", refusal.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_measurement_that_is_given_twice_is_refused()
    {
        var piece = new MeasuredDesign(PaperDesign.One);
        Assert.Equal(
            "same-measurement",
            Assert.Throws<InputException>(() => piece.Compensate(piece.With(Tilted), piece.With(Tilted, "copy.csv"))).Code);
        Assert.Equal(
            "same-measurement",
            Assert.Throws<InputException>(() => SurfaceEvaluation.Evaluate(
                piece.Job, piece.Surface, [piece.With(Tilted), piece.With(Tilted, "copy.csv")])).Code);
    }

    [Fact]
    public void A_point_beyond_the_limit_stops_the_job_and_is_named()
    {
        var piece = new MeasuredDesign(PaperDesign.Two);
        var worst = piece.Plan.Points[20];
        var refusal = Assert.Single(piece.Compensate(piece.With((u, v) => u == worst.U && v == worst.V ? 0.31 : 0.01)).Refusals);

        Assert.Equal("beyond-limit", refusal.Code);
        Assert.Contains($"Point {worst.Number} is +0.31 mm off", refusal.Message, StringComparison.Ordinal);
    }

    // Neither would have been said: 60 um were fitted as if they were the surface's, and 150 um made everything else look like noise.
    [Theory]
    [InlineData("mirror", 0.06)]
    [InlineData("mirror", 0.15)]
    [InlineData("tool-radius", 0.15)]
    [InlineData("mirror", -0.035)]
    public void A_point_that_is_not_what_those_around_it_say_stops_the_job_and_is_named(string method, double off)
    {
        var piece = new MeasuredDesign(PaperDesign.One, "\"method\": \"mirror\"", $"\"method\": \"{method}\"");
        foreach (var bad in new[] { piece.Plan.Points[31], piece.Plan.Points[0], piece.Plan.Points[^1] })
        {
            var refusal = Assert.Single(
                piece.Compensate(piece.With((u, v) => Tilted(u, v) + (u == bad.U && v == bad.V ? off : 0))).Refusals);

            Assert.Equal("outlying-point", refusal.Code);
            var (um, said) = (1000 * (Tilted(bad.U, bad.V) + off), 1000 * Tilted(bad.U, bad.V));
            Assert.StartsWith(
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"Point {bad.Number} (near X{bad.Position.X:0.###} Y{bad.Position.Y:0.###} Z{bad.Position.Z:0.###}) is "
                        + $"{um:+0.0;-0.0} µm off along the normal, where the points around it say {said:+0.0;-0.0} µm: "),
                refusal.Message,
                StringComparison.Ordinal);
            Assert.Contains("measure again", refusal.Message, StringComparison.Ordinal);
        }
    }

    [Fact]
    public void Of_several_measurements_the_one_with_the_bad_touch_is_named()
    {
        var piece = new MeasuredDesign(PaperDesign.Two);
        var bad = piece.Plan.Points[20];
        var refusal = Assert.Single(
            piece.Compensate(
                piece.With(Tilted, "one.csv"),
                piece.With((u, v) => Tilted(u, v) + (u == bad.U && v == bad.V ? 0.12 : 0.0001), "two.csv")).Refusals);

        Assert.Equal("outlying-point", refusal.Code);
        Assert.StartsWith($"Point {bad.Number} ", refusal.Message, StringComparison.Ordinal);
        Assert.Contains("in the mean of all measurements", refusal.Message, StringComparison.Ordinal);
        Assert.Contains(" two.csv ", refusal.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(-0.200001, "-0.200001")]
    [InlineData(-0.20004, "-0.20004")]
    [InlineData(0.2001, "+0.2001")]
    public void A_point_hardly_beyond_the_limit_is_told_by_as_many_digits_as_it_takes(double error, string said)
    {
        var piece = new MeasuredDesign(PaperDesign.Two);
        var worst = piece.Plan.Points[20];
        var refusal = Assert.Single(piece.Compensate(piece.With((u, v) => u == worst.U && v == worst.V ? error : 0.01)).Refusals);
        Assert.Contains($" {said} mm ", refusal.Message, StringComparison.Ordinal);
        Assert.Contains(" 0.2 mm", refusal.Message, StringComparison.Ordinal);
    }

    // Waves of four points each way: the points lie beside the crests, and the surface through them goes over the limit that they keep.
    [Fact]
    public void A_surface_that_goes_beyond_the_limit_between_its_points_is_refused()
    {
        var piece = new MeasuredDesign(PaperDesign.One, "\"method\": \"best\"", "\"method\": \"tensor\"");
        var refusal = Assert.Single(piece.Compensate(piece.With((u, v) => 0.207 * Math.Cos(Math.PI * ((4.5 * u) - 0.25)))).Refusals);

        Assert.Equal("beyond-limit", refusal.Code);
        Assert.Contains("Between the points", refusal.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Where_most_points_are_off_it_is_said_what_to_check()
    {
        var piece = new MeasuredDesign(PaperDesign.Two, "\"limitMm\": 0.2", "\"limitMm\": 0.1");
        var refusal = Assert.Single(piece.Compensate(piece.With((u, v) => 0.15 + Tilted(u, v))).Refusals);

        Assert.Equal("beyond-limit", refusal.Code);
        Assert.Contains("measuring.measuredAfter", refusal.Message, StringComparison.Ordinal);
        Assert.Contains("and 69 more points", refusal.Message, StringComparison.Ordinal);
    }

    // A surface through points knows of no hole, and ends with its points: cut, it would go over the hole and leave the edge standing.
    [Fact]
    public void A_surface_through_points_is_not_laid_where_it_would_lose_the_trimming()
    {
        Point2[] rim = [new(0, 0), new(1, 0), new(1, 1), new(0, 1)];
        Point2[] hole = [new(0.4, 0.4), new(0.4, 0.6), new(0.6, 0.6), new(0.6, 0.4)];
        var trimmed = PaperDesign.Two with { Region = new([rim, hole]) };
        var piece = new MeasuredDesign(trimmed, "\"of\": \"error\"", "\"of\": \"points\"");
        var refusal = Assert.Single(piece.Compensate(piece.With(Tilted)).Refusals);

        Assert.Equal("limits-lost", refusal.Code);
        Assert.Contains("Use \"of\": \"error\" under fit", refusal.Message, StringComparison.Ordinal);
        Assert.Equal(trimmed.Region, new MeasuredDesign(trimmed).Compensate(piece.With(Tilted)).Result!.Surface.Region);
    }

    [Theory]
    [InlineData(true, false)]
    [InlineData(true, true)]
    [InlineData(false, false)]
    [InlineData(false, true)]
    public void A_surface_through_points_is_not_laid_where_it_would_end_before_the_edge(bool endOfCurves, bool last)
    {
        var piece = new MeasuredDesign(PaperDesign.Two, "\"of\": \"error\"", "\"of\": \"points\"");
        var measured = piece.With(Tilted);
        var edge = last ? piece.Plan.Points.Max(At) : 0;
        var outermost = piece.Plan.Points.Where(p => At(p) == edge + (last ? -1 : 1));
        var gap = outermost.Max(
            p => piece.Plan.Points.Where(q => At(q) == edge && Along(q) == Along(p)).Min(q => (p.Position - q.Position).Length));
        var refusal = Assert.Single(
            piece.Compensate(measured with { Points = [.. measured.Points.Where(p => At(p.Planned) != edge)] }).Refusals);

        Assert.Equal("limits-lost", refusal.Code);
        Assert.Contains(
            string.Create(CultureInfo.InvariantCulture, $" {gap:0.###} mm "),
            refusal.Message,
            StringComparison.Ordinal);
        Assert.Contains("measure up to the edges", refusal.Message, StringComparison.Ordinal);

        int At(PlanPoint p) => endOfCurves ? p.I : p.J;
        int Along(PlanPoint p) => endOfCurves ? p.J : p.I;
    }

    // A probe does not come down exactly where it was sent, and so never exactly on the edge.
    [Fact]
    public void Points_a_probe_s_error_from_the_edge_reach_it()
    {
        var piece = new MeasuredDesign(PaperDesign.Two, "\"of\": \"error\"", "\"of\": \"points\"");
        var random = new Random(3);
        var measured = piece.With(Tilted);
        var beside = measured with
        {
            Points = [
                .. measured.Points.Select(
                    p => p with
                    {
                        Contact = p.Contact + new Vector3(0.03 * (random.NextDouble() - 0.5), 0.03 * (random.NextDouble() - 0.5), 0)
                    })]
        };

        Assert.NotNull(piece.Compensate(beside).Result);
    }
}
