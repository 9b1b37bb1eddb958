using System.Globalization;
using System.Text;
using ErrorMatching.Geometry;
using static ErrorMatching.Freeform.Tests.MeasuredDesign;

namespace ErrorMatching.Freeform.Tests;

/// <summary>The compensated surface: where it lies, and what it is made of.</summary>
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

    private static PartSurface Design(int number) => number switch { 1 => PaperDesign.One, 2 => PaperDesign.Two, _ => PaperDesign.Three };
}
