using ErrorMatching.Geometry;

namespace ErrorMatching.Mating.Tests;

public sealed class ChainTests
{
    [Fact]
    public void Worst_case_adds_the_limits_and_exchanges_those_of_shortening_dimensions()
    {
        var chain = new ToleranceChain([new("housing", 17.5, new(-0.02, 0.03), 1), new("cover", 5, new(-0.01, 0.04), -1)]);

        var dimension = chain.WorstCase();

        // 17.5 - 0.02 - (5 + 0.04) and 17.5 + 0.03 - (5 - 0.01).
        Assert.Equal(12.5, dimension.NominalMm, 12);
        Assert.Equal(12.44, dimension.SmallestMm, 12);
        Assert.Equal(12.54, dimension.LargestMm, 12);
        Assert.Equal(-0.06, dimension.Band.LowerMm, 12);
        Assert.Equal(0.04, dimension.Band.UpperMm, 12);
    }

    [Fact]
    public void Root_sum_of_squares_adds_the_middles_and_the_squares_of_half_the_widths()
    {
        var chain = new ToleranceChain([new("a", 10, new(-0.02, 0.04), 1), new("b", 4, new(-0.03, 0.05), -1)]);

        var dimension = chain.RootSumOfSquares();

        // Middles 0.01 and 0.01 cancel; half widths 0.03 and 0.04 make 0.05.
        Assert.Equal(6, dimension.NominalMm, 12);
        Assert.Equal(5.95, dimension.SmallestMm, 12);
        Assert.Equal(6.05, dimension.LargestMm, 12);
    }

    [Fact]
    public void Root_sum_of_squares_keeps_a_middle_that_is_off()
    {
        var band = new ToleranceChain([new("a", 10, new(0, 0.04), 1)]).RootSumOfSquares().Band;

        Assert.Equal(0, band.LowerMm, 12);
        Assert.Equal(0.04, band.UpperMm, 12);
    }

    [Theory]
    [InlineData(-0.05, 0)]
    [InlineData(0.05, 0)]
    [InlineData(0, 0)]
    [InlineData(0.07, 0.02)]
    [InlineData(-0.08, -0.03)]
    public void Excess_is_what_lies_beyond_the_limit(double deviation, double excess)
    {
        var band = new ToleranceBand(-0.05, 0.05);

        Assert.Equal(excess, band.ExcessOf(deviation), 12);
        Assert.Equal(excess == 0, band.Contains(deviation));
    }

    [Fact]
    public void A_deviation_on_its_limit_is_inside_in_spite_of_binary_fractions()
    {
        // 48.050 - 48.000 is 0.04999999999999716 and 48.1 - 48.05 is 0.05000000000000426.
        Assert.True(new ToleranceBand(-0.05, 0.05).Contains(48.1 - 48.05));
        Assert.False(new ToleranceBand(-0.05, 0.05).Contains(0.050001));
    }

    [Fact]
    public void Reversed_or_infinite_limits_are_refused()
    {
        Assert.Throws<ArgumentException>(() => new ToleranceBand(0.05, -0.05));
        Assert.Throws<ArgumentException>(() => new ToleranceBand(double.NaN, 0));
        Assert.Throws<ArgumentException>(() => new ToleranceBand(0, double.PositiveInfinity));
    }

    [Fact]
    public void The_papers_uncertainty_budget_is_5_4_micrometres()
    {
        var budget = new UncertaintyBudget(
            [new("probing", 0.0006), new("re-mastering and temperature", 0.002), new("loading and clamping", 0.005)]);

        // sqrt(0.36 + 4 + 25) um.
        Assert.Equal(0.005418487, budget.CombinedMm, 9);
    }

    [Fact]
    public void The_papers_measuring_time_is_8_seconds()
    {
        Assert.Equal(8, new MeasuringTime(10, 5, 1).TotalS(14));
        Assert.Equal(0.5, new MeasuringTime(10, 5, 0.5).TotalS(0));
        Assert.Throws<ArgumentOutOfRangeException>(() => MeasuringTime.Default.TotalS(-1));
    }
}
