namespace ErrorMatching.Mating.Tests;

/// <summary>How large the largest of many errors may be.</summary>
public sealed class LargestErrorTests
{
    // Of one error 95 % are within 1.960 standard deviations; all of ten independent ones within 2.800, where each is with 0.95^(1/10)
    // (Abramowitz and Stegun, table 26.1).
    [Theory]
    [InlineData(1, 1.960)]
    [InlineData(10, 2.800)]
    public void Independent_errors_have_their_quantile(int count, double expected)
    {
        double[][] columns = [
            .. Enumerable.Range(0, count).Select(k => Enumerable.Range(0, count).Select(i => i == k ? 1.0 : 0).ToArray())];
        Assert.Equal(expected, LargestError.BoundMm(new double[count], columns, 1000, 0.05), 0.12);
    }

    // Student's distribution with four degrees of freedom: 2.776 (Abramowitz and Stegun, table 26.10).
    [Fact]
    public void A_scale_that_few_values_tell_widens_the_bound() =>
        Assert.Equal(2.776, LargestError.BoundMm([0], [[1]], 4, 0.05), 0.25);

    // Errors that are one and the same have the bound of one; an expected error is added on its side.
    [Fact]
    public void What_is_shared_counts_once_and_what_is_expected_in_full()
    {
        double[][] shared = [[1, 1, 1, 1, 1]];
        Assert.Equal(1.960, LargestError.BoundMm(new double[5], shared, 1000, 0.05), 0.12);
        Assert.Equal(10 + 1.645, LargestError.BoundMm([10, 0, 0, 0, 0], shared, 1000, 0.05), 0.12);
        Assert.Equal(3, LargestError.BoundMm([1, -3], [], 1, 0.05));
    }
}
