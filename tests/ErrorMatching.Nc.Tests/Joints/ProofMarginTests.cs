namespace ErrorMatching.Nc.Tests;

/// <summary>Results that are wrong by little, or right for every measure but one: each shows that a margin is needed.</summary>
public sealed class ProofMarginTests
{
    [Theory]
    [InlineData("Y0.101", false)]
    [InlineData("Y0.099", false)]
    [InlineData("Y0.1", true)]
    public void A_line_that_lies_one_increment_aside_is_not_proved(string place, bool holds)
    {
        const string Good = "G90 G17\nG0 X0. Y0.1 Z0.\nN10 G1 X10. Y0.1 F100\nG0 Z5.\n";
        var path = Bench.Read("G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\nG0 Z5.\n");
        var wish = Bench.Usable(DisplacementWish.Normal(path, Bench.Blocks(path, "N10"), 0.1));

        var result = NcProgram.FromText(Good.Replace("Y0.1", place, StringComparison.Ordinal));
        Assert.Equal(holds, Prover.Check(path, result, wish, 0.001).Holds);
    }

    // The line y = -0.02 meets the circle of 0.98 about (0, -0.966) at x = -0.256 and x = 0.256: both crossings are on both elements.
    [Theory]
    [InlineData("X-0.256 Y-0.02", "I0.256 J-0.946", true)]
    [InlineData("X0.256 Y-0.02", "I-0.256 J-0.946", false)]
    public void A_corner_at_the_other_crossing_is_not_proved(string corner, string center, bool holds)
    {
        var path = Bench.Read("G90 G17\nG0 X-5. Y0. Z0.\nN10 G1 X-0.259 Y0. F100\nN20 G2 X1. Y-0.966 I0.259 J-0.966\nG0 Z5.\n");
        var wish = Bench.Usable(DisplacementWish.Normal(path, Bench.Blocks(path, "N10..N20"), -0.02));
        var result = NcProgram.FromText($"G90 G17\nG0 X-5. Y-0.02 Z0.\nN10 G1 {corner} F100\nN20 G2 X0.98 Y-0.966 {center}\nG0 Z5.\n");

        Assert.Equal(holds, Prover.Check(path, result, wish, 0.001).Holds);
    }

    [Fact]
    public void A_ring_whose_ends_part_inside_a_run_is_not_proved()
    {
        // The ring N2 to N5 is a square of 20 to the left of travel, with leads along x = 10 and y = -10 that come from outside.
        const string Head = "G90 G17\nG0 X9.9 Y-15. Z0.\nG1 Z-1. F100\nN1 X9.9 Y-9.9\n";
        var path = Bench.Read(
            "G90 G17\nG0 X10. Y-15. Z0.\nG1 Z-1. F100\nN1 X10. Y-10.\nN2 X10. Y10.\n"
            + "N3 X-10. Y10.\nN4 X-10. Y-10.\nN5 X10. Y-10.\nG0 Z5.\n");
        var wish = Bench.Usable(DisplacementWish.Normal(path, Bench.Blocks(path, "N1..N5"), 0.1));
        const string Ring = "N2 X9.9 Y9.9\nN3 X-9.9 Y9.9\nN4 X-9.9 Y-9.9\n";

        Assert.True(Prover.Check(path, NcProgram.FromText($"{Head}{Ring}N5 X9.9 Y-9.9\nG0 Z5.\n"), wish, 0.001).Holds);
        Assert.False(Prover.Check(path, NcProgram.FromText($"{Head}{Ring}N5 X10. Y-9.9\nG0 Z5.\n"), wish, 0.001).Holds);
    }
}
