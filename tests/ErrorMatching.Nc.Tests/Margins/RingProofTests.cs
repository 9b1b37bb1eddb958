namespace ErrorMatching.Nc.Tests;

/// <summary>Which joints of a path are one place of the piece: where it closes a ring, both ends must go together.</summary>
public sealed class RingProofTests
{
    // A square of 20 to the left of travel: in along x = 0 from below, round, and on along its first side. It shrinks by 0.1: its corner
    // at the origin goes to (-0.1, 0.1), where only the last side puts it.
    private const string Square =
        "G90 G17\nG0 X0. Y-5. Z0.\nN1 G1 X0. Y0. F100\nN2 X0. Y20.\nN3 X-20. Y20.\nN4 X-20. Y0.\nN5 X0. Y0.\nN9 X0. Y5.\nG0 Z5.\n";
    private const string GoodSquare =
        "G90 G17\nG0 X-0.1 Y-5. Z0.\nN1 G1 X-0.1 Y0.1 F100\nN2 X-0.1 Y19.9\nN3 X-19.9 Y19.9\nN4 X-19.9 Y0.1\nN5 X-0.1 Y0.1\nN9 X-0.1 Y5.\n"
        + "G0 Z5.\n";

    // The same from its end to its start.
    private const string Reversed =
        "G90 G17\nG0 X0. Y5. Z0.\nN9 G1 X0. Y0. F100\nN5 X-20. Y0.\nN4 X-20. Y20.\nN3 X0. Y20.\nN2 X0. Y0.\nN1 X0. Y-5.\nG0 Z5.\n";
    private const string GoodReversed =
        "G90 G17\nG0 X-0.1 Y5. Z0.\nN9 G1 X-0.1 Y0.1 F100\nN5 X-19.9 Y0.1\nN4 X-19.9 Y19.9\nN3 X-0.1 Y19.9\nN2 X-0.1 Y0.1\nN1 X-0.1 Y-5.\n"
        + "G0 Z5.\n";

    // Two quarters of 10 about (10, 0) and (0, 10) with corners at (0, 0) and (10, 10): in along x = 0, round, and on along the first.
    // Displaced by 0.1 to the outside, they cross at 5 - sqrt(25 + 1.005) = -0.0995 and 10.0995 in both coordinates.
    private const string Lens =
        "G90 G17\nG0 X0. Y-5. Z0.\nN1 G1 X0. Y0. F100\nN2 G2 X10. Y10. I10. J0.\nN3 X0. Y0. I-10. J0.\nN9 X2. Y6. I10. J0.\nG0 Z5.\n";
    private const string GoodLens = "G90 G17\nG0 X-0.1 Y-5. Z0.\nN1 G1 X-0.1 Y-0.0995 F100\nN2 G2 X10.0995 Y10.0995 I10.1 J0.0995\n"
        + "N3 X-0.1 Y-0.0995 I-10.0995 J-0.0995\nN9 X1.92 Y6.06 I10.1 J0.0995\nG0 Z5.\n";

    [Fact]
    public void A_ring_inside_a_run_closes_at_its_corner()
    {
        Assert.Empty(Found(Square, GoodSquare, 0.1, "N1", "N2", "N3", "N4", "N5", "N9"));
        Assert.Empty(Found(Reversed, GoodReversed, -0.1, "N1", "N2", "N3", "N4", "N5", "N9"));
        Assert.Empty(Found(Lens, GoodLens, 0.1, "N1", "N2", "N3", "N9"));
    }

    // The first side begins where its own wish puts it, which is right for a corner that is none.
    [Fact]
    public void A_ring_inside_a_run_that_parts_is_named_at_all_four_ends()
    {
        var square = GoodSquare.Replace("N1 G1 X-0.1 Y0.1", "N1 G1 X-0.1 Y0.", StringComparison.Ordinal);
        var reversed = GoodReversed.Replace("N2 X-0.1 Y0.1", "N2 X-0.1 Y0.", StringComparison.Ordinal);

        Assert.Equal(Parted("N1", "N2", "N5", "N9"), Found(Square, square, 0.1, "N1", "N2", "N3", "N4", "N5", "N9"));
        Assert.Equal(Parted("N9", "N5", "N2", "N1"), Found(Reversed, reversed, -0.1, "N1", "N2", "N3", "N4", "N5", "N9"));
    }

    // Without its lead, the run begins or ends in the ring.
    [Fact]
    public void A_ring_at_an_end_of_a_run_that_parts_is_named_at_all_three_ends()
    {
        var square = Square.Replace("N1 G1 X0. Y0. F100\n", "", StringComparison.Ordinal)
            .Replace("Y-5.", "Y0.", StringComparison.Ordinal)
            .Replace("N2", "N2 G1 F100", StringComparison.Ordinal);
        var good = GoodSquare.Replace("N1 G1 X-0.1 Y0.1 F100\n", "", StringComparison.Ordinal)
            .Replace("Y-5.", "Y0.1", StringComparison.Ordinal)
            .Replace("N2", "N2 G1 F100", StringComparison.Ordinal);
        var bad = good.Replace("G0 X-0.1 Y0.1", "G0 X-0.1 Y0.", StringComparison.Ordinal);

        Assert.Empty(Found(square, good, 0.1, "N2", "N3", "N4", "N5", "N9"));
        Assert.Equal(Parted("N2", "N5", "N9"), Found(square, bad, 0.1, "N2", "N3", "N4", "N5", "N9"));

        var reversed = Reversed.Replace("N1 X0. Y-5.\n", "", StringComparison.Ordinal);
        good = GoodReversed.Replace("N1 X-0.1 Y-5.\n", "", StringComparison.Ordinal);
        bad = good.Replace("N2 X-0.1 Y0.1", "N2 X-0.1 Y0.", StringComparison.Ordinal);

        Assert.Empty(Found(reversed, good, -0.1, "N2", "N3", "N4", "N5", "N9"));
        Assert.Equal(Parted("N9", "N5", "N2"), Found(reversed, bad, -0.1, "N2", "N3", "N4", "N5", "N9"));
    }

    // In along x = 0, round, and out along y = 0: each path crosses the origin smoothly, so they may cross elsewhere afterwards.
    [Fact]
    public void Two_paths_that_cross_smoothly_close_no_ring()
    {
        var before = Square.Replace("N9 X0. Y5.", "N9 X5. Y0.", StringComparison.Ordinal);
        const string After = "G90 G17\nG0 X-0.1 Y-5. Z0.\nN1 G1 X-0.1 Y0. F100\nN2 X-0.1 Y19.9\nN3 X-19.9 Y19.9\nN4 X-19.9 Y0.1\n"
            + "N5 X0. Y0.1\nN9 X5. Y0.1\nG0 Z5.\n";

        Assert.Empty(Found(before, After, 0.1, "N1", "N2", "N3", "N4", "N5", "N9"));
    }

    // N9 goes on straight, but in another plane, whose numbers for that direction are others. N5 and N9 stay.
    [Fact]
    public void A_change_of_the_plane_is_no_corner()
    {
        const string Before = "G90 G17\nG0 X0. Y-5. Z0.\nN1 G1 X0. Y0. F100\nN2 X0. Y20.\nN3 X-20. Y20.\nN4 X-20. Y0.\nN5 X0. Y0.\n"
            + "G18\nN9 X5.\nG17\nG0 Z5.\n";
        const string After = "G90 G17\nG0 X-0.1 Y-5. Z0.\nN1 G1 X-0.1 Y0. F100\nN2 X-0.1 Y19.9\nN3 X-19.9 Y19.9\nN4 X-19.9 Y0.\n"
            + "N5 X0. Y0.\nG18\nN9 X5.\nG17\nG0 Z5.\n";
        var proof = Verdict.OnElements(Before, After, ("N1", 0.1), ("N2", 0.1), ("N3", 0.1), ("N4", 0.1), ("N5", 0), ("N9", 0));

        Assert.Empty(proof.Failures);
    }

    // A circle of 10 about the origin from (10, 0) with tangents into it and out of it. It shrinks by 0.1, and its ends part by 0.01
    // along the tangents, which is less than a tangent joint may slide.
    [Theory]
    [InlineData("N20", "N10")]
    [InlineData("N20", "N10", "N30")]
    [InlineData("N10", "N30")]
    [InlineData("N10")]
    public void A_full_circle_is_a_ring(params string[] named)
    {
        const string Before = "G90 G17\nG0 X10. Y-5. Z0.\nN20 G1 X10. Y0. F100\nN10 G3 X10. Y0. I-10. J0.\nN30 G1 X10. Y5.\nG0 Z5.\n";
        var start = named[0] == "N20" ? "X9.9 Y-5." : "X10. Y-5.";
        var end = named[^1] == "N30" ? "X9.9 Y5." : "X10. Y5.";
        var good = $"G90 G17\nG0 {start} Z0.\nN20 G1 X9.9 Y0. F100\nN10 G3 X9.9 Y0. I-9.9 J0.\nN30 G1 {end}\nG0 Z5.\n";
        var bad = good.Replace("N10 G3 X9.9 Y0.", "N10 G3 X9.9 Y-0.01", StringComparison.Ordinal);

        Assert.Empty(Found(Before, good, 0.1, named));
        var ends = named.SelectMany(n => n == "N10" ? [n, n] : new[] { n });
        Assert.Equal(Parted([.. ends]), Found(Before, bad, 0.1, named).Where(f => f.Contains("closes", StringComparison.Ordinal)));
    }

    // N1 begins where N2 ends, but nobody named it: the corner of N2 and N3 goes to (0.1, -0.1), and N1 ends on its circle of 5 about
    // (5, 0), at 5 + sqrt(25 - 0.01) = 9.999.
    [Fact]
    public void What_nobody_named_closes_no_ring_inside_a_run()
    {
        const string Before = "G90 G17\nG0 X0. Y0. Z0.\nN1 G3 X10. Y0. I5. J0. F100\nN2 G1 X0. Y0.\nN3 X0. Y-10.\nG0 Z5.\n";
        const string After = "G90 G17\nG0 X0. Y0. Z0.\nN1 G3 X9.999 Y-0.1 I5. J0. F100\nN2 G1 X0.1 Y-0.1\nN3 X0.1 Y-10.\nG0 Z5.\n";

        Assert.Empty(Found(Before, After, 0.1, "N2", "N3"));
    }

    // The place that G92 sets is known, so the first motion of all may be a cut. It begins where it did.
    [Theory]
    [InlineData("N10 G3 X0. Y0. I-10. J0. F100\n", "N10 G3 X0. Y-0.01 I-10. J0. F100\n", "N10", "N10", "N10")]
    [InlineData(
        "N10 G3 X0. Y0. I-10. J0. F100\nN20 G1 X0. Y9.\n",
        "N10 G3 X0. Y-0.01 I-10. J0. F100\nN20 G1 X0. Y9.\n",
        "N10 N20",
        "N10",
        "N10",
        "N20")]
    [InlineData(
        "N10 G1 X10. Y0. F100\nN20 X10. Y10.\nN30 X0. Y10.\nN40 X0. Y0.\n",
        "N10 G1 X10. Y0. F100\nN20 X10. Y10.\nN30 X0.1 Y10.\nN40 X0.1 Y0.\n",
        "N40",
        "N40")]
    public void A_ring_may_begin_with_the_first_motion(string was, string now, string named, params string[] parted)
    {
        const string Head = "G90 G17 G92 X0. Y0. Z0.\n";

        var found = Found(Head + was + "G0 Z5.\n", Head + now + "G0 Z5.\n", 0.1, named.Split(' '));

        Assert.Equal(Parted(parted), found.Where(f => f.Contains("closes", StringComparison.Ordinal)));
    }

    private static string[] Parted(params string[] blocks) => [.. blocks.Select(b => b + ": the contour no longer closes.")];

    private static string[] Found(string before, string result, double left, params string[] named) =>
        [.. Verdict.OnElements(before, result, [.. named.Select(n => (n, left))]).Failures.Select(f => f.Message)];
}
