using ErrorMatching.Geometry;

namespace ErrorMatching.Nc.Tests;

/// <summary>Which words of a block may change, come and go with a motion that moved: those that its new place needs, and no byte
/// more.</summary>
public sealed class BlockWordTests
{
    private const string Comment = "(a comment that makes the block longer than the 128 bytes for which there is room at first; only few"
        + " blocks of a program that somebody wrote are as long)";
    private const string Other = "something other than the words of its new place changed in it.";

    // N20 ends 0.1 to the right and 0.2 higher. Its words do not name Y at first.
    [Theory]
    [InlineData("N20 G1 X10.1 Y0.2 F100")]
    [InlineData("N20 G1 Y0.2 X10.1 F100")]
    [InlineData("Y0.2 N20 G1 X10.1 F100")]
    [InlineData("N20 G1 X10.1 F100 Y0.2")]
    [InlineData("N20 G1 X10.10 Y0.2 F100")]
    [InlineData("Y0.2  N20 G1 X10.1 F100", "N20: " + Other)]
    [InlineData(" N20 G1 X10.1 Y0.2 F100", "N20: " + Other)]
    [InlineData("N20 G1 X10.1 Y0.2  F100", "N20: " + Other)]
    [InlineData("N20 G1 X10.1  Y0.2 F100", "N20: " + Other)]
    [InlineData("N20 G1  X10.1 Y0.2 F100", "N20: " + Other)]
    [InlineData("N20 G1 X10.1 Y0.2 F100 ", "N20: " + Other)]
    [InlineData("N20 G1 X10.1 Y0.2 F100\r", "N20: " + Other)]
    [InlineData("N20 G1 X10.1 Y0.2 Z0. F100", "N20: " + Other)]
    [InlineData("N20 G1 X10.1 Y0.2 F100.", "N20: " + Other)]
    [InlineData("N20 G01 X10.1 Y0.2 F100", "N20: " + Other)]
    [InlineData("N21 G1 X10.1 Y0.2 F100", "N20: " + Other)]
    [InlineData("n20 G1 X10.1 Y0.2 F100", "N20: " + Other)]
    [InlineData("N20 G1 x10.1 Y0.2 F100", "N20: " + Other)]
    [InlineData("N20 G1 X10.1 Y0.2 F100 (A)", "N20: " + Other)]
    [InlineData("N20 G1 X10.1 Y0.2 F100 S1", "N20: " + Other)]
    public void A_line_gets_the_word_that_it_needs(string block, params string[] found)
    {
        const string Before = "G90 G17\nG0 X0. Y0. Z0.\nN20 G1 X10. F100\nN25 X20. Y5.\nG0 Z5.\n";
        var after = Before.Replace("N20 G1 X10. F100", block, StringComparison.Ordinal);

        Assert.Equal(found, Found(Before, after, "N20", new(0.1, 0.2, 0)));
    }

    // It goes up by 0.3 as well, or along one axis only.
    [Theory]
    [InlineData(0.1, 0.2, -0.3, "N20 G1 X10.1 Y0.2 Z-0.3 F100")]
    [InlineData(0, 0, -0.3, "N20 G1 X10. Z-0.3 F100")]
    [InlineData(0, 0, -0.3, "N20 G1 X10. Y0. Z-0.3 F100", "N20: " + Other)]
    [InlineData(0, 0.2, 0, "N20 G1 X10. Y0.2 F100")]
    [InlineData(0, 0.2, 0, "N20 G1 X10.0 Y0.2 F100", "N20: " + Other)]
    [InlineData(0, 0.2, 0, "N20 G1 Y0.2 X10. F100")]
    public void A_word_comes_for_an_axis_that_moves(double x, double y, double z, string block, params string[] found)
    {
        const string Before = "G90 G17\nG0 X0. Y0. Z0.\nN20 G1 X10. F100\nN25 X20. Y5. Z0.\nG0 Z5.\n";
        var after = Before.Replace("N20 G1 X10. F100", block, StringComparison.Ordinal);

        Assert.Equal(found, Found(Before, after, "N20", new(x, y, z)));
    }

    // An axis moves if it goes by more than 1e-9: that is also what the words say exactly, from zero.
    [Theory]
    [InlineData("Y10.", "X0.000000001 Y10.2", 0, 0.2, "N20: " + Other)]
    [InlineData("Y10.", "X0.0000000011 Y10.2", 0, 0.2)]
    [InlineData("X10.", "X10.2 Y0.000000001", 0.2, 0, "N20: " + Other)]
    [InlineData("X10.", "X10.2 Y0.0000000011", 0.2, 0)]
    [InlineData("X10.", "X10.2 Z0.000000001", 0.2, 0, "N20: " + Other)]
    [InlineData("X10.", "X10.2 Z0.0000000011", 0.2, 0)]
    public void A_word_comes_for_no_less_than_a_picometer(string was, string now, double x, double y, params string[] found)
    {
        const string Before = "G90 G17\nG0 X0. Y0. Z0.\nN20 G1 WORDS F100\nN25 X20. Y5. Z0.\nG0 Z5.\n";

        Assert.Equal(
            found,
            Found(
                Before.Replace("WORDS", was, StringComparison.Ordinal),
                Before.Replace("WORDS", now, StringComparison.Ordinal),
                "N20",
                new(x, y, 0)));
    }

    // The arc of each plane has its own two center words.
    // It begins at (-3.8, 0) instead of (-4, 0), about (0.1, -2.8025) instead of (0, -3).
    [Theory]
    [InlineData("G17", "X", "Y", "Z", "I", "J", "K")]
    [InlineData("G18", "Z", "X", "Y", "K", "I", "J")]
    [InlineData("G19", "Y", "Z", "X", "J", "K", "I")]
    public void An_arc_changes_the_center_words_of_its_plane(string code, string u, string v, string w, string i, string j, string k)
    {
        var head = $"G90 {code}\nG0 X0. Y0. Z0.\nG0 {u}-10. {v}0.\n";
        var before = $"{head}N20 G1 {u}-4. {v}0. F100\nN30 G2 {u}4. {v}0. {i}4. {j}-3.\nG0 {w}5.\n";
        var after = $"{head}N20 G1 {u}-3.8 {v}0. F100\nN30 G2 {u}4. {v}0. {i}3.9 {j}-2.8025\nG0 {w}5.\n";
        var by = new Vector3(u == "X" ? 0.2 : 0, u == "Y" ? 0.2 : 0, u == "Z" ? 0.2 : 0);

        Assert.Empty(Found(before, after, "N20", by));
        Assert.Equal(["N30: " + Other], Found(before, after.Replace("-2.8025", $"-2.8025 {k}0.", StringComparison.Ordinal), "N20", by));
        Assert.Equal(["N30: " + Other], Found(before, after.Replace("-2.8025", $"-2.8025 {w}0.", StringComparison.Ordinal), "N20", by));
    }

    // It goes with N20 by (0.1, 0.2).
    [Theory]
    [InlineData("X15. Y5. R5.", "X15.1 Y5.2 R5.")]
    [InlineData("X15. Y5. R5.", "X15.1 Y5.2 I0. J5.")]
    [InlineData("X15. Y5. R5.", "X15.1 Y5.2 J5. I0.")]
    [InlineData("X15. Y5. R5. F100", "X15.1 Y5.2 R5. F100")]
    [InlineData("X15. Y5. R5. F100", "X15.1 Y5.2 I0. J5. F100")]
    [InlineData("X15. Y5. R5. F100", "X15.1 Y5.2 I0. J5.", "N30: " + Other)]
    [InlineData("X15. Y5. J5.", "X15.1 Y5.2 J5.")]
    [InlineData("X15. Y5. J5.", "X15.1 Y5.2 I0. J5.", "N30: " + Other)]
    [InlineData("X15. Y5. I0. J5.", "X15.1 Y5.2 J5.", "N30: " + Other)]
    [InlineData("X15. Y5. I0. J5.", "X15.1 Y5.2 R5.", "N30: " + Other)]
    [InlineData("X15. Y5. I0. J5.", "X15.1 Y5.2 I0.0 J5.", "N30: " + Other)]
    [InlineData("X15. Y5. I0. J5.", "X15.1 Y5.2 I0. J5. R5.", "N30: " + Other)]
    public void A_radius_may_give_way_to_a_center(string was, string now, params string[] found)
    {
        var before = $"G90 G17\nG0 X0. Y0. Z0.\nN20 G1 X10. Y0. F100\nN30 G3 {was}\nG0 Z5.\nX50. Y0.\n";
        var after = $"G90 G17\nG0 X0. Y0. Z0.\nN20 G1 X10.1 Y0.2 F100\nN30 G3 {now}\nG0 Z5.\nX50. Y0.\n";

        Assert.Equal(found, Found(before, after, "N20..N30", new(0.1, 0.2, 0)));
    }

    [Fact]
    public void A_corner_word_is_no_radius()
    {
        static string Text(string end, string arc) =>
            $"G90 G17\nG0 X0. Y0. Z0.\nN20 G1 {end} F100\nN30 G3 {arc} ,R1.\nG0 Z5.\nX50. Y0.\n";

        Assert.Contains(
            "N30: it changed although its words alone do not say where it goes.",
            Verdict.OnEnds(
                Text("X10. Y0.", "X15. Y5. R5."),
                Text("X10.1 Y0.2", "X15.1 Y5.2 I0. J5."),
                "N20..N30",
                new(0.1, 0.2, 0)).Failures.Select(f => f.Message));
    }

    // More words than most blocks have, more bytes than most lines, and words that a line does not need.
    [Theory]
    [InlineData("X10. Y0. Z0. F100 S1000 M3 (A) (B) (C) (D)", "X10.1 Y0.2 Z0. F100 S1000 M3 (A) (B) (C) (D)")]
    [InlineData("X10. Y0. Z0. F100 S1000 M3 (A) (B) (C) (D)", "X10.1 Y0.2 Z0. F100 S1000 M3 (A) (B) (C) (E)", "N20: " + Other)]
    [InlineData("X10. Y0. " + Comment, "X10.1 Y0.2 " + Comment)]
    [InlineData("X10. Y0. " + Comment, "X10.1 Y0.2 " + Comment + " ", "N20: " + Other)]
    [InlineData("X10. Y0. I0.", "X10.1 Y0.2 I0.")]
    [InlineData("X10. Y0. I0.", "X10.1 Y0.2 I1.", "N20: " + Other)]
    [InlineData("X10. Y0. R0.", "X10.1 Y0.2 R1.", "N20: " + Other)]
    [InlineData("X5. X10. Y0.", "X5. X10.1 Y0.2", "N20: it changed although its words alone do not say where it goes.")]
    public void Only_the_words_of_the_place_change_in_a_long_block(string was, string now, params string[] found)
    {
        const string Before = "G90 G17\nG0 X0. Y0. Z0.\nN20 G1 F100 WORDS\nN25 X20. Y5.\nG0 Z5.\n";
        var proof = Verdict.OnEnds(
            Before.Replace("WORDS", was, StringComparison.Ordinal),
            Before.Replace("WORDS", now, StringComparison.Ordinal),
            "N20",
            new(0.1, 0.2, 0));

        Assert.Equal(found, proof.Failures.Select(f => f.Message).Where(m => !m.Contains(" lies ", StringComparison.Ordinal)));
    }

    // The last line of a file may have no line end.
    [Theory]
    [InlineData("M30", "M30")]
    [InlineData("M30 ", "M30", "line 4: " + Other)]
    [InlineData("M30", "M30 ", "line 4: " + Other)]
    public void The_last_bytes_count(string was, string now, params string[] found)
    {
        const string Head = "G90 G17\nG0 X0. Y0. Z0.\nN20 G1 ";

        Assert.Equal(found, Found($"{Head}X10. Y0. F100\n{was}", $"{Head}X10.1 Y0.2 F100\n{now}", "N20", new(0.1, 0.2, 0)));
    }

    // So many motions that two threads compare them, in parts, and fewer than one part holds.
    [Fact]
    public void Each_block_of_a_long_program_is_compared()
    {
        const int Blocks = 10_005;
        var (before, after) = (Lines(""), Lines(".1"));
        var path = Bench.Read(Text(before));
        var wish = Bench.Usable(DisplacementWish.EndsBy(path, [.. Enumerable.Range(2, Blocks)], new(0.1, 0, 0)));
        Assert.Empty(Prover.Check(path, NcProgram.FromText(Text(after)), wish, 0.001).Failures);

        after[0] += "(A)";
        after[5_000] += "(A)";
        after[Blocks - 1] += "(A)";
        var lines = Prover.Check(path, NcProgram.FromText(Text(after)), wish, 0.001).Failures.Select(f => f.Place.Line);
        Assert.Equal([3, 5_003, Blocks + 2], lines);

        string[] Lines(string moved) => [.. Enumerable.Range(0, Blocks).Select(i => $"G1 X{i % 7}{moved} F100")];
        static string Text(string[] lines) => "G90 G17 G21\nG0 X-1. Y0. Z0.\n" + string.Join('\n', lines) + "\nG0 Z5.\nX50.\n";
    }

    // N26 begins and ends where it did; the way its place is written stays.
    [Theory]
    [InlineData("N26 X30. Y5.")]
    [InlineData("N26 X30.0 Y5.", "N26: " + Other)]
    [InlineData("N26 X30. Y05.", "N26: " + Other)]
    public void A_block_that_did_not_move_keeps_its_words(string block, params string[] found)
    {
        const string Before = "G90 G17\nG0 X0. Y0. Z0.\nN20 G1 X10. F100\nN25 X20. Y5.\nN26 X30. Y5.\nG0 Z5.\n";
        var after = Before.Replace("N20 G1 X10.", "N20 G1 X10.1 Y0.2", StringComparison.Ordinal)
            .Replace("N26 X30. Y5.", block, StringComparison.Ordinal);

        Assert.Equal(found, Found(Before, after, "N20", new(0.1, 0.2, 0)));
    }

    private static string[] Found(string before, string after, string blocks, Vector3 by)
    {
        var proof = Verdict.OnEnds(before, after, blocks, by);
        Assert.Equal(proof.Holds, proof.UntouchedBytesIdentical);
        return [.. proof.Failures.Select(f => f.Message)];
    }
}
