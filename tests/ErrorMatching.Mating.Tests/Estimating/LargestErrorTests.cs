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
        Assert.Equal(expected, LargestError.BoundMm(new double[count], columns, null, 0.05), 0.12);
    }

    // Student's distribution with two and four degrees of freedom: 4.303 and 2.776 (Abramowitz and Stegun, table 26.10). One point more
    // or fewer would be 3.182 or 12.706.
    [Theory]
    [InlineData(3, 4.303, 0.5)]
    [InlineData(5, 2.776, 0.25)]
    public void A_scale_that_few_points_tell_widens_the_bound(int points, double expected, double tolerance) =>
        Assert.Equal(expected, LargestError.BoundMm([0], [[1]], ColumnScale.ToldBy(points), 0.05), tolerance);

    // Errors that are one and the same have the bound of one; an expected error is added on its side.
    [Fact]
    public void What_is_shared_counts_once_and_what_is_expected_in_full()
    {
        double[][] shared = [[1, 1, 1, 1, 1]];
        Assert.Equal(1.960, LargestError.BoundMm(new double[5], shared, null, 0.05), 0.12);
        Assert.Equal(10 + 1.645, LargestError.BoundMm([10, 0, 0, 0, 0], shared, null, 0.05), 0.12);
        Assert.Equal(3, LargestError.BoundMm([1, -3], [], ColumnScale.ToldBy(2), 0.05));
    }
}
