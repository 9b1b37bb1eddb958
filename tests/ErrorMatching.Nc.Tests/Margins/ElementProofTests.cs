using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

/// <summary>Named elements that are right at their ends and wrong between, or the wrong way round.</summary>
public sealed class ElementProofTests
{
    // A quarter of radius 10 about (0, 0), and a whole turn, which both go by (0.1, 0.2): start, middle and end alike.
    // A center that is 0.01 off along the middle's ray leaves the ends right and the middle 0.414 * 0.01 off.
    [Theory]
    [InlineData("X0. Y10.", "X0.1 Y10.2 I-10. J0.", true)]
    [InlineData("X0. Y10.", "X0.1 Y10.2 I-9.99 J0.01", false)]
    [InlineData("X10. Y0.", "X10.1 Y0.2 I-10. J0.", true)]
    [InlineData("X10. Y0.", "X10.1 Y0.2 I-10. J0.005", false)]
    [InlineData("X10. Y0.", "X10.1 Y0.2 I-10.005 J0.", false)]
    public void An_arc_that_goes_by_a_vector_takes_its_center_along(string end, string result, bool holds)
    {
        var before = $"G90 G17\nG0 X10. Y0. Z0.\nN10 G3 {end} I-10. J0. F100\nG0 Z5.\n";
        var after = $"G90 G17\nG0 X10.1 Y0.2 Z0.\nN10 G3 {result} F100\nG0 Z5.\n";
        var path = Bench.Read(before);
        var by = new Vector2(0.1, 0.2);
        var wish = DisplacementWish.OfElements([new(path.MotionOf(Bench.Blocks(path, "N10")[0]), by, by, by)]);

        Assert.Equal(holds, Prover.Check(path, NcProgram.FromText(after), wish, 0.001).Holds);
    }

    [Fact]
    public void An_arc_that_would_vanish_is_not_proved()
    {
        const string Before = "G90 G17\nG0 X10. Y0. Z0.\nN10 G3 X0. Y10. I-10. J0. F100\nG0 Z5.\n";
        var failures = Verdict.OnElements(Before, Before, ("N10", 10)).Failures;

        Assert.Contains(failures, f => f.Message.Contains("no circle runs", StringComparison.Ordinal));
    }

    // Half a millimeter long, it may go 1.302 mm: far enough for its ends to change places on the right line.
    [Fact]
    public void A_line_that_turned_round_is_not_proved()
    {
        const string Before = "G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X0.5 Y0. F100\nG0 Z5.\n";
        const string After = "G90 G17\nG0 X0.5 Y0.1 Z0.\nN10 G1 X0. Y0.1 F100\nG0 Z5.\n";
        var failures = Verdict.OnElements(Before, After, ("N10", 0.1)).Failures;

        Assert.Contains(failures, f => f.Message.Contains("turned round", StringComparison.Ordinal));
    }

    // Two millimeters long and shrunk to its middle, which nothing explains: it goes neither way.
    [Fact]
    public void A_line_that_shrank_to_a_point_goes_no_way() =>
        Assert.Equal(
            [
                "N10: it turned round.",
                "N10: an end moved by (1.000, 0.100), where neither the wish nor a neighbor puts it.",
                "N10: an end moved by (-1.000, 0.100), where neither the wish nor a neighbor puts it.",
            ],
            Messages(Verdict.OnElements(
                "G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X2. Y0. F100\nG0 Z5.\n",
                "G90 G17\nG0 X1. Y0.1 Z0.\nN10 G1 X1. Y0.1 F100\nG0 Z5.\n",
                ("N10", 0.1))));

    // A center that is d higher is d off at the arc's end, 0.92 d at its last quarter but one. 1.6 increments are allowed.
    [Theory]
    [InlineData("J0.0015")]
    [InlineData("J0.0017", "N10: it lies 0.0017 mm from where it was wanted.")]
    public void An_arc_is_measured_at_its_end_too(string center, params string[] found) =>
        Assert.Equal(
            found,
            Messages(Verdict.OnElements(
                "G90 G17\nG0 X10. Y0. Z0.\nN10 G3 X0. Y10. I-10. J0. F100\nG0 Z5.\n",
                $"G90 G17\nG0 X9.9 Y0. Z0.\nN10 G3 X0. Y9.901 I-9.9 {center} F100\nG0 Z5.\n",
                ("N10", 0.1))));

    // Its radius is 10 at its start and 9.997 at its end. As much is allowed in addition.
    [Theory]
    [InlineData("J0.", true)]
    [InlineData("J-0.0045", true)]
    [InlineData("J-0.0047", false)]
    public void An_arc_may_be_off_by_the_difference_of_its_radii(string center, bool holds) =>
        Assert.Equal(
            holds,
            Verdict.OnElements(
                "G90 G17\nG0 X10. Y0. Z0.\nN10 G3 X0. Y9.997 I-10. J0. F100\nG0 Z5.\n",
                $"G90 G17\nG0 X9.9 Y0. Z0.\nN10 G3 X0. Y9.897 I-9.9 {center} F100\nG0 Z5.\n",
                ("N10", 0.1)).Holds);

    // Displaced by 0.1 at its start and middle and by 0.104 at its end, the circle through these three places lies about
    // (0.0068, 0.0028).
    [Theory]
    [InlineData("I-9.8932 J0.0028", true)]
    [InlineData("I-9.9 J0.", false)]
    public void An_arc_with_another_wish_at_its_end_passes_through_three_places(string center, bool holds)
    {
        var path = Bench.Read("G90 G17\nG0 X10. Y0. Z0.\nN10 G3 X0. Y10. I-10. J0. F100\nG0 Z5.\n");
        var result = NcProgram.FromText($"G90 G17\nG0 X9.9 Y0. Z0.\nN10 G3 X0. Y9.896 {center} F100\nG0 Z5.\n");
        var wish = ElementWish.AlongNormals(path, path.MotionOf(Bench.Blocks(path, "N10")[0]), 0.1, 0.1, 0.104);

        Assert.Equal(holds, Prover.Check(path, result, DisplacementWish.OfElements([wish]), 0.001).Holds);
    }

    // A circle of two turns, whose center went aside: where it passes its start does not show it.
    [Theory]
    [InlineData("J0.", true)]
    [InlineData("J0.02", false)]
    [InlineData("J-0.02", false)]
    public void A_circle_of_several_turns_is_measured_within_one(string center, bool holds)
    {
        var path = Bench.Read("G90 G17 G21\nG0 X10. Y0. Z0.\nN10 G3 X10. Y0. Z-4. I-10. J0. P2 F100\nG0 Z5.\n", NcDialects.LinuxCnc);
        var wish = Bench.Usable(DisplacementWish.Normal(path, Bench.Blocks(path, "N10"), 0.1));
        var result = $"G90 G17 G21\nG0 X9.9 Y0. Z0.\nN10 G3 X9.9 Y0. Z-4. I-9.9 {center} P2 F100\nG0 Z5.\n";

        Assert.Equal(holds, Prover.Check(path, NcProgram.FromText(result, path.Dialect.Syntax), wish, 0.001).Holds);
    }

    // Nobody knows in which direction it leaves its center.
    [Theory]
    [InlineData("X0. Y10. I0. J0.")]
    [InlineData("X0. Y10. I-10. J10.")]
    public void An_arc_that_begins_or_ends_in_its_own_center_is_not_proved(string words)
    {
        var path = Bench.Read($"G90 G17\nG0 X10. Y0. Z0.\nN10 G3 {words} F100\nN20 G1 X20. Y20.\nG0 Z5.\n");
        var by = new Vector2(0.1, 0);
        var wish = DisplacementWish.OfElements(
            [.. Bench.Blocks(path, "N10..N20").Select(b => new ElementWish(path.MotionOf(b), by, by, by))]);

        Assert.Contains("N10: no circle runs where it was wanted.", Messages(Prover.Check(path, path.Program, wish, 0.001)));
    }

    // N10 stays and N20 goes by 0.125, so that an end may go by 13 * 0.125 mm and two increments of 1/1024 mm: all exact in binary.
    [Theory]
    [InlineData("X11.626953125", false)]
    [InlineData("X11.626953126", true)]
    public void An_end_may_go_as_far_as_the_flattest_corner_needs(string end, bool isFound)
    {
        const string Before = "G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\nN20 X20. Y0.\nG0 Z5.\n";
        var path = Bench.Read(Before);
        var wishes = new[] { ("N10", 0.0), ("N20", 0.125) }.Select(
            w => ElementWish.AlongNormals(path, path.MotionOf(Bench.Blocks(path, w.Item1)[0]), w.Item2, w.Item2, w.Item2));
        var result = NcProgram.FromText(Before.Replace("X10.", end, StringComparison.Ordinal));
        var found = Messages(Prover.Check(path, result, DisplacementWish.OfElements([.. wishes]), 1.0 / 1024));

        Assert.Equal(isFound, found.Any(f => f.StartsWith("N10: an end went", StringComparison.Ordinal)));
    }

    private static string[] Messages(NcProof proof) => [.. proof.Failures.Select(f => f.Message)];
}
