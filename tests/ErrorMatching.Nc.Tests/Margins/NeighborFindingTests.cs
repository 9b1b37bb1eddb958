namespace ErrorMatching.Nc.Tests;

/// <summary>What the proof finds at arcs, joints and motions that nobody named: each result has one fault, and all its consequences are
/// listed.</summary>
public sealed class NeighborFindingTests
{
    private const string Retract = "a move along the tool axis now moves in the plane or ends at another height.";
    private const string Head = "G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\n";
    private const string GoodHead = "G90 G17\nG0 X0. Y0.1 Z0.\nN10 G1 X10. Y0.1 F100\n";

    [Theory]
    [InlineData("G0 Z5.")]
    [InlineData("G0 X11. Z5.", "4 line 4: " + Retract)]
    [InlineData("G0 X10. Z5.", "4 line 4: something other than the words of its new place changed in it.")]
    [InlineData("G0 Y0. Z5.", "4 line 4: " + Retract)]
    public void A_retract_goes_straight_up(string retract, params string[] found) =>
        Assert.Equal(found, Found(Head + "G0 Z5.\n", GoodHead + retract + "\n", ("N10", 0.1)));

    [Fact]
    public void An_end_that_went_deeper_is_found_and_so_is_its_retract() =>
        Assert.Equal(
            ["3 N10: an end moved along the tool axis.", "4 line 4: " + Retract],
            Found(Head + "G0 Z5.\n", GoodHead.Replace("Y0.1 F", "Y0.1 Z-0.1 F", StringComparison.Ordinal) + "G0 Z5.\n", ("N10", 0.1)));

    [Fact]
    public void A_center_that_moved_alone_is_found()
    {
        const string Rest = "N20 G1 X10. Y10.\nN30 G2 X20. Y0. I0. J-10.\nG0 Z5.\n";

        Assert.Equal(
            ["5 N30: its center moved although its ends did not."],
            Found(Head + Rest, GoodHead + Rest.Replace("I0. ", "I0.001 ", StringComparison.Ordinal), ("N10", 0.1)));
    }

    // Its radii are 1.4 and 9.5.
    [Fact]
    public void An_arc_without_a_circle_must_not_begin_elsewhere()
    {
        const string Rest = "N20 G2 X20. Y3. I1. J1.\nG0 Z5.\n";

        Assert.Equal(
            ["4 N20: an end of it moved, but its words do not say which arc it is."], Found(Head + Rest, GoodHead + Rest, ("N10", 0.1)));
    }

    // The quarter about (0, 0) begins at (sqrt(100 - 0.01), 0.1) where the line y = 0.1 meets it.
    // About (0.01, 0.01), its radius is 9.9899, and the circle on which it should be, through its wished start (10, 0.1),
    // its end and its old middle, moved by half of that, is up to 0.0314 beside it.
    [Theory]
    [InlineData("I-9.9995 J-0.1")]
    [InlineData(
        "I-9.9895 J-0.09",
        "4 N20: its ends slid along its circle, but its center moved.",
        "4 N20: it lies 0.0314 mm from where it was wanted.")]
    public void An_arc_whose_end_slides_keeps_its_center(string center, params string[] found) =>
        Assert.Equal(
            found,
            Found(
                Head + "N20 G3 X0. Y10. I-10. J0.\nG0 Z5.\n",
                GoodHead.Replace("X10.", "X9.9995", StringComparison.Ordinal) + $"N20 G3 X0. Y10. {center}\nG0 Z5.\n",
                ("N10", 0.1)));

    // Its radius is 3 micrometers longer at its end, which is no more than that beside the circle of its start.
    [Fact]
    public void An_arc_whose_radii_differ_slides_along_the_circle_of_its_start()
    {
        var proof = Verdict.OnElements(
            Head + "N20 G3 X0. Y10.003 I-10. J0.\nG0 Z5.\n",
            GoodHead.Replace("X10.", "X9.9995", StringComparison.Ordinal) + "N20 G3 X0. Y10.003 I-9.9995 J-0.1\nG0 Z5.\n",
            ("N10", 0.1));

        Assert.Empty(proof.Failures);
        Assert.Equal(NeighborRole.Slides, proof.Neighbors.Single(n => n.Block == "N20").Role);
    }

    // The increment is such that 1.6 of it and 1e-6 are 2^-8 mm. By as much, the end that follows its line may be beside the circle of
    // 10 about the origin.
    [Theory]
    [InlineData("N20 G1 X10. Y0. F100\nN30 G3 X0. Y10. I-10. J0.", "X10.00390625 Y0.", "X0. Y10. I-10.00390625 J0.", -0.00390625)]
    [InlineData("N30 G3 X0. Y10. I-10. J0. F100\nN20 G1 X-10. Y10.", "X-10. Y10.00390625", "X0. Y10.00390625 I-10. J0.", -0.00390625)]
    public void An_arc_slides_as_far_beside_its_circle_as_rounding_explains(string cuts, string line, string arc, double left)
    {
        const double Increment = (0.00390625 - 1e-6) / 1.6;
        Assert.Equal(0.00390625, (1.6 * Increment) + 1e-6);
        var isFirst = cuts.StartsWith("N20", StringComparison.Ordinal);
        var path = Bench.Read($"G90 G17\nG0 X10. Y{(isFirst ? -10 : 0)}. Z0.\n{cuts}\nG0 Z5.\n");
        var now = isFirst ? $"N20 G1 {line} F100\nN30 G3 {arc}" : $"N30 G3 {arc} F100\nN20 G1 {line}";
        var wish = Bench.Usable(DisplacementWish.Normal(path, Bench.Blocks(path, "N20"), left));
        var proof = Prover.Check(
            path,
            NcProgram.FromText($"G90 G17\nG0 X{(isFirst ? "10.00390625 Y-10" : "10. Y0")}. Z0.\n{now}\nG0 Z5.\n"),
            wish,
            Increment);

        Assert.Equal(NeighborRole.Slides, proof.Neighbors.Single(n => n.Block == "N30").Role);
    }

    // A move home begins where the named end is now, and ends where it did, or goes along in the axes that it does not name.
    [Theory]
    [InlineData("G53 X0. Y0.", 0.5, "")]
    [InlineData("G53 Y0.", 0.3, "line 5 Follows 0.3")]
    [InlineData("G53 X0.", 0.4, "line 5 Follows 0.4")]
    public void A_move_home_is_positioning(string home, double displaced, string next)
    {
        string Text(string end) => $"G90 G17\nG0 X0. Y0. Z5.\nN20 G1 {end} F100\n{home}\nG0 X5. Y5.\n";
        var proof = Verdict.OnEnds(Text("X10. Y0."), Text("X10.3 Y0.4"), "N20", new(0.3, 0.4, 0));

        Assert.Empty(proof.Failures);
        Assert.Equal(("line 4", NeighborRole.Positioning), (proof.Neighbors[0].Block, proof.Neighbors[0].Role));
        Assert.Equal(displaced, proof.Neighbors[0].DisplacementMm, 1e-9);
        var behind = proof.Neighbors.Skip(1).Select(n => FormattableString.Invariant($"{n.Block} {n.Role} {n.DisplacementMm:0.###}"));
        Assert.Equal(next, string.Join(", ", behind));
    }

    // From zero, the words say exactly by how much.
    [Theory]
    [InlineData("Z0.000000001")]
    [InlineData("Z0.0000000011", "line 4: " + Retract)]
    public void A_retract_ends_at_its_height_to_a_picometer(string end, params string[] found) =>
        Assert.Equal(
            found,
            Verdict.OnEnds(
                "G90 G17\nG0 X0. Y0. Z-5.\nN20 G1 X10. F100\nG0 Z0.\n",
                $"G90 G17\nG0 X0. Y0. Z-5.\nN20 G1 X10.1 F100\nG0 {end}\n",
                "N20",
                new(0.1, 0, 0)).Failures.Select(f => f.Message));

    [Fact]
    public void A_retract_that_goes_aside_is_found_and_noted_with_how_far_its_end_went()
    {
        var proof = Verdict.OnEnds(
            "G90 G17\nG0 X0. Y0. Z5.\nN20 G1 X10. Y0. F100\nG0 Z6.\nX50. Y0.\n",
            "G90 G17\nG0 X0. Y0. Z5.\nN20 G1 X10.1 Y0. F100\nG0 X10.2 Z6.\nX50. Y0.\n",
            "N20",
            new(0.1, 0, 0));

        Assert.Equal(["line 4: " + Retract], proof.Failures.Select(f => f.Message));
        Assert.Equal([("line 4", 0.2), ("line 5", 0.2)], proof.Neighbors.Select(n => (n.Block, Math.Round(n.DisplacementMm, 9))));
    }

    [Fact]
    public void A_short_neighbor_that_turned_round_is_found()
    {
        const string Rest = "N20 X10. Y0.05\nN30 X20. Y10.\nG0 Z5.\n";

        Assert.Equal(["4 N20: it turned round."], Found(Head + Rest, GoodHead + Rest, ("N10", 0.1)));
    }

    [Theory]
    [InlineData("Y0.1")]
    [InlineData("Y0.3", "4 N10: the contour no longer closes.")]
    [InlineData("Y0.101", "4 N10: the contour no longer closes.")]
    public void A_contour_closes_where_it_begins(string end, params string[] found)
    {
        const string Before =
            "G90 G17\nG0 X0. Y0.\nG1 Z-1. F100\nN10 X10. Y0.\nN20 X10. Y10.\nN30 X0. Y10.\nN40 X0. Y0.\nG0 Z5.\nX50. Y50.\n";
        var after = "G90 G17\nG0 X0. Y0.1\nG1 Z-1. F100\nN10 X10. Y0.1\nN20 X10. Y10.\nN30 X0. Y10.\nN40 X0. "
            + $"{end}\nG0 Z5.\nX50. Y50.\n";

        Assert.Equal(found, Found(Before, after, ("N10", 0.1)));
    }

    // About (15, 0) instead of (10, 5), and by 270 degrees instead of 90: both centers are 7.0711 apart, and so much is its middle outside.
    [Fact]
    public void An_arc_that_goes_the_long_way_is_found()
    {
        const string Before = Head + "N20 G3 X15. Y5. R5.\nG0 Z5.\n";

        Assert.Equal(
            [
                "4 N20: it lies 7.0711 mm from where it was wanted.",
                "4 N20: it turns by another angle than before.",
            ],
            Found(Before, Before.Replace("R5.", "R-5.", StringComparison.Ordinal), ("N20", 0)));
    }

    // N10 by 0.1 and N30 by 0.3: the fillet between them touches at (9.9, 0.1) and (14.7, 4.9), with a radius of 4.8.
    [Theory]
    [InlineData("X9.9 Y0.1", "X14.7 Y4.9 I0. J4.8")]
    [InlineData(
        "X9.9008 Y0.1", "X14.7 Y4.9 I-0.0008 J4.8", "4 N20: the fillet does not end where it touches the lines beside it.")]
    [InlineData("X9.9 Y0.1", "X14.7 Y4.9008 I0. J4.8", "4 N20: the fillet does not end where it touches the lines beside it.")]
    public void A_fillet_ends_where_it_touches(string start, string arc, params string[] found)
    {
        const string Before = Head + "N20 G3 X15. Y5. I0. J5.\nN30 G1 X15. Y15.\nG0 Z5.\n";
        var after = $"G90 G17\nG0 X0. Y0.1 Z0.\nN10 G1 {start} F100\nN20 G3 {arc}\nN30 G1 X14.7 Y15.\nG0 Z5.\n";

        Assert.Equal(found, Found(Before, after, ("N10", 0.1), ("N30", 0.3)));
    }

    private static string[] Found(string before, string after, params (string Block, double Left)[] wishes) =>
        [.. Verdict.OnElements(before, after, wishes).Failures.Select(f => $"{f.Place.Line ?? 0} {f.Message}")];
}
