using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform.Tests;

public sealed class ProfileWordsTests
{
    private static readonly ProfileTolerance Tolerance = new(0.02, DecisionRule.Simple, false);
    private static readonly ProfileTolerance Guarded = new(0.02, DecisionRule.GuardBand(5), true);

    [Fact]
    public void A_piece_in_tolerance_has_its_profile_and_its_probability() => Assert.Equal(
        "In tolerance: profile 18.00 of 20 µm at 2 points, with a probability of 97.7 %.", Measured(Tolerance, 0.0005, 0, -0.009));

    [Fact]
    public void A_piece_out_of_tolerance_names_its_points_and_the_furthest() => Assert.Equal(
        "Out of tolerance: profile 25.00 of 20 µm; 2 of 3 points are outside ±10 µm: points 1 and 3, point 3 the furthest, by 2.50 µm.",
        Measured(Tolerance, 0.0005, 0.011, 0, -0.0125));

    [Fact]
    public void A_single_point_outside_is_one() => Assert.Equal(
        "Out of tolerance: profile 25.00 of 20 µm; 1 of 2 points is outside ±10 µm: point 2, by 2.50 µm.",
        Measured(Tolerance, 0.0005, 0, -0.0125));

    [Fact]
    public void A_guard_band_that_does_not_accept_a_point_is_stated() => Assert.Equal(
        "Not accepted: profile 18.00 of 20 µm, but the guard band of 1.645 µm at each limit does not accept point 1: too near the limit.",
        Measured(Guarded, 0.001, 0.009, 0));

    [Fact]
    public void Of_several_pieces_the_worst_decides()
    {
        (string, ProfileJudgement) good = ("a.csv", Judged(Tolerance, 0.0005, 0.001)), bad = ("b.csv", Judged(Tolerance, 0.0005, 0.011));
        Assert.StartsWith(
            "Out of tolerance: 1 of 2 pieces, b.csv the worst with profile 22.00 of 20 µm; 1 of 1 point is outside",
            ProfileWords.Of(Tolerance, [good, bad]),
            StringComparison.Ordinal);
        Assert.StartsWith(
            "In tolerance: all 2 pieces, a.csv the worst with profile 2.00 of 20 µm at 1 point",
            ProfileWords.Of(Tolerance, [good, good]),
            StringComparison.Ordinal);
        Assert.Equal("Before: out of tolerance, profile 22.00 µm.", ProfileWords.Before([good.Item2, bad.Item2]));
    }

    [Theory]
    [InlineData(new[] { 0.0, 0.001 }, 0.001, 0.0, "Expected in tolerance: profile 5.00 of 20 µm, with a probability of more than 99.9 %.")]
    [InlineData(
        new[] { 0.0 },
        0.02,
        0.0,
        "Not sure to be in tolerance: profile 5.00 of 20 µm is expected, with a probability of 38.3 % that all points are inside; 50 % are "
            + "wanted. Do not cut it unless you accept the risk.")]
    [InlineData(
        new[] { 0.0 },
        0.001,
        -0.0123,
        "Expected out of tolerance between the points: 12.30 of ±10 µm. Do not cut it unless that is acceptable there.")]
    [InlineData(
        new[] { 0.0, 0.012 },
        0.001,
        0.0,
        "Expected out of tolerance: profile 5.00 of 20 µm; 1 of 2 points will be outside ±10 µm: point 2, by 2.00 µm. Do not cut it unless "
            + "that is acceptable there.")]
    public void A_prediction_says_when_not_to_cut(double[] errors, double uncertainty, double between, string words) => Assert.Equal(
        words + " As measured: out of tolerance, profile 40.00 µm.",
        ProfileWords.Of(
            new SurfaceVerdict(
                Tolerance,
                Judged(Tolerance, 0.0005, 0.02),
                ProfileJudgementTests.Predicted(Tolerance, errors, uncertainty, between))));

    [Fact]
    public void The_tolerance_says_whether_the_zone_may_move_and_how_points_are_accepted()
    {
        Assert.Equal(
            "Profile of a surface 20 µm by ISO 1101, with datums: points are judged where they were measured; measured points are "
                + "accepted up to the limits.",
            ProfileWords.Of(Tolerance, 0.001));
        Assert.Equal(
            "Profile of a surface 20 µm by ISO 1101, without datums: points are aligned before they are judged; measured points are "
                + "accepted 1.645 µm inside the limits, for a risk of at most 5 % at each.",
            ProfileWords.Of(Guarded, 0.001));
    }

    private static ProfileJudgement Judged(ProfileTolerance tolerance, double uncertainty, params double[] errors) =>
        ProfileJudgement.OfMeasured(tolerance, ProfileJudgementTests.Samples(errors), uncertainty);

    private static string Measured(ProfileTolerance tolerance, double uncertainty, params double[] errors) =>
        ProfileWords.Of(tolerance, [("a.csv", Judged(tolerance, uncertainty, errors))]);
}
