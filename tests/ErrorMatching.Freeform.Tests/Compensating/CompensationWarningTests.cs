using ErrorMatching.Reporting;
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

    // Which errors end there is a matter of the fit (ErrorFit); here only what is said of them.
    [Fact]
    public void A_field_that_follows_each_point_says_that_it_follows_their_noise_too()
    {
        var warning = ReportWarning.Of(SurfaceWarningForms.FollowsEachPoint);
        Assert.Equal("follows-each-point", warning.Code);
        Assert.Contains("noise", warning.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Several_outlying_points_are_named_together()
    {
        var piece = new MeasuredDesign(PaperDesign.One);
        var (one, other) = (piece.Plan.Points[12], piece.Plan.Points[50]);
        var e = SurfaceEvaluation.Of(
            piece.Job,
            piece.Surface,
            [piece.With((u, v) => (u == one.U && v == one.V) || (u == other.U && v == other.V) ? 0.48 : 0.01 * v)]);
        Assert.Equal("outlying-points-measured", Assert.Single(Assert.Single(e.Pieces).Warnings).Code);
    }
}
