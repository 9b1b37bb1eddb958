namespace ErrorMatching.Nc.Tests;

/// <summary>How far off a result may be: what the rounding of its words explains, and no more.</summary>
public sealed class ToleranceTests
{
    // Both coordinates of an end are rounded by half an increment at most: 0.00071 mm at 45 degrees;
    // three quarters of an increment are allowed.
    [Theory]
    [InlineData("0.10075", true)]
    [InlineData("0.09925", true)]
    [InlineData("0.10076", false)]
    [InlineData("0.09924", false)]
    public void A_displaced_line_may_be_off_by_its_rounding(string y, bool holds)
    {
        const string Before = "G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\nG0 Z5.\n";
        Assert.Equal(holds, Verdict.OnElements(Before, $"G90 G17\nG0 X0. Y{y} Z0.\nN10 G1 X10. Y0.1 F100\nG0 Z5.\n", ("N10", 0.1)).Holds);
        Assert.Equal(holds, Verdict.OnElements(Before, $"G90 G17\nG0 X0. Y0.1 Z0.\nN10 G1 X10. Y{y} F100\nG0 Z5.\n", ("N10", 0.1)).Holds);
    }

    // All that is cut with the feed is named: the block that states it would be found by its bytes alone, the others would not.
    [Fact]
    public void Every_cut_whose_feed_differs_is_named()
    {
        const string Before = "G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\nN20 X20. Y0.\nN30 Y5.\nG0 Z5.\n";
        const string After = "G90 G17\nG0 X0. Y0.1 Z0.\nN10 G1 X10. Y0.1 F100.001\nN20 X20. Y0.\nN30 Y5.\nG0 Z5.\n";

        var failures = Verdict.OnElements(Before, After, ("N10", 0.1)).Failures;
        Assert.Equal([3, 4, 5], failures.Select(f => f.Place.Line).Where(line => line < 6));
        Assert.All(failures, f => Assert.Contains("feed", f.Message, StringComparison.Ordinal));
    }
}
