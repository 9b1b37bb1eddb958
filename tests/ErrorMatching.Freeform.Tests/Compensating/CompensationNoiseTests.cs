using ErrorMatching.Reporting;
using static ErrorMatching.Freeform.Tests.MeasuredDesign;

namespace ErrorMatching.Freeform.Tests;

/// <summary>What is noise, and what is said of a measurement that tells little.</summary>
public sealed class CompensationNoiseTests
{
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

    [Fact]
    public void Measurements_that_differ_by_more_than_they_show_are_warned_of()
    {
        var piece = new MeasuredDesign(PaperDesign.One);
        var result = piece.Compensate(piece.With(Tilted), piece.With((u, v) => Tilted(u, v) + 0.1, "again.csv")).Result!;
        Assert.Equal("repeats-differ", Assert.Single(result.Warnings).Code);
        Assert.Empty(piece.Compensate(piece.With(Tilted), piece.With((u, v) => Tilted(u, v) + 0.0001, "again.csv")).Result!.Warnings);
    }

    [Fact]
    public void What_is_strange_in_a_file_is_said_in_every_report()
    {
        var piece = new MeasuredDesign(PaperDesign.One);
        var warning = ReportWarning.Of(SurfaceWarningForms.OutOfOrder, "measured.csv", "7", "5", "6");
        var strange = piece.With(Tilted) with { Warnings = [warning] };
        Assert.Equal([warning], piece.Compensate(strange).Result!.Warnings);
        Assert.Equal([warning], Assert.Single(SurfaceEvaluation.Evaluate(piece.Job, piece.Surface, [strange]).Pieces).Warnings);
    }

    // Measured without noise, so that nothing is left at the points: the lines that were left out tell that it is little to go by.
    [Fact]
    public void A_field_that_its_points_hardly_tell_is_said_to_be_one()
    {
        var piece = new MeasuredDesign(PaperDesign.One);
        var result = piece.Compensate(piece.With(
            (u, v) => 0.03 * Math.Sin((4 * u) + (9 * u * u) + 1) * Math.Cos((3 * v) + (5 * v * v) + 2))).Result!;

        Assert.InRange(result.Mirror.Statistics.StandardDeviationMm, 0, 5e-4);
        Assert.Equal("points-too-far-apart", Assert.Single(result.Warnings).Code);
        Assert.Empty(piece.Compensate(piece.With(Tilted)).Result!.Warnings);

        var random = new Random(3);
        Assert.Empty(piece.Compensate(piece.With((u, v) => Tilted(u, v) + (0.003 * (random.NextDouble() - 0.5)))).Result!.Warnings);
    }

    [Fact]
    public void Noise_is_reported_and_not_cut()
    {
        var piece = new MeasuredDesign(PaperDesign.Three);
        var random = new Random(4);
        var result = piece.Compensate(piece.With((u, v) => 0.012 + (0.002 * (random.NextDouble() - 0.5)))).Result!;

        Assert.Equal(SpatialVerdict.Noise, result.Structure.Verdict);
        Assert.Equal("noise-but-mean", Assert.Single(result.Warnings).Code);
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
        Assert.Equal("noise-only", result.Warnings[0].Code);
        Assert.All(
            new[] { result.Mirror, result.ToolRadius },
            p => Assert.Equal((0, result.Predicted.Statistics), (p.Statistics.MeanMm, p.Statistics)));
        var map = ErrorMap.Of(result);
        Assert.All(map.ToolRadiusMm.Concat(map.MirrorMm), e => Assert.Equal(0, e));
    }
}
