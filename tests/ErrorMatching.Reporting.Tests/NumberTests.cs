using System.Globalization;

namespace ErrorMatching.Reporting.Tests;

public sealed class NumberTests
{
    [Theory]
    [InlineData(0, 75, 7, new[] { 0.0, 20, 40, 60 })]
    [InlineData(-0.31, 0.2, 5, new[] { -0.2, 0, 0.2 })]
    [InlineData(0.1, 0.3, 2, new[] { 0.1, 0.2, 0.3 })]
    [InlineData(11, 19, 1, new double[0])]
    public void Ticks_are_multiples_of_a_round_step_with_both_ends(double low, double high, int most, double[] ticks) =>
        Assert.Equal(ticks, RoundTicks.Within(low, high, most));

    [Theory]
    [InlineData(0.00099, "less than 0.1 %")]
    [InlineData(0.001, "0.1 %")]
    [InlineData(0.5, "50.0 %")]
    [InlineData(0.999, "99.9 %")]
    [InlineData(0.9991, "more than 99.9 %")]
    public void A_probability_is_never_none_and_never_all(double probability, string text) =>
        Assert.Equal(text, ReportNumber.Probability(probability));

    [Theory]
    [InlineData(1, "1")]
    [InlineData(2, "1 and 2")]
    [InlineData(6, "1, 2, 3, 4, 5 and 6")]
    [InlineData(8, "1, 2, 3, 4, 5, 6 and 2 more")]
    public void Many_names_are_counted(int count, string text) =>
        Assert.Equal(text, ReportNames.Of([.. Enumerable.Range(1, count).Select(ReportNumber.Count)]));

    [Theory]
    [InlineData(0, "0")]
    [InlineData(-0.004, "0")]
    [InlineData(0.005, "0")]
    [InlineData(0.015, "0.02")]
    [InlineData(12, "12")]
    [InlineData(-12.5, "-12.5")]
    [InlineData(820.049, "820.05")]
    [InlineData(-0.07, "-0.07")]
    [InlineData(999999999999.99, "999999999999.99")]
    [InlineData(-3e15, "-3000000000000000")]
    public void Coordinates_have_two_decimals_and_no_zeros_behind(double value, string text)
    {
        Assert.Equal(text, SvgNumber.Of(value));
        Assert.Equal($"{text},{text}", SvgNumber.Point(value, value));
    }

    [Fact]
    public void Coordinates_are_those_that_the_runtime_formats()
    {
        var random = new Random(7);
        for (var k = 0; k < 20_000; k++)
        {
            // Halves of a hundredth among them.
            var value = k % 3 == 0 ? random.Next(-100_000, 100_000) / 200.0 : (random.NextDouble() - 0.5) * Math.Pow(10, k % 9);
            var expected = (Math.Round(value, 2) + 0.0).ToString("0.##", CultureInfo.InvariantCulture);

            Assert.Equal(expected, SvgNumber.Of(value));
        }
    }
}
