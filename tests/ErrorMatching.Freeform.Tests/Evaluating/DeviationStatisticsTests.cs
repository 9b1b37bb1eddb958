namespace ErrorMatching.Freeform.Tests;

public sealed class DeviationStatisticsTests
{
    [Fact]
    public void Statistics_are_those_worked_out_by_hand()
    {
        // Mean 0.010; squares about it (4 + 1 + 1 + 4) e-6 over 3.
        var s = DeviationStatistics.Of([0.008, 0.009, 0.011, 0.012]);

        Assert.Equal(4, s.Count);
        Assert.Equal(0.010, s.MeanMm, 12);
        Assert.Equal(Math.Sqrt(10e-6 / 3), s.StandardDeviationMm, 12);
        Assert.Equal(0.024, s.ProfileIsoMm, 12);
        Assert.Equal(0.004, s.ProfileRangeMm, 12);
    }

    [Fact]
    public void Profile_is_centred_on_the_nominal_and_not_on_the_mean()
        => Assert.Equal(0.1, DeviationStatistics.Of([-0.05, 0.01]).ProfileIsoMm, 12);

    [Fact]
    public void One_point_has_no_spread() => Assert.Equal(0, DeviationStatistics.Of([0.5]).StandardDeviationMm);
}
