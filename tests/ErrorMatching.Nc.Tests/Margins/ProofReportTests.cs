namespace ErrorMatching.Nc.Tests;

/// <summary>What a proof reports besides its failures: what moved, which motions moved along and how, and whether the rest is the
/// original's.</summary>
public sealed class ProofReportTests
{
    private const string Unnamed = "it moved although neither it nor a motion beside it was named.";
    private const string Head = "G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\n";
    private const string GoodHead = "G90 G17\nG0 X0. Y0.1 Z0.\nN10 G1 X10. Y0.1 F100\n";

    [Fact]
    public void What_was_named_and_stayed_is_not_moved()
    {
        const string Before = Head + "N20 G3 X15. Y5. I0. J5.\nG0 Z5.\n";
        var proof = Verdict.OnElements(Before, Before, ("N10", 0), ("N20", 0));

        Assert.True(proof.Holds);
        Assert.Equal((4, 0), (proof.Motions, proof.MovedMotions));
    }

    [Fact]
    public void What_moved_behind_a_named_motion_that_stayed_is_found()
    {
        const string Before = Head + "N20 X10. Y10.\nN30 X20. Y10.\nG0 Z5.\n";

        Assert.Equal(
            ["4 N20: " + Unnamed, "5 N30: " + Unnamed],
            Verdict.Found(Verdict.OnElements(Before, Before.Replace("N20 X10.", "N20 X10.1", StringComparison.Ordinal), ("N10", 0))));
    }

    [Theory]
    [InlineData("N20 X10. Y10.\n", NeighborRole.Slides)]
    [InlineData("N20 X20. Y10.\n", NeighborRole.Follows)]
    [InlineData("N20 X10. Y0.1\n", NeighborRole.Slides, "4 N20: it turned round.")]
    public void A_line_slides_if_both_of_its_ends_are_on_it(string rest, NeighborRole role, params string[] found)
    {
        var proof = Verdict.OnElements(Head + rest, GoodHead + rest, ("N10", 0.1));

        Assert.Equal(found, Verdict.Found(proof));
        Assert.Equal(role, proof.Neighbors.Single(n => n.Block == "N20").Role);
    }

    // The retract of the program 100 moves by 0.1 behind N10, by 0.3 behind N20 and by 0.2 behind N30.
    [Fact]
    public void A_block_that_runs_several_times_is_one_neighbor_with_its_largest_displacement()
    {
        const string Called = "M30\nO100\nG0 Z5.\nM99\n";
        var before = "G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\nM98 P100\nG0 X20. Y0.\nN20 G1 X30. Y0. Z0.\nM98 P100\nG0 X40. Y0.\n"
            + "N30 G1 X50. Y0. Z0.\nM98 P100\n" + Called;
        var after = "G90 G17\nG0 X0. Y0.1 Z0.\nN10 G1 X10. Y0.1 F100\nM98 P100\nG0 X20. Y0.3\nN20 G1 X30. Y0.3 Z0.\nM98 P100\n"
            + "G0 X40. Y0.2\nN30 G1 X50. Y0.2 Z0.\nM98 P100\n" + Called;
        var path = Bench.Read(before, NcDialects.FanucMill);
        ElementWish[] elements =
        [
            .. new[] { ("N10", 0.1), ("N20", 0.3), ("N30", 0.2) }
                .Select(w => ElementWish.AlongNormals(path, path.MotionOf(Bench.Blocks(path, w.Item1)[0]), w.Item2, w.Item2, w.Item2)),
        ];
        var proof = Prover.Check(path, NcProgram.FromText(after), DisplacementWish.OfElements(elements), 0.001);

        Assert.Empty(proof.Failures);
        Assert.Equal(0.3, Assert.Single(proof.Neighbors, n => n.Line == 13).DisplacementMm, 1e-9);
    }

    // Nothing is compared if the results are not of one length, so nothing is said to be identical.
    [Fact]
    public void Bytes_that_were_not_compared_are_not_identical()
    {
        const string Before = Head + "G0 Z5.\n";

        Assert.False(Verdict.OnElements(Before, GoodHead + "G4 P1\n", ("N10", 0.1)).UntouchedBytesIdentical);
        Assert.False(Verdict.OnElements(Before, GoodHead, ("N10", 0.1)).UntouchedBytesIdentical);
    }

    [Fact]
    public void A_result_that_is_refused_is_not_proved()
    {
        const string Before = Head + "G4 P1\nG0 Z5.\n";
        var result = NcProgram.FromText(GoodHead + "GOTO 9\nG0 Z5.\n");
        var path = Bench.Read(Before, NcDialects.FanucMill);
        var refusal = NcInterpreter.Run(result, NcDialects.FanucMill).Refusal;
        var wish = Bench.Usable(DisplacementWish.Normal(path, Bench.Blocks(path, "N10"), 0.1));

        Assert.NotNull(refusal);
        Assert.Equal([refusal], Prover.Check(path, result, wish, 0.001).Failures);
    }

    // An unnamed quarter whose start slides along it: one of the two radii is right only if its center is.
    [Theory]
    [InlineData("I-9.9995 J-0.1")]
    [InlineData("I-9.9975 J-0.101", "4 N20: the radii at its start and end differ by more than a control accepts.")]
    public void The_radii_of_an_arc_that_slides_are_compared(string center, params string[] found)
    {
        const string Before = Head + "N20 G3 X0. Y10. I-10. J0.\nG0 Z5.\n";
        var after = $"G90 G17\nG0 X0. Y0.1 Z0.\nN10 G1 X9.9995 Y0.1 F100\nN20 G3 X0. Y10. {center}\nG0 Z5.\n";

        var all = Verdict.Found(Verdict.OnElements(Before, after, ("N10", 0.1)));
        Assert.Equal(found.Length == 0, all.Length == 0);
        Assert.All(found, f => Assert.Contains(f, all));
    }

    // A center far off is one fault, whatever else follows from it.
    [Theory]
    [InlineData("I0.001")]
    [InlineData("I0.004")]
    public void A_center_that_moved_alone_is_one_fault(string center)
    {
        const string Rest = "N20 G1 X10. Y10.\nN30 G2 X20. Y0. I0. J-10.\nG0 Z5.\n";
        var proof = Verdict.OnElements(
            Head + Rest, GoodHead + Rest.Replace("I0.", center, StringComparison.Ordinal), ("N10", 0.1));

        Assert.Equal(["5 N30: its center moved although its ends did not."], Verdict.Found(proof));
        Assert.DoesNotContain(proof.Neighbors, n => n.Block == "N30");
    }

    // Its line end is that of the line before it, or of the line behind it if it is the first.
    [Theory]
    [InlineData("(M)\nG4 P1\nG4 P2\r\nG4 P3\n", true)]
    [InlineData("(M)\r\nG4 P1\nG4 P2\r\nG4 P3\n", false)]
    [InlineData("G4 P1\n(M)\nG4 P2\r\nG4 P3\n", true)]
    [InlineData("G4 P1\n(M)\r\nG4 P2\r\nG4 P3\n", false)]
    [InlineData("G4 P1\nG4 P2\r\n(M)\r\nG4 P3\n", true)]
    [InlineData("G4 P1\nG4 P2\r\nG4 P3\n(M)\n", true)]
    [InlineData("G4 P1\nG4 P2\r\nG4 P3\n(M)\r\n", false)]
    public void A_marker_ends_as_the_line_before_it(string result, bool holds)
    {
        var path = Bench.Read("G4 P1\nG4 P2\r\nG4 P3\n");

        Assert.Equal(
            holds ? [] : ["0 The marker is not a plain comment line."],
            Verdict.Found(Prover.Check(path, NcProgram.FromText(result), DisplacementWish.OfElements([]), 0.001, "(M)")));
    }

    [Fact]
    public void A_marker_may_be_all_there_is() =>
        Assert.True(Prover.Check(Bench.Read(""), NcProgram.FromText("(M)"), DisplacementWish.OfElements([]), 0.001, "(M)").Holds);

    // The increment is 1/1024, so the numbers are exact. The end of N10 goes by 1/8, and that of N20 along its circle of 10: its center
    // stays, J-0.125.
    [Theory]
    [InlineData("J-0.125")]
    [InlineData("J-0.12109375", "N20: its ends slid along its circle, but its center moved.")]
    public void An_arc_that_slides_keeps_its_center(string center, params string[] found)
    {
        const string Before = Head + "N20 G3 X-10. Y0. I-10. J0.\nG0 Z5.\n";
        var after = "G90 G17\nG0 X0. Y0.125 Z0.\nN10 G1 X9.9990234375 Y0.125 F100\n"
            + $"N20 G3 X-10. Y0. I-9.9990234375 {center}\nG0 Z5.\n";

        Assert.Equal(found, Exact(Before, after, 0.125).Where(f => f.Contains("slid", StringComparison.Ordinal)));
    }

    // An end that went by five increments may have gone anywhere, so the arc may follow it: to 0.0042 mm to the right and up.
    [Theory]
    [InlineData("Y0.0048828125", 0.0048828125, "I-9.995833 J-0.000715")]
    [InlineData("Y0.005859375", 0.005859375, "I-9.995 J-0.000859", "N20: its ends slid along its circle, but its center moved.")]
    public void An_end_that_went_by_five_increments_does_not_slide(string end, double left, string center, params string[] found)
    {
        const string Before = Head + "N20 G3 X0. Y10. I-10. J0.\nG0 Z5.\n";
        var after = $"G90 G17\nG0 X0. {end} Z0.\nN10 G1 X10. {end} F100\nN20 G3 X0. Y10. {center}\nG0 Z5.\n";

        Assert.Equal(found, Exact(Before, after, left));
    }

    private static string[] Exact(string before, string after, double left)
    {
        var path = Bench.Read(before);
        var wish = Bench.Usable(DisplacementWish.Normal(path, Bench.Blocks(path, "N10"), left));
        return [.. Prover.Check(path, NcProgram.FromText(after), wish, 1.0 / 1024).Failures.Select(f => f.Message)];
    }
}
