using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;
using ErrorMatching.Refusals;

namespace ErrorMatching.Freeform.Tests;

public sealed class CompensatorTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void Surface_is_the_nominal_one_moved_by_the_error_to_the_other_side(int design)
    {
        var piece = new MeasuredDesign(Design(design));
        var result = piece.Compensate(piece.With(Tilted)).Result!;

        // The exact error, mirrored, on the nominal parametrization; 10 nm are what the B-spline may be off.
        Assert.True(piece.Off(result.Surface.Spline, Tilted) < 3e-5, $"{piece.Off(result.Surface.Spline, Tilted)}");
        Assert.True(result.ApproximationMm <= 1.01e-5);
        Assert.Equal(0.03, result.LargestMoveMm, 4);
        Assert.Equal(
            (piece.Surface.Region, piece.Surface.Outside, piece.Surface.Name),
            (result.Surface.Region, result.Surface.Outside, result.Surface.Name));
        Assert.Equal(SpatialVerdict.Systematic, result.Structure.Verdict);
        // What is left is what the probe of the job, 0.125 um at a point, may have told wrong.
        Assert.InRange(result.Mirror.Statistics.StandardDeviationMm, 1e-6, 5e-5);
    }

    [Fact]
    public void Gain_is_the_share_that_is_compensated()
    {
        var piece = new MeasuredDesign(PaperDesign.Two, "\"gain\": 1.0", "\"gain\": 0.25");
        var result = piece.Compensate(piece.With(Tilted)).Result!;

        Assert.True(piece.Off(result.Surface.Spline, Tilted, 0.25) < 3e-5);
        Assert.Equal(0.75 * result.Before.StandardDeviationMm, result.Mirror.Statistics.StandardDeviationMm, 6);
    }

    [Fact]
    public void Tool_radius_moves_everything_by_the_mean_and_leaves_the_spread()
    {
        var piece = new MeasuredDesign(PaperDesign.One, "\"method\": \"mirror\"", "\"method\": \"tool-radius\"");
        var result = piece.Compensate(piece.With(Tilted)).Result!;

        Assert.True(piece.Off(result.Surface.Spline, (u, v) => result.Before.MeanMm) < 3e-5);
        Assert.Equal(result.Before.StandardDeviationMm, result.Predicted.Statistics.StandardDeviationMm, 5);
        Assert.Equal(0, result.Predicted.Statistics.MeanMm, 7);
    }

    // A surface through every point cuts the noise of the first measurement, and the second one has its own: no residual tells that.
    [Fact]
    public void A_fit_through_every_point_does_not_promise_to_leave_nothing()
    {
        var piece = new MeasuredDesign(PaperDesign.One, "\"method\": \"best\"", "\"method\": \"tensor\"");
        var random = new Random(2);
        var result = piece.Compensate(piece.With(
            (u, v) => Tilted(u, v) + (0.002 * (random.NextDouble() + random.NextDouble() - 1)))).Result!;

        // The noise has a standard deviation of 2 um / sqrt(6) = 0.82 um.
        Assert.InRange(result.Mirror.Statistics.StandardDeviationMm, 0.0008, 0.0025);
    }

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
            Assert.Throws<InputException>(() => SurfaceEvaluation.Of(
                piece.Job, piece.Surface, [piece.With(Tilted), piece.With(Tilted, "copy.csv")])).Code);
    }

    [Fact]
    public void Measurements_that_differ_by_more_than_they_show_are_warned_of()
    {
        var piece = new MeasuredDesign(PaperDesign.One);
        var result = piece.Compensate(piece.With(Tilted), piece.With((u, v) => Tilted(u, v) + 0.1, "again.csv")).Result!;
        Assert.Contains("in one clamping?", Assert.Single(result.Warnings), StringComparison.Ordinal);
        Assert.Empty(piece.Compensate(piece.With(Tilted), piece.With((u, v) => Tilted(u, v) + 0.0001, "again.csv")).Result!.Warnings);
    }

    [Fact]
    public void What_is_strange_in_a_file_is_said_in_every_report()
    {
        var piece = new MeasuredDesign(PaperDesign.One);
        var strange = piece.With(Tilted) with { Warnings = ["out of order"] };
        Assert.Equal(["out of order"], piece.Compensate(strange).Result!.Warnings);
        Assert.Equal(["out of order"], Assert.Single(SurfaceEvaluation.Of(piece.Job, piece.Surface, [strange]).Pieces).Warnings);
    }

    // Measured without noise, so that nothing is left at the points: the lines that were left out tell that it is little to go by.
    [Fact]
    public void A_field_that_its_points_hardly_tell_is_said_to_be_one()
    {
        var piece = new MeasuredDesign(PaperDesign.One);
        var result = piece.Compensate(piece.With((u, v) => 0.03 * Math.Sin((13.9 * u) + 1) * Math.Cos((8.8 * v) + 2))).Result!;

        Assert.InRange(result.Mirror.Statistics.StandardDeviationMm, 0, 5e-4);
        Assert.Contains("Where a line of points is left out", Assert.Single(result.Notes), StringComparison.Ordinal);
        Assert.Empty(piece.Compensate(piece.With(Tilted)).Result!.Notes);

        var random = new Random(3);
        Assert.Empty(piece.Compensate(piece.With((u, v) => Tilted(u, v) + (0.003 * (random.NextDouble() - 0.5)))).Result!.Notes);
    }

    [Fact]
    public void Noise_is_reported_and_not_cut()
    {
        var piece = new MeasuredDesign(PaperDesign.Three);
        var random = new Random(4);
        var result = piece.Compensate(piece.With((u, v) => 0.012 + (0.002 * (random.NextDouble() - 0.5)))).Result!;

        Assert.Equal(SpatialVerdict.Noise, result.Structure.Verdict);
        Assert.Contains("looks like noise", Assert.Single(result.Warnings), StringComparison.Ordinal);
        Assert.True(piece.Off(result.Surface.Spline, (u, v) => result.Before.MeanMm) < 3e-5);
    }

    // Noise whose own mean is taken away, and a mean of so many of its standard errors put in its place.
    [Theory]
    [InlineData(1.95, false)]
    [InlineData(2.05, true)]
    [InlineData(-1.95, false)]
    [InlineData(-2.05, true)]
    public void A_mean_beside_noise_is_cut_from_two_of_its_standard_errors_on(double standardErrors, bool isCut)
    {
        var piece = new MeasuredDesign(PaperDesign.Three);
        var random = new Random(4);
        var noise = piece.Plan.Points.ToDictionary(p => (p.U, p.V), _ => 0.002 * (random.NextDouble() - 0.5));
        var own = noise.Values.Average();
        var deviation = Math.Sqrt(noise.Values.Sum(e => (e - own) * (e - own)) / (noise.Count - 1));
        var mean = standardErrors * deviation / Math.Sqrt(noise.Count);
        var result = piece.Compensate(piece.With((u, v) => noise[(u, v)] - own + mean)).Result!;

        Assert.Equal(SpatialVerdict.Noise, result.Structure.Verdict);
        Assert.Equal(isCut ? Math.Abs(mean) : 0, result.LargestMoveMm, 1e-6);
    }

    [Theory]
    [InlineData("mirror")]
    [InlineData("tool-radius")]
    public void A_mean_that_may_be_none_is_not_cut_either(string method)
    {
        var piece = new MeasuredDesign(PaperDesign.Three, "\"method\": \"mirror\"", $"\"method\": \"{method}\"");
        var random = new Random(4);
        var result = piece.Compensate(piece.With((u, v) => 0.002 * (random.NextDouble() - 0.5))).Result!;

        Assert.Equal(0, result.LargestMoveMm);
        Assert.Same(piece.Surface.Spline, result.Surface.Spline);
        Assert.Contains("nothing is compensated", result.Warnings[0], StringComparison.Ordinal);
        Assert.All(
            new[] { result.Mirror, result.ToolRadius },
            p => Assert.Equal((0, result.Predicted.Statistics), (p.Statistics.MeanMm, p.Statistics)));
        var map = ErrorMap.Of(result);
        Assert.All(map.ToolRadiusMm.Concat(map.MirrorMm), e => Assert.Equal(0, e));
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
                        + $"{um:+0.0;-0.0} um off along the normal, where the points around it say {said:+0.0;-0.0} um: "),
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
        Assert.Contains("two.csv is furthest off there", refusal.Message, StringComparison.Ordinal);
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
        Assert.Contains(
            $"is {said} mm off along the normal; compensation.limitMm allows 0.2 mm", refusal.Message, StringComparison.Ordinal);
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

    [Theory]
    [InlineData("through-curve-mesh")]
    [InlineData("through-curves")]
    [InlineData("fit-surface")]
    [InlineData("studio-surface")]
    [InlineData("tensor")]
    [InlineData("best")]
    public void Every_fit_can_lay_the_error_or_the_compensation_points(string method)
    {
        foreach (var of in new[] { "error", "points" })
        {
            var piece = new MeasuredDesign(
                PaperDesign.Two, "\"method\": \"best\", \"of\": \"error\"", $"\"method\": \"{method}\", \"of\": \"{of}\"");
            var result = piece.Compensate(piece.With(Tilted)).Result!;

            // A linear error and a quadratic surface are within every method's reach: 2 um at the measured points, far less for most.
            Assert.All(result.Samples, s => Assert.InRange(result.Surface.Spline.ClosestPoint(result.PointOf(s)).Distance, 0, 0.002));
        }
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
            string.Create(CultureInfo.InvariantCulture, $" lies {gap:0.###} mm inside of the edge"),
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

    [Fact]
    public void Compensation_points_are_those_of_the_equations()
    {
        var piece = new MeasuredDesign(PaperDesign.Three);
        var measured = piece.With(Tilted);
        var result = piece.Compensate(measured).Result!;
        var rows = Encoding.UTF8.GetString(CompensationCsv.Write(result)).Split('\n');

        Assert.Equal("point,x,y,z,errorUm", rows[0]);
        Assert.Equal(piece.Plan.Points.Count + 2, rows.Length);
        foreach (var (row, point) in rows.Skip(1).Zip(measured.Points))
        {
            var cells = row.Split(',').Select(c => double.Parse(c, CultureInfo.InvariantCulture)).ToArray();
            var wanted = MirrorEquations.CompensationPoint(
                point.Contact, MirrorEquations.MirrorPoint(point.Planned.Position, point.Planned.Normal, 0.2), point.Planned.Normal);
            Assert.True((new Point3(cells[1], cells[2], cells[3]) - wanted).Length < 1e-5, row);
            Assert.Equal(1000 * Tilted(point.Planned.U, point.Planned.V), cells[4], 2);
        }
    }

    [Theory]
    [InlineData("error")]
    [InlineData("points")]
    public void Move_at_a_point_is_the_way_to_the_surface_that_is_cut_whatever_the_points_noise(string of)
    {
        var piece = new MeasuredDesign(PaperDesign.Three, "\"of\": \"error\"", $"\"of\": \"{of}\"");
        var random = new Random(8);
        var result = piece.Compensate(piece.With((u, v) => Tilted(u, v) + (0.004 * (random.NextDouble() - 0.5)))).Result!;

        foreach (var sample in result.Samples)
        {
            var move = result.MoveAt(sample);
            Assert.InRange(result.Surface.Spline.ClosestPoint(sample.Nominal + move).Distance, 0, 2e-5);
            Assert.True(move.Cross(sample.Normal).Length < 1e-4);
        }

        // The noise is what the way to a point's own compensation point has beside it.
        Assert.InRange(result.Samples.Max(s => (result.PointOf(s) - s.Nominal - result.MoveAt(s)).Length), 0.001, 0.004);
    }

    [Theory]
    [InlineData("error")]
    [InlineData("points")]
    public void Largest_move_is_that_of_a_measured_point_where_the_error_has_its_peak(string of)
    {
        var piece = new MeasuredDesign(PaperDesign.Three, "\"of\": \"error\"", $"\"of\": \"{of}\"");
        var top = piece.Plan.Points[piece.Plan.Points.Count / 2];
        var result = piece.Compensate(piece.With(
            (u, v) => 0.02 - (0.05 * (((u - top.U) * (u - top.U)) + ((v - top.V) * (v - top.V)))))).Result!;

        var at = result.Samples.Single(s => s.Point == top.Number);
        Assert.Equal(0.02, result.MoveAt(at).Length, of == "error" ? 1e-7 : 2e-5);
        Assert.Equal(result.MoveAt(at).Length, result.LargestMoveMm, 9);
    }

    [Fact]
    public void Several_measurements_of_a_piece_are_averaged()
    {
        var piece = new MeasuredDesign(PaperDesign.One);
        var result = piece.Compensate(piece.With((u, v) => Tilted(u, v) + 0.001), piece.With((u, v) => Tilted(u, v) - 0.001)).Result!;

        Assert.All(result.Samples, s => Assert.Equal(Tilted(s.U, s.V), s.ErrorMm, 6));
        Assert.Contains("measured 2 times", Assert.Single(result.Notes), StringComparison.Ordinal);
    }

    [Fact]
    public void An_alignment_is_made_where_the_job_asks_for_it()
    {
        var piece = new MeasuredDesign(
            PaperDesign.Three, "\"stylusDiameterMm\": 6", "\"alignment\": \"best-fit\", \"stylusDiameterMm\": 6");
        var measured = piece.With((u, v) => 0);
        var moved = measured with
        {
            Points = [.. measured.Points.Select(p => p with { Contact = p.Contact + new Vector3(0.02, -0.03, 0.05) })]
        };
        var result = piece.Compensate(moved).Result!;

        Assert.NotNull(result.Alignment);
        Assert.All(result.Samples, s => Assert.Equal(0, s.ErrorMm, 7));
    }

    private static double Tilted(double u, double v) => 0.01 + (0.012 * u) + (0.008 * v);

    private static PartSurface Design(int number) => number switch { 1 => PaperDesign.One, 2 => PaperDesign.Two, _ => PaperDesign.Three };
}
