using ErrorMatching.Geometry;
using ErrorMatching.Testing;

namespace ErrorMatching.Nc.Tests;

/// <summary>
/// Small programs that look understood and are not, if a word of theirs is passed over: each is executed as its control does it, or
/// refused.
/// </summary>
public sealed class SilentHazardTests
{
    /// <summary>File, dialect, selector, displacement, and the blocks of the result that tell, or the code of the refusal.</summary>
    public static TheoryData<string, string, string, double, double, string> Files => new()
    {
        // The blocks from N100 on leave G91 active: what follows are increments.
        { "m97.nc", "fanuc", "N10", 0.1, 0.2, "N10 G1 X10.1 Y0.2 Z-1. F100|N20 X19.9 Y4.8" },
        { "m97.nc", "generic", "N10", 0.1, 0.2, "N10 G1 X10.1 Y0.2 Z-1. F100|N20 X19.9 Y4.8" },
        { "m198.nc", "fanuc", "N10", 0.1, 0.2, NcRefusalCodes.MissingProgram },
        { "m198.nc", "generic", "N10", 0.1, 0.2, NcRefusalCodes.MissingProgram },
        { "extcall.mpf", "siemens-840d", "N10", 0.1, 0.2, NcRefusalCodes.MissingProgram },
        { "extcall-path.mpf", "siemens-840d", "N10", 0.1, 0.2, NcRefusalCodes.MissingProgram },
        { "pcall.mpf", "siemens-840d", "N10", 0.1, 0.2, NcRefusalCodes.MissingProgram },

        // As rs274 executes them.
        { "m73.ngc", "linuxcnc", "N10", 0.1, 0.2, "N10 G1 X5.1 Y5.2 F100|N20 X6 Y5" },
        { "o-call-comment.ngc", "linuxcnc", "N10", 0.1, 0.2, "N10 G1 X5.1 Y2.2|N20 X8 Y2" },
        { "end-of-block.nc", "fanuc", "N20", 1, 1, NcRefusalCodes.UnknownState },
        { "block-skip.nc", "fanuc", "N30", 1, 1, NcRefusalCodes.UnknownCondition },
        { "block-skip.nc", "fanuc off", "N30", 1, 1, "/N20 X20.|N30 X21. Y11.|N40 X0. Y10." },

        // Passed over, the block behind the slash is no motion: N30 goes from X10.
        { "block-skip.nc", "fanuc on", "N30", 1, 1, "/N20 X20.|N30 X11. Y11.|N40 X0. Y10." },
    };

    [Theory]
    [MemberData(nameof(Files))]
    public void A_hazard_comes_out_right_or_is_refused(string file, string dialect, string selector, double x, double y, string expected)
    {
        var path = Path(file, dialect);
        var result = path.Refusal?.Code ?? Displaced(path, selector, new(x, y, 0));
        Assert.True(
            result == expected || (expected.Contains('|', StringComparison.Ordinal)
                && expected.Split('|').All(l => result.Split('\n').Contains(l))),
            $"{file} in {dialect}: {result}");
    }

    [Fact]
    public void A_leader_is_no_part_of_the_program()
    {
        var path = Path("nul-leader.nc", "fanuc");
        Assert.Equal("R0,0,0 L10,0,0", Moves.Of(path));
        Assert.Empty(path.Problems);
        Assert.Equal("leader 0", string.Join(' ', path.Notes.Where(n => n.Code == "leader").Select(n => $"{n.Code} {n.Block}")));
        Assert.True(NcCensus.Of(path.Program).RoundTrips);
    }

    [Theory]
    [InlineData("SENT BY PORT 2, 50 BLOCKS\n\n%\nO1\nG0 X1.\nM30\n%\n", "R1,?,?")]
    [InlineData("\0\0\0SHOP FILE %\nO1\nG0 X1.\nM30\n%\n", "R1,?,?")]
    [InlineData("\0\0%\nO1\nM98 P2\nG0 X1.\nM30\nO2\nG0 X2.\nM99\n%\n", "R2,?,? R1,?,?")]
    [InlineData("O1\nG0 X1.\nM30\n%\nO2\nG0 X2.\n", "R1,?,?")]
    [InlineData("(A LEADER OF 5 %)\nO1\nG0 X1.\nM30\n%\n", "R1,?,?")]
    [InlineData("O1 G91 (NAME)\nG0 X1.\nX1.\n", "R?,?,? R?,?,?")]
    public void A_program_begins_behind_its_leader(string text, string moves) =>
        Assert.Equal(moves, Moves.Of(Bench.Read(text, NcDialects.FanucMill)));

    [Theory]
    [InlineData("N10 G1 X5. ; Y20.", "fanuc", "words-behind-semicolon", "")]
    [InlineData("N10 G1 X5.;; G91;", "fanuc", "words-behind-semicolon", "")]
    [InlineData("N10 G1 X5.; (ROUGH); #1=5", "delta-nc300", "words-behind-semicolon", "")]
    [InlineData("N10 G1 X5. ; Y20.", "generic", "", "words-behind-semicolon")]
    [InlineData("N10 G1 X5. ;", "fanuc", "", "")]
    [InlineData("N10 G1 X5.; (ROUGH);", "fanuc", "", "")]
    [InlineData("N10 G1 X5. ; tool 1, 10 mm", "fanuc", "", "")]
    [InlineData("N10 G1 X5. (ROUGH; Y20.)", "fanuc", "", "")]
    [InlineData("N10 G1 X5. F100 ; Y20.", "linuxcnc", "", "")]
    [InlineData("N10 G1 X5. ; Y20.", "siemens-840d", "", "")]
    public void Words_behind_a_semicolon_are_never_passed_over_in_silence(string block, string dialect, string problem, string note)
    {
        var path = Bench.Read("G90 G17 G40 G0 X0. Y0. Z0.\n" + block + "\nX6.\n", NcDialects.Named(dialect));
        Assert.Equal(problem, string.Join(' ', path.Problems.Select(p => p.Code)));
        Assert.Equal(note, string.Join(' ', path.Notes.Where(n => n.Code != "number-without-point").Select(n => n.Code)));
        Assert.Equal(problem.Length > 0, path.Motions[2].UnknownEnd != AxisSet.None);
    }

    [Theory]
    [InlineData("M98 P2; X5.")]
    [InlineData("#1=5; X5.")]
    [InlineData("GOTO 10; X5.")]
    [InlineData("IF[1EQ1]GOTO 10; M30")]
    public void Words_behind_a_semicolon_of_a_statement_are_refused(string block) =>
        Assert.Equal(NcRefusalCodes.BadExpression, Bench.Read(block + "\nN10 M30\nO2\nM99\n", NcDialects.FanucMill).Refusal?.Code);

    [Theory]
    [InlineData("/M8")]
    [InlineData("/2 M1")]
    [InlineData("N5 / M5 M9 (STOP)")]
    [InlineData("/G4 X2.")]
    [InlineData("/G4 P500")]
    [InlineData("/S3000 M3")]
    [InlineData("/")]
    [InlineData("/(NOTHING)")]
    public void Blocks_that_change_nothing_may_stand_behind_a_slash(string block)
    {
        var text = "G90 G17 G40 G0 X0. Y0. Z0.\n" + block + "\nG1 X5. F100\nM30\n";
        var moves = Enum.GetValues<BlockSkip>().Select(s => Moves.Of(Bench.Read(text, NcDialects.FanucMill.With(s))));
        Assert.All(moves, m => Assert.Equal("R0,0,0 L5,0,0", m));
    }

    [Theory]
    [InlineData("fanuc", "/X7.", "L7,0,0 L5,0,0", "L5,0,0", true)]
    [InlineData("fanuc", "/3 G91", "L5,0,0", "L5,0,0", false)]
    [InlineData("fanuc", "/T2", "L5,0,0", "L5,0,0", false)]
    [InlineData("fanuc", "/M6", "L5,0,0", "L5,0,0", false)]
    [InlineData("fanuc", "/G55", "L5,?,?", "L5,0,0", false)]
    [InlineData("fanuc", "/M30", "", "L5,0,0", true)]
    [InlineData("fanuc", "/M98 P2", "L9,0,0 L5,0,0", "L5,0,0", true)]
    [InlineData("fanuc", "/#1=5", "L5,0,0", "L5,0,0", true)]
    [InlineData("fanuc", "/GOTO 9", "", "L5,0,0", true)]
    [InlineData("fanuc", "/F200", "L5,0,0", "L5,0,0", false)]
    [InlineData("siemens-840d", "/X7", "L7,0,0 L5,0,0", "L5,0,0", true)]
    [InlineData("siemens-840d", "/GOTOF N9", "", "L5,0,0", true)]
    [InlineData("linuxcnc", "/X7", "L7,0,0 L5,0,0", "L5,0,0", true)]
    public void Other_blocks_behind_a_slash_need_the_position_of_the_switch_unless_both_lead_to_the_same(
        string dialect, string block, string off, string on, bool isSame)
    {
        var text = $"G90 G17 G40\nG1 X0 Y0 Z0 F100\n{block}\nG1 X5\nN9 M30\n{(dialect == "fanuc" ? "O2\nG1 X9.\nM99\n" : "")}";
        var path = Bench.Read(text, NcDialects.Named(dialect));
        Assert.Equal(isSame ? (null, null) : (NcRefusalCodes.BlockSkip, 3), (path.Refusal?.Code, path.Refusal?.Place.Line));
        Assert.Equal(isSame, path.Notes.Any(n => n is { Code: "either-way" or "conditional-stop", Block: 2 }));
        foreach (var (position, moves) in new[] { (BlockSkip.Off, off), (BlockSkip.On, on) })
        {
            path = Bench.Read(text, NcDialects.Named(dialect).With(position));
            Assert.Null(path.Refusal);
            Assert.Contains(path.Notes, n => n is { Code: "block-skip", Block: 2 });
            Assert.Equal(block == "/3 G91" && position == BlockSkip.Off ? "L5,0,0" : moves, Moves.Of(path, 1));
        }
    }

    [Fact]
    public void Jumps_and_calls_do_not_find_blocks_that_are_passed_over()
    {
        var on = NcDialects.FanucMill.With(BlockSkip.On);
        Assert.Equal(NcRefusalCodes.MissingLabel, Bench.Read("GOTO 9\nG1 X1.\n/N9 M30\n", on).Refusal?.Code);
        Assert.Equal(NcRefusalCodes.MissingLabel, Bench.Read("M97 P9\nM30\n/N9 X1.\nM99\n", on).Refusal?.Code);
        Assert.Equal(NcRefusalCodes.MissingLabel, Bench.Read("WHILE[1EQ1]DO1\nG1 X1.\n/END1\n", on).Refusal?.Code);
        Assert.Equal(NcRefusalCodes.MissingProgram, Bench.Read("M98 P2\nM30\n/O2\nM99\n", on).Refusal?.Code);
    }

    [Fact]
    public void A_dialect_may_state_the_switch()
    {
        var dialect = OwnDialect.Of("""
            , "settings": { "blockSkip": { "value": "on", "statement": "Ours is on.", "source": "our tests" } }
            """);
        Assert.Equal(BlockSkip.On, dialect.BlockSkip);
        var off = dialect.With(BlockSkip.Off);
        Assert.Equal((BlockSkip.Off, dialect.Name, dialect.Facts), (off.BlockSkip, off.Name, off.Facts));
        Assert.Same(dialect, dialect.With(BlockSkip.On));
        Assert.Empty(Bench.Read("/G1 X5.\n", dialect).Motions);
    }

    private static string Displaced(NcPath path, string selector, Vector3 by)
    {
        var wish = DisplacementWish.EndsBy(path, Bench.Blocks(path, selector), by);
        var refusal = wish.Refusal ?? Rewriter.Apply(path, wish.Result!).Refusal;
        return refusal?.Code ?? Bench.Text(Bench.Rewritten(path, wish.Result!).Program);
    }

    private static NcPath Path(string file, string dialect)
    {
        var words = dialect.Split(' ');
        var position = words.Length == 1 ? BlockSkip.Unstated : words[1] == "on" ? BlockSkip.On : BlockSkip.Off;
        var bytes = File.ReadAllBytes(Repository.PathTo("tests", "ErrorMatching.Nc.Tests", "SilentHazards", file));
        return NcInterpreter.Run(NcProgram.Read(bytes), NcDialects.Named(words[0]).With(position));
    }
}
