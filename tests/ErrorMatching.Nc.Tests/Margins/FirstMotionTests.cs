using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

/// <summary>Programs that set their origin where the tool is, and so begin with a cut or a move along the tool axis at a known
/// place.</summary>
public sealed class FirstMotionTests
{
    private const string Head = "G90 G17 G92 X0. Y0. Z0.\n";
    private const string Unnamed = "it moved although neither it nor a motion beside it was named.";
    private const string Way = "a move along the tool axis now moves in the plane or ends at another height.";

    // The ring begins where the program begins, and that place cannot move.
    [Theory]
    [InlineData("")]
    [InlineData("G1 X0. Y0. F100\n")]
    public void A_ring_from_the_first_place_closes_there(string point)
    {
        var before = Head + point + "N10 G1 X10. Y0. F100\nN20 X10. Y10.\nN30 X0. Y10.\nN40 X0. Y0.\nG0 Z5.\n";
        var after = before.Replace("N30 X0.", "N30 X0.1", StringComparison.Ordinal)
            .Replace("N40 X0.", "N40 X0.1", StringComparison.Ordinal);
        var line = point.Length == 0 ? 5 : 6;

        Assert.Equal([$"{line} N40: the contour no longer closes."], Verdict.Found(Verdict.OnElements(before, after, ("N40", 0.1))));

        // Its wish is to end further along its own line, but N10 goes through the first place.
        Assert.Empty(Verdict.OnVectors(before, before, ("N40", Vector2.Zero, new(0, 0.05))).Failures);
    }

    // N20 rises by 45 degrees. Its start slides along N10 by 0.1 times the root of 2.
    [Fact]
    public void The_first_cut_holds_the_start_of_the_second()
    {
        const string Before = Head + "N10 G1 X10. Y0. F100\nN20 X20. Y10.\nG0 Z5.\n";
        const string After = Head + "N10 G1 X9.8586 Y0. F100\nN20 X19.9293 Y10.0707\nG0 Z5.\n";

        Assert.Empty(Verdict.OnElements(Before, After, ("N20", 0.1)).Failures);
    }

    // N10 shrank to a point, so it holds nothing.
    [Fact]
    public void A_first_cut_that_shrank_holds_nothing()
    {
        const string Before = Head + "N10 G1 X0.1 Y0. F100\nN20 X0.1 Y10.\nG0 Z5.\n";
        const string After = Head + "N10 G1 X0. Y0. F100\nN20 X0. Y10.\nG0 Z5.\n";

        Assert.Equal(
            ["3 N20: an end moved by (-0.100, 0.000), where neither the wish nor a neighbor puts it."],
            Verdict.Found(Verdict.OnVectors(
                Before, After, ("N10", Vector2.Zero, Vector2.Zero), ("N20", new(-0.1, 0.05), new(-0.1, 0)))));
    }

    [Fact]
    public void A_retract_from_the_first_cut_goes_along() =>
        Assert.Empty(Verdict.OnVectors(
            Head + "N10 G1 X10. Y0. F100\nG0 Z5.\nG0 X50. Y0.\n",
            Head + "N10 G1 X10. Y0.1 F100\nG0 Z5.\nG0 X50. Y0.\n",
            ("N10", Vector2.Zero, new(0, 0.1))).Failures);

    [Fact]
    public void The_first_cut_stays_if_the_tool_was_lifted_behind_it() =>
        Assert.Equal(
            ["2 line 2: " + Unnamed, "3 line 3: " + Unnamed],
            Verdict.Found(Verdict.OnVectors(
                Head + "G1 X10. Y0. F100\nG0 Z5.\nG1 Z0.\nN20 X10. Y10.\nG0 Z5.\n",
                Head + "G1 X9.9 Y0. F100\nG0 Z5.\nG1 Z0.\nN20 X9.9 Y10.\nG0 Z5.\n",
                ("N20", new(-0.1, 0), new(-0.1, 0)))));

    // The first place does not move, so the way from there to the moved cut is not straight up.
    [Fact]
    public void The_first_rapid_leads_nowhere_else() =>
        Assert.Equal(
            ["2 line 2: " + Way],
            Verdict.Found(Verdict.OnElements(
                Head + "G0 Z5.\nG1 Z-1. F100\nN10 X10. Y0.\nG0 Z5.\n",
                Head + "G0 Y0.1 Z5.\nG1 Z-1. F100\nN10 X10. Y0.1\nG0 Z5.\n",
                ("N10", 0.1))));

    // The point N1 is above the piece. The cut N3, which begins below it, was not named.
    [Fact]
    public void A_cut_behind_the_first_rapid_does_not_begin_elsewhere() =>
        Assert.Equal(
            ["3 line 3: " + Unnamed, "4 N3: " + Unnamed],
            Verdict.Found(Verdict.OnEnds(
                Head + "N1 G0 Z5.\nG1 Z-1. F100\nN3 X10. Y0.\n",
                Head + "N1 G0 X0.1 Z5.\nG1 Z-1. F100\nN3 X10. Y0.\n",
                "N1",
                new(0.1, 0, 0))));

    // Behind the first motion, too, an origin must be set where it was.
    [Fact]
    public void An_origin_behind_the_first_motion_is_set_where_it_was() =>
        Assert.Equal(
            ["3 line 3: an origin is set or a program is called here at a place that moved."],
            Verdict.Found(Verdict.OnEnds(
                Head + "N10 G1 X10. Y0. F100\nG92 X0. Y0.\nN20 G1 X5. Y5.\n",
                Head + "N10 G1 X10. Y0.1 F100\nG92 X0. Y0.\nN20 G1 X5. Y5.\n",
                "N10",
                new(0, 0.1, 0))));

    // Neither end of the feed from an unknown place says where its line is.
    [Fact]
    public void A_cut_from_an_unknown_place_holds_nothing()
    {
        const string Before = "G90 G17\nG1 X0. Y0. Z-1. F100\nN10 X10. Y0.\nG0 Z5.\n";
        var proof = Verdict.OnElements(
            Before, "G90 G17\nG1 X0.05 Y0.1 Z-1. F100\nN10 X10. Y0.1\nG0 Z5.\n", ("N10", 0.1));

        Assert.Contains("3 N10: an end moved by (0.050, 0.100), where neither the wish nor a neighbor puts it.", Verdict.Found(proof));
        Assert.Equal(NeighborRole.Follows, proof.Neighbors[0].Role);
    }

    // The last motion leads straight up from the origin. What comes behind it is no motion.
    [Theory]
    [InlineData("X0. Y0.1")]
    [InlineData("X0.05 Y0.1", "3 N10: an end moved by (0.050, 0.100), where neither the wish nor a neighbor puts it.")]
    public void The_last_motion_leads_nowhere_else(string end, params string[] found) =>
        Assert.Equal(
            found,
            Verdict.Found(Verdict.OnElements(
                "G90 G17\nG0 X10. Y0. Z0.\nN10 G1 X0. Y0. F100\nG1 Z5.\n",
                $"G90 G17\nG0 X10. Y0.1 Z0.\nN10 G1 {end} F100\nG1 Z5.\n",
                ("N10", -0.1))));
}
