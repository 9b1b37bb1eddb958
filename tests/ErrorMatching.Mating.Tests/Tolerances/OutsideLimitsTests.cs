using ErrorMatching.Geometry;

namespace ErrorMatching.Mating.Tests;

/// <summary>Which points a compensation leaves outside of their limits, and which it drives out itself.</summary>
public sealed class OutsideLimitsTests
{
    // Part - design is 0.09, -0.03, 0.09 in y at 10, 25, 40: a line's mean is 0.05. So counterpart - part is -0.04, 0.08, -0.04
    // afterwards, and was -0.09, 0.03, -0.09. A mating error has the limits of the part with the other sign.
    [Theory]
    [InlineData(-0.05, 0.05, "2", "")]
    [InlineData(-0.03, 0.03, "2", "1 3")]
    [InlineData(-0.02, 0.05, "", "2")]
    [InlineData(-0.1, 0.03, "", "1 3")]
    [InlineData(-0.08, 0.04, "", "")]
    public void A_point_that_the_compensation_drives_out_is_told_from_one_that_was_outside(
        double lower, double upper, string drivenOut, string staying)
    {
        var limits = new ToleranceBand(lower, upper).Opposite();
        var outside = OutsideLimits.Of([
            new("1", limits, -0.09, -0.04),
            new("2", limits, 0.03, 0.08),
            new("3", limits, -0.09, -0.04)]);

        Assert.Equal((drivenOut, staying), (string.Join(' ', outside.DrivenOut), string.Join(' ', outside.Staying)));
    }

    // The same line in a whole match, with limits that no estimate of it can miss. The normal is (0, -1).
    [Theory]
    [InlineData("[-0.05, 0.05]", "2", "")]
    [InlineData("[-0.05, 0.02]", "", "2")]
    public void A_match_says_which_points_stay_outside(string limits, string drivenOut, string staying)
    {
        var report = new MatchCase(Programs.ToolBelow)
        {
            Theoretical = "1 10 0; 2 25 0; 3 40 0",
            Part = "1 10 0.09; 2 25 -0.03; 3 40 0.09",
            Features = [MatchCase.Feature("line", "L1", "N50", """["1..3"]""", $""" "toleranceMm": {limits} """)],
        }.Report();

        Assert.Equal((drivenOut, staying), (string.Join(' ', report.Outside.DrivenOut), string.Join(' ', report.Outside.Staying)));
        Assert.Equal(
            drivenOut.Split(' ').Concat(staying.Split(' ')).Where(p => p.Length > 0).Order(StringComparer.Ordinal), report.Outside.Points);
    }

    [Fact]
    public void A_point_without_limits_is_never_outside()
    {
        var outside = OutsideLimits.Of(
            [
                new("1", null, 0, 5), new("2", new(-0.1, 0.2), 0, 0.2),
                new("3", new(-0.1, 0.2), -0.11, -0.12), new("4", new(-0.1, 0.2), 0.2, 0.21)]);

        Assert.Equal(["3", "4"], outside.Points);
        Assert.Equal(["4"], outside.DrivenOut);
        Assert.Equal(["3"], outside.Staying);
    }
}
