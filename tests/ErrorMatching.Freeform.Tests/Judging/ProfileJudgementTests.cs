using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform.Tests;

public sealed class ProfileJudgementTests
{
    private static readonly ProfileTolerance Tolerance = new(0.02, DecisionRule.Simple, false);

    // ISO 1101: the zone is t wide and centered, so that a point may be t / 2 to either side.
    [Theory]
    [InlineData(0.01, ProfileCode.Within)]
    [InlineData(-0.01, ProfileCode.Within)]
    [InlineData(0.01000001, ProfileCode.Outside)]
    [InlineData(-0.01000001, ProfileCode.Outside)]
    public void A_point_may_be_half_the_width_off_to_either_side(double error, ProfileCode code)
    {
        var judged = ProfileJudgement.OfMeasured(Tolerance, Samples(0.001, error, -0.002), 0.0005);
        Assert.Equal((code, 2 * Math.Abs(error), 2, error), (judged.Code, judged.ProfileMm, judged.WorstPoint, judged.WorstMm));
        Assert.Equal(code == ProfileCode.Outside ? [2] : [], judged.Outside);
        Assert.Null(judged.WorstAnywhereMm);
    }

    // The normal quantile of 95 % is 1.6448536: the guard bands of u = 1 um leave 8.3551464 um.
    [Theory]
    [InlineData(0.0083551, ProfileCode.Within)]
    [InlineData(0.0083552, ProfileCode.NotAccepted)]
    [InlineData(-0.0083551, ProfileCode.Within)]
    [InlineData(-0.0083552, ProfileCode.NotAccepted)]
    [InlineData(0.0100001, ProfileCode.Outside)]
    public void A_guard_band_accepts_only_inside_of_it(double error, ProfileCode code)
    {
        var judged = ProfileJudgement.OfMeasured(Tolerance with { Rule = DecisionRule.GuardBand(5) }, Samples(error, 0), 0.001);
        Assert.Equal((code, code == ProfileCode.Within), (judged.Code, judged.IsWithin));
        Assert.Equal(code == ProfileCode.NotAccepted ? [1] : [], judged.NotAccepted);
    }

    // P(|x| < u) = 0.6826894921 for one point at the center; a point on a limit that is 20 u wide: a half.
    [Theory]
    [InlineData(new[] { 0.0 }, 0.01, 0.6826894921)]
    [InlineData(new[] { 0.0, 0.0 }, 0.01, 0.4660649427)]
    [InlineData(new[] { 0.01, 0.0 }, 0.001, 0.5)]
    [InlineData(new[] { 0.005, -0.008, 0.0 }, 0.001, 0.9772495879)]
    public void The_probability_is_the_product_of_those_of_the_points(double[] errors, double uncertainty, double expected)
    {
        Assert.Equal(expected, ProfileJudgement.OfMeasured(Tolerance, Samples(errors), uncertainty).Probability, 9);
        Assert.Equal(expected, Predicted(Tolerance, errors, uncertainty).Probability, 9);
    }

    // 70 points without systematic error: each must be inside with 0.5^(1/70) = 0.9901468 for one half, which are 2.580938 u, and with
    // 0.95^(1/70) = 0.9992675 for 95 %, which are 3.377119 u.
    [Theory]
    [InlineData(false, 2.5809, ProfileCode.NotAccepted)]
    [InlineData(false, 2.5810, ProfileCode.Within)]
    [InlineData(true, 3.3771, ProfileCode.NotAccepted)]
    [InlineData(true, 3.3772, ProfileCode.Within)]
    public void A_predicted_surface_must_be_probable_enough(bool isGuarded, double times, ProfileCode code)
    {
        var tolerance = Tolerance with { Rule = isGuarded ? DecisionRule.GuardBand(5) : DecisionRule.Simple };
        Assert.Equal(code, Predicted(tolerance, new double[70], 0.01 / times).Code);
    }

    [Theory]
    [InlineData(0.0099, 0.01, ProfileCode.Within, 0.01)]
    [InlineData(0.0099, -0.0100001, ProfileCode.OutsideBetween, -0.0100001)]
    [InlineData(0.0100001, -0.02, ProfileCode.Outside, -0.02)]
    public void A_predicted_place_between_the_points_must_be_in_the_zone_too(
        double error, double between, ProfileCode code, double anywhere)
    {
        var judged = Predicted(Tolerance, [error, 0], 1e-7, 0.001, between, -0.002);
        Assert.Equal((code, anywhere), (judged.Code, judged.WorstAnywhereMm));
    }

    [Fact]
    public void A_prediction_states_the_profile_that_a_measurement_is_expected_to_find()
    {
        var judged = Predicted(Tolerance, [0.001, -0.002], 0.001);
        Assert.Equal((0.005, -0.002, 2, null), (judged.ProfileMm, judged.WorstMm, judged.WorstPoint, judged.WorstAnywhereMm));
    }

    internal static ErrorSample[] Samples(params double[] errors) =>
        [.. errors.Select((e, k) => new ErrorSample(k + 1, k, 0, 0, 0, default, new(0, 0, 1), e))];

    internal static ProfileJudgement Predicted(
        ProfileTolerance tolerance, double[] errors, double uncertainty, params double[] anywhere) =>
        ProfileJudgement.OfPredicted(tolerance, Samples(errors), errors, 0.005, uncertainty, anywhere);
}
