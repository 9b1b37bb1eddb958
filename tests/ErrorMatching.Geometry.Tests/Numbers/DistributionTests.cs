namespace ErrorMatching.Geometry.Tests.Numbers;

/// <summary>The judge is mpmath, as for <see cref="ElementaryTests"/>.</summary>
public class DistributionTests
{
    [Fact]
    public void Probabilities_of_the_normal_distribution_have_13_digits() =>
        Agree("NormalBelow", (z, _) => NormalDistribution.Below(z), 13, 5e-14);

    [Fact]
    public void Quantiles_of_the_normal_distribution_have_14_digits_after_the_point() =>
        Assert.All(ElementaryValues.Of("NormalQuantile"), v => Assert.Equal(v.Value.ToDouble(), NormalDistribution.Quantile(v.X), 5e-15));

    [Fact]
    public void Probabilities_of_sums_of_squares_have_12_digits() =>
        Agree("ChiSquaredAbove", (x, values) => ChiSquaredDistribution.Above(x, (int)values), 15, 5e-13);

    [Fact]
    public void Limits_are_certain()
    {
        Assert.Equal((0.0, 0.5, 1.0), (
            NormalDistribution.Below(double.NegativeInfinity),
            NormalDistribution.Below(0),
            NormalDistribution.Below(double.PositiveInfinity)));
        Assert.Equal((double.NegativeInfinity, 0.0, double.PositiveInfinity), (
            NormalDistribution.Quantile(0), NormalDistribution.Quantile(0.5), NormalDistribution.Quantile(1)));
        Assert.Equal((1.0, 1.0), (ChiSquaredDistribution.Above(0, 1), ChiSquaredDistribution.Above(0, 8)));
    }

    [Fact]
    public void What_is_no_probability_and_no_sum_of_squares_is_refused()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => NormalDistribution.Quantile(1.5));
        Assert.Throws<ArgumentOutOfRangeException>(() => NormalDistribution.Quantile(double.NaN));
        Assert.Throws<ArgumentOutOfRangeException>(() => ChiSquaredDistribution.Above(-1, 3));
        Assert.Throws<ArgumentOutOfRangeException>(() => ChiSquaredDistribution.Above(1, 0));
    }

    private static void Agree(string name, Func<double, double, double> function, int rows, double relative)
    {
        var values = ElementaryValues.Of(name);
        Assert.Equal(rows, values.Count);
        Assert.All(values, v => Assert.Equal(1, function(v.X, v.Y) / v.Value.ToDouble(), relative));
    }
}
