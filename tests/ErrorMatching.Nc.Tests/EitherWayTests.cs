namespace ErrorMatching.Nc.Tests;

/// <summary>Branches on values that only the machine knows: where both ways lead to the same, the program goes on; a result is right for
/// both; and where somebody states the value, the way is known.</summary>
public sealed class EitherWayTests
{
    private const string Head = "G90 G17 G40 G0 X0. Y0. Z5.\n";

    [Theory]

    // Nothing moves on either way.
    [InlineData("fanuc", "IF [#500 EQ 1] GOTO 10\nM8\nN10 G1 X5. F100.", "L5,0,5")]
    [InlineData("fanuc", "IF [#500 EQ 1] GOTO 10\nM8\nGOTO 20\nN10 M7\nN20 G1 X5. F100.", "L5,0,5")]
    [InlineData("fanuc", "IF [#500 EQ 1] THEN #101=2.\nG1 X5. F100.", "L5,0,5")]
    [InlineData("fanuc", "IF [#500 EQ 1] M8\nG1 X5. F100.", "L5,0,5")]
    [InlineData("fanuc", "IF [#500 EQ 1] GOTO 10\nIF [#501 EQ 1] GOTO 10\nM8\nN10 G1 X5. F100.", "L5,0,5")]
    [InlineData("linuxcnc", "o1 if [#<_task> EQ 0]\nM8\no1 else\nM7\no1 endif\nG1 X5 F100", "L5,0,5")]
    [InlineData("siemens-840d", "IF R5==1 GOTOF WEITER\nM8\nWEITER:\nG1 X5 F100", "L5,0,5")]
    [InlineData("okuma-osp", "IF [VC1 EQ 1] NLAP\nM8\nNLAP G1 X5 F100", "L5,0,5")]
    [InlineData("fanuc", "/M98 P100\nG1 X5. F100.\nM30\nO100\nM8\nM99", "L5,0,5")]

    // A mode that is the same on both ways, and a variable that is not: what hangs on it is unknown.
    [InlineData("fanuc", "IF [#500 EQ 1] GOTO 10\nG1\nN10 G1 X5. F100.", "L5,0,5")]
    [InlineData("fanuc", "#101=1.\nIF [#500 EQ 1] THEN #101=2.\nG1 X#101 F100.\nX7.", "L?,0,5 L7,0,5")]
    [InlineData("fanuc", "#101=1.\nIF [#500 EQ 1] THEN #101=1.\nG1 X#101 F100.", "L1,0,5")]
    [InlineData("fanuc", "IF [#500 EQ 1] THEN #5=2.\n#5=3.\nG1 X#5 F100.", "L3,0,5")]

    // A motion of one way only that leads back.
    [InlineData("fanuc", "IF [#500 EQ 1] GOTO 10\nG0 Z50.\nM0\nG0 Z5.\nN10 G1 X5. F100.", "R0,0,50 R0,0,5 L5,0,5", true)]
    [InlineData("fanuc", "/G0 Z50.\nG0 X0. Y0. Z5.\nG1 X5. F100.", "R0,0,50 R0,0,5 L5,0,5", true)]

    // A way that ends the program.
    [InlineData("fanuc", "IF [#500 EQ 1] GOTO 900\nG1 X5. F100.\nN900 G0 Z5.\nM30", "L5,0,5 R5,0,5", true)]
    [InlineData("linuxcnc", "o1 if [#5070 EQ 0]\nM2\no1 endif\nG1 X5 F100", "L5,0,5")]
    public void Where_both_ways_lead_to_the_same_the_program_goes_on(string dialect, string program, string moves, bool? isUncertain = null)
    {
        var path = Bench.Read(Head + program + "\n", NcDialects.Named(dialect));
        Assert.Null(path.Refusal);
        Assert.Equal(moves, Moves.Of(path, 1));
        Assert.Equal(isUncertain ?? false, path.UncertainBlocks.Count > 0);
        Assert.Contains(path.Notes, n => n.Code is "either-way" or "conditional-stop");
    }

    [Theory]
    [InlineData("fanuc", "IF [#500 EQ 1] GOTO 10\nG91\nN10 G1 X5. F100.", "unknown-condition")]
    [InlineData("fanuc", "IF [#500 EQ 1] GOTO 10\nG1 X3. F50.\nN10 G1 Y5. F100.", "unknown-condition")]
    [InlineData("fanuc", "IF [#500 EQ 1] GOTO 10\nG55\nN10 G1 X5. F100.", "unknown-condition")]
    [InlineData("fanuc", "IF [#500 EQ 1] GOTO 10\nG92 X1.\nN10 G1 X5. F100.", "unknown-condition")]
    [InlineData("fanuc", "IF [#500 EQ 1] GOTO 10\n#5221=1.\nN10 G1 X5. F100.", "unknown-condition")]
    [InlineData("fanuc", "IF [#500 EQ 1] GOTO 10\nT2 M6\nN10 G1 X5. F100.", "unknown-condition")]
    [InlineData("fanuc", "IF [#500 EQ 1] GOTO 10\nG43 H1\nN10 G1 X5. F100.", "unknown-condition")]
    [InlineData("fanuc", "IF [#500 EQ 1] GOTO 10\nM21\nG90 G1 X5. F100.\nM30\nN10 G1 X7. F100.\nM30", "unknown-condition")]
    [InlineData("fanuc", "IF [#500 EQ 1] GOTO 10\nG41 D1\nN10 G1 X5. F100.", "unknown-condition")]
    [InlineData("fanuc", "WHILE [#500 EQ 1] DO1\nM8\nEND1\nG1 X5. F100.", "unknown-condition")]

    // The piece is turned on one way only, whether the block is plain or has a comment.
    [InlineData("fanuc", "IF [#500 EQ 1] GOTO 10\nG0 A90.\nN10 G1 X5. F100.", "unknown-condition")]
    [InlineData("fanuc", "IF [#500 EQ 1] GOTO 10\nG0 A90. (TURN)\nN10 G1 X5. F100.", "unknown-condition")]
    [InlineData("fanuc", "IF [#500 EQ 1] GOTO 10\nG0 X0. Y0. Z5. B90.\nN10 G1 X5. F100.", "unknown-condition")]
    [InlineData("linuxcnc", "o1 if [#<_task> EQ 0]\nG0 A90\no1 endif\nG1 X5 F100", "unknown-condition")]
    [InlineData("linuxcnc", "o1 if [#<_task> EQ 0]\nG1 X0 Y0 Z5 A90 F100\no1 endif\nG1 X5 F100", "unknown-condition")]

    // Without an axis, all of them return to the reference point, A too.
    [InlineData("linuxcnc", "G0 A90\no1 if [#<_task> EQ 0]\nG28\nG0 X0 Y0 Z5\no1 endif\nG1 X5 F100", "unknown-condition")]
    [InlineData("fanuc", "IF [#500 EQ 1] GOTO 10\nG28\nG0 X0. Y0. Z5.\nN10 G1 X5. F100.", "unknown-condition")]
    [InlineData("siemens-840d", "IF R5==1 GOTOF WEITER\nG0 A90\nWEITER:\nG1 X5 F100", "unknown-condition")]
    [InlineData("okuma-osp", "IF [VC1 EQ 1] NLAP\nG0 A90\nNLAP G1 X5 F100", "unknown-condition")]
    [InlineData("fanuc", "IF [#500 EQ 1] GOTO 10\n/G1 X5. F100.\nN10 G1 Y7.", "unknown-condition")]
    [InlineData("fanuc", "/G0 X5.\nG1 Y5. F100.", "block-skip")]
    [InlineData("fanuc", "IF [#500 EQ 1] GOTO 10\nG68 X0. Y0. R30.\nN10 G1 X5. F100.", "unknown-condition")]

    // The same place is reached twice: what is compared is the first time.
    [InlineData("fanuc", "IF [#500 EQ 1] GOTO 10\n#1=1.\nN5 G91 G1 X1. F100.\nIF [#1 EQ 2.] GOTO 20\nN10 M8\nIF [#1 NE 1.] GOTO 20\n"
        + "#1=2.\nGOTO 5\n"
        + "N20 G90 G1 Y5.", "unknown-condition")]
    public void Where_they_do_not_the_program_is_refused(string dialect, string program, string code)
    {
        var path = Bench.Read(Head + program + "\n", NcDialects.Named(dialect));
        Assert.Equal(code, path.Refusal?.Code);
    }

    [Theory]
    [InlineData("G0 Q90.")]
    [InlineData("G0 Q90. (TURN)")]
    public void An_axis_of_the_shop_that_turns_on_one_way_is_a_difference(string turn)
    {
        var dialect = OwnDialect.Of(
            """, "letters": [{ "letters": "Q", "role": "other-axis", "statement": "Turns the table.", "source": "the machine" }]""");
        var path = Bench.Read($"{Head}IF [#500 EQ 1] GOTO 10\n{turn}\nN10 G1 X5. F100.\n", dialect);
        Assert.Equal("unknown-condition", path.Refusal?.Code);
    }

    [Fact]
    public void A_refusal_names_the_variable_and_what_to_do()
    {
        var path = Bench.Read(Head + "IF [#500 EQ 1] GOTO 10\nG91\nN10 G1 X5. F100.\n", NcDialects.FanucMill);
        Assert.Contains("#500", path.Refusal!.Message, StringComparison.Ordinal);
        Assert.Contains("--assume", path.Refusal!.Message, StringComparison.Ordinal);
    }

    // N30 and N40 are executed only where #500 is not 1.
    private const string Detour = "G90 G17 G40 G49 G0 X0. Y0. Z5.\nN10 G1 X10. F100.\nN20 Y10.\nG1 X20.\nIF [#500 EQ 1] GOTO 50\n"
        + "N30 G0 X30.\nN40 G0 X20.\nN50 G1 Y20. F100.\nN60 X0.\nM30\n";

    [Fact]
    public void A_displacement_away_from_the_ways_is_right_for_both()
    {
        var text = Bench.By(Detour, new(0.1, 0.2, 0), "N10", NcDialects.FanucMill);
        Assert.Contains("N10 G1 X10.1 Y0.2", text, StringComparison.Ordinal);
        foreach (var value in (double[])[0, 1])
        {
            var known = NcDialects.FanucMill.With(AssumedValues.Of([new("#500", value)]));
            Assert.Equal(Moves.Of(Bench.Read(Detour, known), 3), Moves.Of(Bench.Read(text, known), 3));
        }
    }

    [Theory]

    // The place where the ways part, one of the way's own, and the place where they meet.
    [InlineData("N50", "unknown-condition")]
    [InlineData("N30", "unknown-condition")]
    [InlineData("N40", "unknown-condition")]
    public void What_would_move_a_way_is_refused(string block, string code)
    {
        var refusal = Bench.RefusedBy(block == "N50" ? Detour.Replace("G1 X20.\n", "N50 G1 X20.\n", StringComparison.Ordinal)
            .Replace("N50 G1 Y20.", "N55 G1 Y20.", StringComparison.Ordinal).Replace("GOTO 50", "GOTO 55", StringComparison.Ordinal)
            : Detour, new(0.1, 0.2, 0), block, NcDialects.FanucMill);
        Assert.Contains(refusal.Code, (string[])[code, NcRefusalCodes.FrameChange]);
    }

    [Fact]
    public void The_proof_finds_a_change_on_a_way()
    {
        var path = Bench.Read(Detour, NcDialects.FanucMill);
        var wish = Bench.Usable(DisplacementWish.EndsBy(path, Bench.Blocks(path, "N10"), new(0.1, 0.2, 0)));
        var right = Bench.Text(Bench.Rewritten(path, wish).Program);
        var wrong = NcProgram.FromText(right.Replace("N30 G0 X30.", "N30 G0 X31.", StringComparison.Ordinal));
        Assert.False(Prover.Check(path, wrong, wish, 0.001).Holds);

        // Only on the way that is not shown: the other motion is the same.
        const string hidden = "G90 G17 G40 G49 G0 X0. Y0. Z5.\nN10 G1 X10. F100.\nN20 Y10.\nG1 X20.\nIF [#500 EQ 1] GOTO 30\nG0 X30.\n"
            + "G0 X31.\nG0 X20.\nGOTO 50\nN30 G0 X40.\nG0 X20.\nN50 G1 Y20. F100.\nM30\n";
        path = Bench.Read(hidden, NcDialects.FanucMill);
        wish = Bench.Usable(DisplacementWish.EndsBy(path, Bench.Blocks(path, "N10"), new(0.1, 0.2, 0)));
        right = Bench.Text(Bench.Rewritten(path, wish).Program);
        wrong = NcProgram.FromText(right.Replace("N30 G0 X40.", "N30 G0 X41.", StringComparison.Ordinal));
        Assert.False(Prover.Check(path, wrong, wish, 0.001).Holds);
    }

    [Theory]
    [InlineData("fanuc", "IF [#500 EQ 1] GOTO 10\nG1 X3. F50.\nN10 G1 Y5. F100.", "#500=1", "L0,5,5")]
    [InlineData("fanuc", "IF [#500 EQ 1] GOTO 10\nG1 X3. F50.\nN10 G1 Y5. F100.", "#500=2", "L3,0,5 L3,5,5")]
    [InlineData("fanuc", "G1 X#1 F100.", "#1=4.5", "L4.5,0,5")]
    [InlineData("fanuc", "#500=3.\nG1 X#500 F100.", "#500=4.5", "L3,0,5")]
    [InlineData("fanuc", "G1 X#5041 F100.", "#5041=4.5", "L4.5,0,5")]
    [InlineData("fanuc", "G65 P100 B2.\nM30\nO100\nG1 X#1 Y#2 F100.\nM99", "#1=4.5", "L0,2,5")]
    [InlineData("linuxcnc", "G1 X#<_hal[my.pin]> F100", "#<_hal[my.pin]>=4.5", "L4.5,0,5")]
    [InlineData("linuxcnc", "G1 X#100 F100", "#100=4.5", "L4.5,0,5")]
    [InlineData("linuxcnc", "G1 X#<_depth> F100", "#<_depth>=4.5", "L4.5,0,5")]
    [InlineData("siemens-840d", "G1 X=R5 F100", "R5=4.5", "L4.5,0,5")]
    [InlineData("siemens-840d", "G1 X=$A_DBR[4] F100", "$A_DBR[4]=4.5", "L4.5,0,5")]
    [InlineData("siemens-840d", "G1 X=_MASS F100", "_MASS=4.5", "L4.5,0,5")]
    [InlineData("okuma-osp", "G1 X=VC1 F100", "VC1=4.5", "L4.5,0,5")]
    public void A_stated_value_is_taken_until_the_program_sets_it(string dialect, string program, string assumed, string moves)
    {
        var stated = AssumedValues.Of([AssumedValues.Read(assumed)!.Value]);
        var path = Bench.Read(Head + program + "\n", NcDialects.Named(dialect).With(stated));
        Assert.Null(path.Refusal);
        Assert.Equal(moves, Moves.Of(path, 1));
        Assert.Contains(path.Notes, n => n.Code is "assumed" or "assumed-unused");
    }

    [Fact]
    public void A_wish_keeps_what_was_assumed_and_the_program_is_another_one_without()
    {
        const string Program = Head + "IF [#500 EQ 1] GOTO 10\nG91\nN10 G1 X5. F100.\nN20 Y5.\n";
        var path = Bench.Read(Program, NcDialects.FanucMill.With(AssumedValues.Of([new("#500", 1)])));
        var wish = Bench.Usable(DisplacementWish.EndsBy(path, Bench.Blocks(path, "N20"), new(0.1, 0, 0)));
        using var stream = new MemoryStream();
        WishFile.Of(path, wish, 0.001).WriteTo(stream);
        var read = WishFile.Read(stream.ToArray(), "wish.json");
        Assert.Equal([("#500", 1)], read.Assumed.Values.Select(v => (v.Key, v.Value)));
        Assert.True(read.IsAbout(Bench.Read(Program, NcDialects.FanucMill.With(read.Assumed)), "wish.json"));
        Assert.False(read.IsAbout(Bench.Read(Program, NcDialects.FanucMill.With(AssumedValues.Of([new("#500", 1.5)]))), "wish.json"));
        Assert.False(read.IsAbout(Bench.Read(Program, NcDialects.FanucMill), "wish.json"));

        // What is stated and not read changes nothing.
        Assert.Equal(path.Sha256,
            Bench.Read(Program, NcDialects.FanucMill.With(AssumedValues.Of([new("#500", 1), new("#501", 1)]))).Sha256);
        var bad = System.Text.Encoding.UTF8.GetString(stream.ToArray()).Replace("#500", "5;00", StringComparison.Ordinal);
        Assert.Throws<Refusals.InputException>(() => WishFile.Read(System.Text.Encoding.UTF8.GetBytes(bad), "wish.json"));
    }

    [Theory]
    [InlineData("#100")]
    [InlineData("=1")]
    [InlineData("#100=")]
    [InlineData("#100=x")]
    [InlineData("#100=NaN")]
    [InlineData("100=1")]
    [InlineData("#1 00;M30=1")]
    public void What_is_no_value_is_not_read(string text) => Assert.Null(AssumedValues.Read(text));

    [Fact]
    public void Many_branches_take_a_bounded_time()
    {
        var branches = string.Concat(Enumerable.Range(1, 2_000).Select(i => $"IF [#500 EQ {i}] GOTO {i}\nM8\nN{i} M9\n"));
        var text = Head + branches + "G1 X5. F100.\n";
        var path = Bench.Read(text, NcDialects.FanucMill);
        Assert.True(path.Refusal is null or { Code: NcRefusalCodes.UnknownCondition });
    }
}
