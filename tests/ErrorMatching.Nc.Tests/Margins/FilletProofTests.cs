namespace ErrorMatching.Nc.Tests;

/// <summary>
/// The arc N20 of radius 5 rounds the corner of N10, which goes 0.1 mm to the left, and N30, which goes 0.3 mm: to y = 0.1 and x = 14.7. Its radius
/// changes by the mean of the two, to 4.8; so it lies about (9.9, 4.9) and touches the lines at (9.9, 0.1) and (14.7, 4.9).
/// </summary>
public sealed class FilletProofTests
{
    private const string Before = "G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\nN20 G3 X15. Y5. I0. J5.\nN30 G1 X15. Y15.\nG0 Z5.\n";
    private const string After = "G90 G17\nG0 X0. Y0.1 Z0.\nN10 G1 X9.9 Y0.1 F100\nN20 G3 X14.7 Y4.9 I0. J4.8\nN30 G1 X14.7 Y15.\nG0 Z5.\n";

    // The same corner from its end to its start, with the material on the other side.
    private const string BeforeClockwise = "G90 G17\nG0 X15. Y15. Z0.\nN30 G1 X15. Y5. F100\nN20 G2 X10. Y0. I-5. J0.\nN10 G1 X0. Y0.\nG0 Z5.\n";
    private const string AfterClockwise = "G90 G17\nG0 X14.7 Y15. Z0.\nN30 G1 X14.7 Y4.9 F100\nN20 G2 X9.9 Y0.1 I-4.8 J0.\nN10 G1 X0. Y0.1\nG0 Z5.\n";

    // A corner of 270 degrees: the lines cross at (0, 0) behind the arc's start and before its end, the arc of radius 5 lies about (5, -5).
    private const string BeforeLoop = "G90 G17\nG0 X-10. Y0. Z0.\nN10 G1 X5. Y0. F100\nN20 G2 X0. Y-5. I0. J-5.\nN30 G1 X0. Y10.\nG0 Z5.\n";
    private const string AfterLoop = "G90 G17\nG0 X-10. Y0.1 Z0.\nN10 G1 X5. Y0.1 F100\nN20 G2 X-0.3 Y-5.2 I0. J-5.3\nN30 G1 X-0.3 Y10.\nG0 Z5.\n";

    [Fact]
    public void A_fillet_is_where_both_lines_and_its_radius_put_it()
    {
        Assert.Empty(Verdict.OnElements(Before, After, ("N10", 0.1), ("N30", 0.3)).Failures);
        Assert.Empty(Verdict.OnElements(BeforeClockwise, AfterClockwise, ("N10", -0.1), ("N30", -0.3)).Failures);
    }

    // To the left of both lines lies the outside of a clockwise arc: its radius grows by 0.2 to 5.2. It touches y = 0.1 and x = -0.3 about (4.9, -5.1).
    [Fact]
    public void A_fillet_of_more_than_half_a_turn_is_measured_alike()
    {
        var good = AfterLoop.Replace("X5. Y0.1", "X4.9 Y0.1", StringComparison.Ordinal)
            .Replace("X-0.3 Y-5.2 I0. J-5.3", "X-0.3 Y-5.1 I0. J-5.2", StringComparison.Ordinal);

        Assert.Empty(Verdict.OnElements(BeforeLoop, good, ("N10", 0.1), ("N30", 0.3)).Failures);
        Assert.False(Verdict.OnElements(BeforeLoop, AfterLoop, ("N10", 0.1), ("N30", 0.3)).Holds);
    }

    // Where it touches counts to the rounding of a word: the circle is the right one in all of these.
    [Theory]
    [InlineData("X9.9 Y0.1 F100", "X9.9007 Y0.1 F100", "I0. J4.8", "I-0.0007 J4.8", true)]
    [InlineData("X9.9 Y0.1 F100", "X9.9008 Y0.1 F100", "I0. J4.8", "I-0.0008 J4.8", false)]
    [InlineData("X9.9 Y0.1 F100", "X9.8993 Y0.1 F100", "I0. J4.8", "I0.0007 J4.8", true)]
    [InlineData("X9.9 Y0.1 F100", "X9.8992 Y0.1 F100", "I0. J4.8", "I0.0008 J4.8", false)]
    [InlineData("X14.7 Y4.9", "X14.7 Y4.9007", "I0.", "I0.", true)]
    [InlineData("X14.7 Y4.9", "X14.7 Y4.9008", "I0.", "I0.", false)]
    [InlineData("X14.7 Y4.9", "X14.7 Y4.8993", "I0.", "I0.", true)]
    [InlineData("X14.7 Y4.9", "X14.7 Y4.8992", "I0.", "I0.", false)]
    public void A_tangent_point_is_held_to_the_rounding(string was, string now, string wasCenter, string nowCenter, bool holds)
    {
        var result = After.Replace(was, now, StringComparison.Ordinal).Replace(wasCenter, nowCenter, StringComparison.Ordinal);

        Assert.Equal(holds, Verdict.OnElements(Before, result, ("N10", 0.1), ("N30", 0.3)).Holds);
    }

    // A circle that touches both lines, but whose radius is an increment or two off, or that took the change of one line only.
    [Theory]
    [InlineData(4.799)]
    [InlineData(4.801)]
    [InlineData(4.7)]
    [InlineData(4.9)]
    public void A_fillet_of_another_radius_that_touches_both_lines_is_not_proved(double radius)
    {
        var result = FormattableString.Invariant(
            $"G90 G17\nG0 X0. Y0.1 Z0.\nN10 G1 X{14.7 - radius:0.0##} Y0.1 F100\nN20 G3 X14.7 Y{0.1 + radius:0.0##} I0. J{radius:0.0##}\n")
            + "N30 G1 X14.7 Y15.\nG0 Z5.\n";

        Assert.False(Verdict.OnElements(Before, result, ("N10", 0.1), ("N30", 0.3)).Holds);
    }

    // An arc that leaves its line by 2.8 degrees rounds a corner, at 3.0 degrees it does not: then it follows its ends, about another center.
    [Theory]
    [InlineData(2.8, true)]
    [InlineData(3.0, false)]
    public void An_arc_is_a_fillet_as_long_as_it_leaves_its_line_tangentially(double degrees, bool isFillet)
    {
        var (sine, cosine) = Math.SinCos(degrees * Math.PI / 180);
        var before = FormattableString.Invariant($"G90 G17\nG0 X{-10 * cosine:0.000000} Y{-10 * sine:0.000000} Z0.\nN10 G1 X0. Y0. F100\n")
            + "N20 G3 X5. Y5. I0. J5.\nN30 G1 X5. Y15.\nG0 Z5.\n";
        var path = Bench.Read(before);
        var elements = new[] { "N10", "N30" }.Select(b => ElementWish.AlongNormals(path, path.MotionOf(Bench.Blocks(path, b)[0]), 0.1, 0.1, 0.1));
        var wish = DisplacementWish.OfElements([.. elements]);
        var proof = Prover.Check(path, Bench.Usable(Rewriter.Apply(path, wish)).Program, wish, 0.001);

        Assert.Empty(proof.Failures);
        Assert.Equal(isFillet ? NeighborRole.Fillet : NeighborRole.Follows, proof.Neighbors.Single(n => n.Block == "N20").Role);
    }
}
