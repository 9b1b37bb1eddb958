using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

/// <summary>What the proof finds in a result with a single fault: the fault and its consequences, each once and at its line.</summary>
public sealed class FindingTests
{
    private const string Line = "G90 G17 G40\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\nG4 P1\nG0 Z5.\n";
    private const string GoodLine = "G90 G17 G40\nG0 X0. Y0.1 Z0.\nN10 G1 X10. Y0.1 F100\nG4 P1\nG0 Z5.\n";
    private const string Modes = "its kind, plane, modes, feed or turns differ from the original.";

    [Fact]
    public void Nothing_is_found_in_a_good_result()
    {
        var proof = Verdict.OnElements(Line, GoodLine, ("N10", 0.1));

        Assert.Empty(proof.Failures);
        Assert.True(proof.Holds && proof.UntouchedBytesIdentical);
        Assert.Equal((3, 3), (proof.Motions, proof.MovedMotions));
        Assert.Equal([("line 2", 2, 0.1), ("line 5", 5, 0.1)], proof.Neighbors.Select(n => (n.Block, n.Line, n.DisplacementMm)));
        Assert.All(proof.Neighbors, n => Assert.Equal(NeighborRole.Positioning, n.Role));
    }

    [Theory]
    [InlineData("G4 P1\n", "", "0 The result has 4 lines, expected 5.")]
    [InlineData("G4 P1\n", "G4 P1\n\n", "0 The result has 6 lines, expected 5.")]
    [InlineData("G4 P1", "G0 X1.", "0 The result has 4 motions, the original 3.")]
    [InlineData("G0 Z5.", "G4 P2", "0 The result has 2 motions, the original 3.")]
    [InlineData("N10 G1", "N10 G0", "3 N10: " + Modes)]
    [InlineData("G90 G17", "G90 G18", "2 line 2: " + Modes, "3 N10: " + Modes, "5 line 5: " + Modes)]
    [InlineData("G4 P1", "G41 D1", "5 line 5: " + Modes)]
    [InlineData("G4 P1", "G55", "5 line 5: " + Modes)]
    [InlineData("N10 G1 X10. Y0.1 F100\nG4 P1\n", "G4 P1\nN10 G1 X10. Y0.1 F100\n", "3 N10: " + Modes)]
    [InlineData("P1", "P2", "4 line 4: something other than the words of its new place changed in it.")]
    [InlineData("Z5.", "Z6.", "5 line 5: a move along the tool axis now moves in the plane or ends at another height.")]
    [InlineData("Z5.", "Z5.0", "5 line 5: something other than the words of its new place changed in it.")]
    public void A_changed_word_is_named_at_its_line(string was, string now, params string[] found)
    {
        Assert.Contains(was, GoodLine, StringComparison.Ordinal);
        Assert.Equal(found, On(Line, GoodLine.Replace(was, now, StringComparison.Ordinal), ("N10", 0.1)));
    }

    // The line may go 1.302 mm: 13 times the displacement and two increments.
    [Theory]
    [InlineData(
        "X10. Y0.1",
        "X10. Y0.11",
        "3 N10: it lies 0.0100 mm from where it was wanted.",
        "3 N10: an end moved by (0.000, 0.110), where neither the wish nor a neighbor puts it.")]
    [InlineData(
        "X0. Y0.1",
        "X0. Y0.09",
        "3 N10: it lies 0.0100 mm from where it was wanted.",
        "3 N10: an end moved by (0.000, 0.090), where neither the wish nor a neighbor puts it.")]
    [InlineData(
        "X10. Y0.1", "X11. Y0.1", "3 N10: an end moved by (1.000, 0.100), where neither the wish nor a neighbor puts it.")]
    [InlineData(
        "X0. Y0.1", "X-1. Y0.1", "3 N10: an end moved by (-1.000, 0.100), where neither the wish nor a neighbor puts it.")]
    [InlineData(
        "X10. Y0.1",
        "X12. Y0.1",
        "3 N10: an end went 2.002 mm, further than any displacement asked for can explain.",
        "3 N10: an end moved by (2.000, 0.100), where neither the wish nor a neighbor puts it.")]
    [InlineData(
        "X0. Y0.1",
        "X-2. Y0.1",
        "3 N10: an end went 2.002 mm, further than any displacement asked for can explain.",
        "3 N10: an end moved by (-2.000, 0.100), where neither the wish nor a neighbor puts it.")]
    public void An_end_in_another_place_is_named_with_its_distance(string was, string now, params string[] found)
    {
        Assert.Contains(was, GoodLine, StringComparison.Ordinal);
        Assert.Equal(found, On(Line, GoodLine.Replace(was, now, StringComparison.Ordinal), ("N10", 0.1)));
    }

    private const string Cuts = "G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\nN20 X10. Y10.\nN30 X20. Y10.\nG0 Z5.\nG0 X50.\n";
    private const string GoodCuts = "G90 G17\nG0 X0. Y0.1 Z0.\nN10 G1 X10. Y0.1 F100\nN20 X10. Y10.\nN30 X20. Y10.\nG0 Z5.\nG0 X50.\n";
    private const string Unnamed = "it moved although neither it nor a motion beside it was named.";

    [Theory]
    [InlineData("X20. Y10.", "X20. Y10.1", "5 N30: " + Unnamed, "6 line 6: " + Unnamed, "7 line 7: " + Unnamed)]
    [InlineData("X50.", "X50.1", "7 line 7: " + Unnamed)]
    [InlineData("X10. Y10.", "X10. Y10.001", "4 N20: " + Unnamed, "5 N30: " + Unnamed)]
    [InlineData("X10. Y10.", "X10.0 Y10.", "4 N20: something other than the words of its new place changed in it.")]
    public void What_nobody_named_is_named_where_it_moved(string was, string now, params string[] found)
    {
        Assert.Contains(was, GoodCuts, StringComparison.Ordinal);
        Assert.Equal(found, On(Cuts, GoodCuts.Replace(was, now, StringComparison.Ordinal), ("N10", 0.1)));
    }

    // What was named is measured although nothing of it changed.
    [Fact]
    public void The_original_does_not_meet_a_wish()
    {
        const string Still = "3 N10: an end moved by (0.000, 0.000), where neither the wish nor a neighbor puts it.";
        const string Off = "3 N10: it lies 0.1000 mm from where it was wanted.";

        Assert.Equal([Off, Off, Still, Still], On(Line, Line, ("N10", 0.1)));
        Assert.Equal(["3 N10: it lies 0.2000 mm from where it was wanted."], Found(Ends(Line, Line, new(0.1, 0.2, 0), "N10")));
        Assert.Equal(["3 N10: it lies 0.3000 mm from where it was wanted."], Found(Ends(Line, Line, new(0.1, 0.2, -0.3), "N10")));
    }

    [Fact]
    public void The_last_motion_of_a_program_has_an_end()
    {
        const string Before = "G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\n";
        const string After = "G90 G17\nG0 X0. Y0.1 Z0.\nN10 G1 X10. Y0.1 F100\n";

        Assert.Empty(On(Before, After, ("N10", 0.1)));
        Assert.Equal(
            ["3 N10: an end moved by (0.010, 0.100), where neither the wish nor a neighbor puts it."],
            On(Before, After.Replace("X10.", "X10.01", StringComparison.Ordinal), ("N10", 0.1)));
    }

    // An increment from a place that the program does not say leads to such a place, whatever its words.
    [Fact]
    public void A_word_that_leads_nowhere_known_must_not_change()
    {
        const string Head = "G90 G17\nG91 G1 X5. F100\nG90 ";
        var proof = Verdict.OnElements(
            Head + Line["G90 G17 G40\n".Length..],
            (Head + GoodLine["G90 G17 G40\n".Length..]).Replace("X5.", "X6.", StringComparison.Ordinal),
            ("N10", 0.1));

        Assert.Equal(
            ["2 line 2: its words changed although its motion, as far as the program says where it is, did not."], Found(proof));
        Assert.False(proof.UntouchedBytesIdentical);
    }

    private const string Marker = "(M)";

    [Theory]
    [InlineData("(M)\nG90", null)]
    [InlineData("G90", "0 The result has 5 lines, expected 6.")]
    [InlineData("(N)\nG90", "0 The marker comment is not in the result.")]
    [InlineData("(M) \nG90", "0 The marker comment is not in the result.")]
    [InlineData("(M)\r\nG90", "0 The marker is not a plain comment line.")]
    [InlineData("(M)\n(M)\nG90", "0 The result has 7 lines, expected 6.")]
    public void The_marker_is_a_line_of_its_own(string head, string? found)
    {
        var path = Bench.Read(Line);
        var wish = Bench.Usable(DisplacementWish.Normal(path, Bench.Blocks(path, "N10"), 0.1));
        var result = NcProgram.FromText(GoodLine.Replace("G90", head, StringComparison.Ordinal));
        var proof = Prover.Check(path, result, wish, 0.001, Marker);

        Assert.Equal(found is null ? [] : [found], Found(proof));
        Assert.Equal(Marker, proof.Marker);
    }

    // Behind a line that ends with the same comment, too. Lines are counted in the original.
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    [InlineData(5)]
    public void The_marker_is_found_wherever_it_is(int line)
    {
        var before = "G4 P9 (M)\nG4 P8(M)\n" + Line[(Line.IndexOf('\n', StringComparison.Ordinal) + 1)..];
        var lines = ("G4 P9 (M)\nG4 P8(M)\n" + GoodLine[(GoodLine.IndexOf('\n', StringComparison.Ordinal) + 1)..]).Split('\n').ToList();
        lines.Insert(line, Marker);
        var good = string.Join('\n', lines);
        var path = Bench.Read(before);
        var wish = Bench.Usable(DisplacementWish.Normal(path, Bench.Blocks(path, "N10"), 0.1));

        Assert.Empty(On(good));
        Assert.Equal(
            ["1 line 1: something other than the words of its new place changed in it."],
            On(good.Replace("P9", "P7", StringComparison.Ordinal)));
        Assert.Equal(
            ["5 line 5: something other than the words of its new place changed in it."],
            On(good.Replace("P1", "P2", StringComparison.Ordinal)));

        string[] On(string result) => Found(Prover.Check(path, NcProgram.FromText(result), wish, 0.001, Marker));
    }

    // The point is the end of N10: what comes next begins there and ends where it did.
    [Theory]
    [InlineData("X10.1 Y0.", "G0 X10. Z5.")]
    [InlineData("X10.1 Y0.", "G0 Z5.", "4 line 4: it moved although it was not named.")]
    [InlineData("X10.1005 Y0.", "G0 X10. Z5.")]
    [InlineData("X10.0995 Y0.", "G0 X10. Z5.")]
    [InlineData("X10.1006 Y0.", "G0 X10. Z5.", "3 N10: it lies 0.0006 mm from where it was wanted.")]
    [InlineData("X10.0994 Y0.", "G0 X10. Z5.", "3 N10: it lies 0.0006 mm from where it was wanted.")]
    public void A_point_moves_alone(string end, string retract, params string[] found)
    {
        var path = Bench.Read("G90 G17\nG0 X0. Y0. Z0.\nN10 G1 X10. Y0. F100\nG0 Z5.\nG0 X50.\n");
        var wish = DisplacementWish.OfPoints([new(path.MotionOf(Bench.Blocks(path, "N10")[0]), new(0.1, 0, 0))]);
        var result = $"G90 G17\nG0 X0. Y0. Z0.\nN10 G1 {end} F100\n{retract}\nG0 X50.\n";
        var proof = Prover.Check(path, NcProgram.FromText(result), wish, 0.001);

        Assert.Equal(found, Found(proof));
        if (found.Length == 0)
        {
            var moved = double.Parse(end.Split(' ')[0][1..], System.Globalization.CultureInfo.InvariantCulture) - 10;
            var neighbor = Assert.Single(proof.Neighbors);
            Assert.Equal(("line 4", 4, NeighborRole.Follows), (neighbor.Block, neighbor.Line, neighbor.Role));
            Assert.Equal(moved, neighbor.DisplacementMm, 1e-12);
            Assert.Equal((4, 2), (proof.Motions, proof.MovedMotions));
        }
    }

    private const string Points = "G90 G17\nG0 X0. Y0. Z5.\nN10 G1 Z-1. F100\nN20 X10. Y0.\nN30 G3 X15. Y5. I0. J5.\nG0 Z6.\nX50. Y0.\n";
    private const string GoodPoints =
        "G90 G17\nG0 X0. Y0. Z5.\nN10 G1 Z-1. F100\nN20 X10.1 Y0.2\nN30 G3 X15.1 Y5.2 I0. J5.\nG0 Z6.\nX50. Y0.\n";

    private const string Retract = "a move along the tool axis now moves in the plane or ends at another height.";

    // The arc begins where N20 ends, with its center 5 above. If N20 ends d further to the right, the arc with the radius of its start
    // misses its end by d; d higher, its middle, which goes by the mean of both ends, is 0.354 d outside.
    [Theory]
    [InlineData("X50.", "X50.")]
    [InlineData(
        "X10.1 Y0.2",
        "X10.11 Y0.2",
        "4 N20: it lies 0.0100 mm from where it was wanted.",
        "5 N30: the radii at its start and end differ by more than a control accepts.",
        "5 N30: it lies 0.0100 mm from where it was wanted.")]
    [InlineData(
        "X10.1 Y0.2",
        "X10.1 Y0.22",
        "4 N20: it lies 0.0200 mm from where it was wanted.",
        "5 N30: it lies 0.0071 mm from where it was wanted.")]
    [InlineData(
        "X10.1 Y0.2",
        "X10.1 Y0.2 Z-1.03",
        "4 N20: it lies 0.0300 mm from where it was wanted.",
        "5 N30: it lies 0.0300 mm from where it was wanted.")]
    [InlineData("Z6.", "Z7.", "6 line 6: " + Retract, "7 line 7: " + Unnamed)]
    [InlineData("Z6.", "X15.2 Z6.", "6 line 6: " + Retract)]
    [InlineData("X50. Y0.", "X50.1 Y0.", "7 line 7: " + Unnamed)]
    public void An_end_point_is_measured_in_each_axis(string was, string now, params string[] found)
    {
        Assert.Contains(was, GoodPoints, StringComparison.Ordinal);
        var proof = Ends(Points, GoodPoints.Replace(was, now, StringComparison.Ordinal), new(0.1, 0.2, 0), "N20", "N30");
        Assert.Equal(found, Found(proof));
        if (found.Length == 0)
        {
            Assert.Equal(
                [("line 6", NeighborRole.Positioning), ("line 7", NeighborRole.Follows)], proof.Neighbors.Select(n => (n.Block, n.Role)));
            Assert.All(proof.Neighbors, n => Assert.Equal(Math.Sqrt(0.05), n.DisplacementMm, 1e-9));
        }
    }

    private static string[] On(string before, string after, params (string Block, double Left)[] wishes) =>
        Found(Verdict.OnElements(before, after, wishes));

    private static NcProof Ends(string before, string after, Vector3 by, params string[] blocks)
    {
        var path = Bench.Read(before);
        var wish = Bench.Usable(DisplacementWish.EndsBy(path, Bench.Blocks(path, blocks), by));
        return Prover.Check(path, NcProgram.FromText(after), wish, 0.001);
    }

    private static string[] Found(NcProof proof)
    {
        Assert.Equal(proof.Failures.Count == 0, proof.Holds);
        Assert.All(proof.Failures, f => Assert.Equal(NcRefusalCodes.ProofFailed, f.Code));
        return [.. proof.Failures.Select(f => $"{f.Place.Line ?? 0} {f.Message}")];
    }
}
