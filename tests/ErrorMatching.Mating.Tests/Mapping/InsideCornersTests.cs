namespace ErrorMatching.Mating.Tests;

/// <summary>Corners that no tool cuts sharply.</summary>
public sealed class InsideCornersTests
{
    private const string Limits = """ "toleranceMm": [-0.05, 0.05] """;

    // The tool comes along y = 3 and turns up at x = 47: with the material below and to the right, that is an inside corner of (50, 0);
    // with the material above and to the left, the outside one of (44, 6).
    private const string Up = "%\nO1000\nN10 G21 G90 G17\nN20 G0 X0. Y3.\nN50 G1 X47. F300\nN60 Y50.\nN70 G0 Z50.\nN80 M30\n%\n";

    // The round of 3 mm in a right angle: 3 (root 2 - 1) = 1.243 mm from its point; 0.05 mm are left by a diameter of 0.241.
    [Fact]
    public void The_round_in_a_right_angle_is_told()
    {
        var warning = Assert.Single(Report(Up, "1 10 0; 2 40 0; 3 50 10; 4 50 40").Warnings, w => w.Code == "inside-corner");
        Assert.Equal(["N50", "N60", "3", "1.243", "0.241"], warning.Values);
    }

    // The pair says so, too: with a sharp corner it overlaps by as much.
    [Fact]
    public void A_pair_goes_together_only_with_a_rounded_corner()
    {
        var pair = Report(Up, "1 10 0; 2 40 0; 3 50 10; 4 50 40").Pair!;
        Assert.Equal(new("N50", "N60", 1.243), pair.RoundCorners.Select(c => c with { OverlapMm = Math.Round(c.OverlapMm, 3) }).Single());
        const string Condition = "It does so only if the part is rounded in the corner of N50/N60: a sharp one would overlap there by "
            + "1.243 mm.";
        Assert.StartsWith("It goes together", PairWords.Of(pair), StringComparison.Ordinal);
        Assert.EndsWith(Condition, PairWords.Of(pair), StringComparison.Ordinal);
        Assert.DoesNotContain(
            Condition, PairWords.Of(pair with { Assembles = false, TightestMm = -0.1 }), StringComparison.Ordinal);
        Assert.DoesNotContain(
            "rounded", PairWords.Of(Report(Up, "1 10 6; 2 40 6; 3 44 10; 4 44 40").Pair!), StringComparison.Ordinal);
    }

    [Fact]
    public void An_outside_corner_is_cut_sharply() =>
        Assert.DoesNotContain(Report(Up, "1 10 6; 2 40 6; 3 44 10; 4 44 40").Warnings, w => w.Code == "inside-corner");

    // On the round about (47, 3), in its middle: 47 + 3 cos 45.
    [Fact]
    public void A_key_point_on_the_round_tells_it()
    {
        var features = new[] { MatchCase.Feature("line", "L1", "N50", """["1", "2", "5"]""", Limits), Features(Limits)[1] };
        var points = "1 10 0; 2 40 0; 5 49.121 0.879; 3 50 10; 4 50 40";
        var report = new MatchCase(Up) { Theoretical = points, Part = points, Features = features }.Report();
        Assert.DoesNotContain(report.Warnings, w => w.Code == "inside-corner");
    }

    // The relief goes 4 mm further than the corner and comes back.
    [Fact]
    public void A_relieved_corner_is_no_corner()
    {
        var relieved = Up.Replace("N60", "N52 X49. Y1.\nN54 X47. Y3.\nN60", StringComparison.Ordinal);
        Assert.DoesNotContain(Report(relieved, "1 10 0; 2 40 0; 3 50 10; 4 50 40").Warnings, w => w.Code == "inside-corner");
    }

    // A tool of 2 mm leaves 0.414 mm. The counterpart's excess is what the part lacks: the lower limit of the part.
    [Theory]
    [InlineData("[-0.42, 0.1]", 0)]
    [InlineData("[-0.41, 0.5]", 1)]
    public void A_round_that_the_limits_allow_is_none(string limits, int told)
    {
        var match = new MatchCase(Up)
        {
            ToolDiameterMm = 2,
            Theoretical = "1 10 2; 2 40 2; 3 48 10; 4 48 40",
            Part = "1 10 2; 2 40 2; 3 48 10; 4 48 40",
            Features = Features($""" "toleranceMm": {limits} """),
        };
        Assert.Equal(told, match.Report().Warnings.Count(w => w.Code == "inside-corner"));
    }

    private static MatchReport Report(string program, string points) => new MatchCase(program)
    {
        Theoretical = points,
        Part = points,
        Features = Features(Limits),
    }.Report();

    private static string[] Features(string limits) =>
        [MatchCase.Line("L1", "N50", "1", "2", limits), MatchCase.Line("L2", "N60", "3", "4", limits)];
}
