using ErrorMatching.Geometry;
using static ErrorMatching.Freeform.Tests.MeasuredDesign;

namespace ErrorMatching.Freeform.Tests;

/// <summary>What a compensation and an evaluation warn of, by its code.</summary>
public sealed class CompensationWarningTests
{
    [Fact]
    public void One_measurement_that_lies_off_its_repeats_is_named()
    {
        var piece = new MeasuredDesign(PaperDesign.One);
        var (random, bad) = (new Random(5), piece.Plan.Points[31]);
        double Noisy(double u, double v) => Tilted(u, v) + (0.0002 * (random.NextDouble() - 0.5));
        var result = piece.Compensate(
            piece.With(Noisy),
            piece.With(Noisy, "second.csv"),
            piece.With((u, v) => Noisy(u, v) + (u == bad.U && v == bad.V ? 0.02 : 0), "third.csv")).Result!;

        var warning = Assert.Single(result.Warnings, w => w.Code == "repeat-outlier");
        Assert.Equal((bad.Number.ToString(System.Globalization.CultureInfo.InvariantCulture), "3"), (warning.Values[0], warning.Values[2]));
    }

    [Fact]
    public void Of_four_points_nobody_can_tell_a_structure()
    {
        var piece = new MeasuredDesign(
            PaperDesign.One, "\"curves\": 7, \"pointsPerCurve\": 10", "\"curves\": 2, \"pointsPerCurve\": 2");
        var outcome = piece.Compensate(piece.With(Tilted));
        Assert.True(outcome.IsUsable, outcome.IsUsable ? "" : outcome.Refusal.Message);
        Assert.Contains(outcome.Result.Warnings, w => w.Code == "structure-unknown");
    }

    [Fact]
    public void A_step_that_no_smooth_model_follows_is_followed_point_by_point_which_is_said()
    {
        // A flat square, whose points are evenly spaced.
        var square = KnotVector.Clamped(2, [0, 1]);
        Point3[] poles = [.. Enumerable.Range(0, 9).Select(k => new Point3(20 * (k / 3), 20 * (k % 3), 0))];
        var piece = new MeasuredDesign(
            new("square", new(square, square, poles), SurfaceRegion.Whole, 1),
            "\"curves\": 7, \"pointsPerCurve\": 10",
            "\"curves\": 13, \"pointsPerCurve\": 15");
        var random = new Random(3);
        double[] noise = [.. Enumerable.Range(0, 13 * 15).Select(_ => 0.0005 * (random.NextDouble() - 0.5))];
        var result = piece.Compensate(
            piece.With((u, v) => (u > 0.52 ? 0.02 : 0) + noise[((int)Math.Round(12 * v) * 15) + (int)Math.Round(14 * u)])).Result!;

        var warning = Assert.Single(result.Warnings, w => w.Code == "follows-each-point");
        Assert.Contains("noise", warning.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Several_outlying_points_are_named_together()
    {
        var piece = new MeasuredDesign(PaperDesign.One);
        var (one, other) = (piece.Plan.Points[12], piece.Plan.Points[50]);
        var e = SurfaceEvaluation.Evaluate(
            piece.Job,
            piece.Surface,
            [piece.With((u, v) => (u == one.U && v == one.V) || (u == other.U && v == other.V) ? 0.48 : 0.01 * v)]);
        Assert.Equal("outlying-points-measured", Assert.Single(Assert.Single(e.Pieces).Warnings).Code);
    }
}
