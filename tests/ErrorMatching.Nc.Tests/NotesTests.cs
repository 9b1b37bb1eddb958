namespace ErrorMatching.Nc.Tests;

public class NotesTests
{
    [Theory]
    [InlineData("G641 ADIS=0.1", "smoothing", 1)]
    [InlineData("COMPCAD", "smoothing", 1)]
    [InlineData("TRAORI", "opaque-transform", 1)]
    [InlineData("CYCLE978(101,,,1,,,\"\")", "cycle-not-followed", 1)]
    [InlineData("G641\nG642", "smoothing", 2)]
    public void What_the_control_does_that_is_not_followed_is_a_note_and_no_problem(string blocks, string code, long count)
    {
        var path = Bench.Read($"G90 G17 G71\nG0 X0 Y0 Z5\n{blocks}\nG1 X1 F100\n", NcDialects.Siemens840D);
        var note = Assert.Single(path.Notes);
        Assert.Equal((code, 2, count), (note.Code, note.Block, note.Count));
        Assert.Empty(path.Problems);
    }

    // Its first argument says what else it does than to touch.
    [Theory]
    [InlineData("0,,,1,-12.5,2,2,1,1,1,\"\"", true)]
    [InlineData("100,1,,1,-12.5,2,2,1,1,1,\"\"", false)]
    [InlineData("R1,1,,1,-12.5,2,2,1,1,1,\"\"", false)]
    [InlineData("", false)]
    public void A_cycle_that_only_touches_is_a_probing_move_to_an_unknown_place(string arguments, bool measures)
    {
        var path = Bench.Read($"G90 G17 G71\nG0 X0 Y0 Z5\nCYCLE978({arguments})\nG1 X1 F100\n", NcDialects.Siemens840D);
        var motion = path.Motions[^2];
        Assert.Equal(measures ? MotionKind.Probe : MotionKind.Cycle, motion.Kind);
        Assert.Equal(AxisSet.All, motion.UnknownEnd);
        Assert.Equal(AxisSet.Y | AxisSet.Z, path.Motions[^1].UnknownEnd);
        Assert.Equal(measures, path.Notes.All(n => n.Code != "cycle-not-followed"));
    }

    [Fact]
    public void Arcs_that_lead_to_a_contour_and_away_from_it_are_noted()
    {
        const string Program = "1 L X-9 Y-9 Z-1 R0 FMAX\n2 APPR LCT X+0 Y+0 R2 RL F100\n3 L X+10\n4 DEP CT CCA90 R+2\n";
        var path = Bench.Read(Program, NcDialects.HeidenhainKlartext);
        Assert.Equal([1, 3], path.UnfollowedWays);
        var note = Assert.Single(path.Notes);
        Assert.Equal(("way-not-followed", 1, 2L), (note.Code, note.Block, note.Count));
        Assert.StartsWith("APPR LCT: ", note.Message, StringComparison.Ordinal);
        Assert.Empty(Bench.Read(Program.Replace("LCT X+0 Y+0 R2", "LT X+0 Y+0 LEN2", StringComparison.Ordinal)
            .Replace("CT CCA90 R+2", "LT LEN2", StringComparison.Ordinal), NcDialects.HeidenhainKlartext).UnfollowedWays);
    }

    // What is said of a program is not said of others in its file; a number that is not called is not run.
    [Theory]
    [InlineData("fanuc", "O1\nG0 X0. Y0.\nM30\nO2\nG1 X9. F100\nM30\nO3\nM30\n", "O0002", 2)]
    [InlineData("fanuc", "O1\nG0 X0. Y0.\nM98 P2\nM30\nO2\nG1 X9. F100\nM99\nO3\nM30\n", "O0003", 1)]
    [InlineData("fanuc", "O1\nG0 X0. Y0.\nO2\nG1 X9. F100\nM30\n", "O0002", 1)]
    [InlineData("siemens-840d", "%_N_A_MPF\nG0 X0 Y0\nM30\n%_N_B_MPF\nG0 X5\nM30\n", "_N_B_MPF", 1)]
    public void Programs_that_follow_in_the_file_are_noted(string dialect, string program, string name, long count)
    {
        var note = Assert.Single(Bench.Read(program, NcDialects.Named(dialect)).Notes, n => n.Code == "programs-follow");
        Assert.Equal(count, note.Count);
        Assert.Contains(name, note.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("O1\nG0 X0. Y0.\nM98 P2\nM30\nO2\nG1 X9. F100\nM99\n%\n")]
    [InlineData("%\nO1\nG0 X0. Y0.\nM30\n%\n")]
    public void Programs_that_are_called_are_not(string program) =>
        Assert.DoesNotContain(Bench.Read(program, NcDialects.FanucMill).Notes, n => n.Code == "programs-follow");

    [Theory]
    [InlineData("G2 X100. R1000000. F100.", true)]
    [InlineData("G2 X100. R999999. F100.", false)]
    [InlineData("G2 X100. Y0. I50. J-1000000. F100.", true)]
    [InlineData("G20\nG2 X4. R39371. F10.", true)]
    [InlineData("G20\nG2 X4. R39370. F10.", false)]
    public void Arcs_of_kilometers_are_noted(string block, bool isNoted) =>
        Assert.Equal(isNoted, Bench.Read("G90 G17 G0 X0. Y0. Z0.\n" + block + "\n").Notes.Any(n => n.Code == "huge-arc"));

    [Theory]
    [InlineData("fanuc", "M98 <//CNC_MEM/USER/PATH1/O1000>", "//CNC_MEM/USER/PATH1/O1000")]
    [InlineData("haas", "M98 (SUB/O1000.NC)", "SUB/O1000.NC")]
    [InlineData("generic", "M97 <macros/bore>", "macros/bore")]
    [InlineData("generic", "M98 P\"0:/macros/bore.g\"", "0:/macros/bore.g")]
    public void A_call_by_a_path_of_the_machine_says_so(string dialect, string block, string path)
    {
        var refusal = Bench.Read($"G0 X0. Y0. Z0.\n{block}\nG1 X5. F100.\nM30\n", NcDialects.Named(dialect)).Refusal;
        Assert.Equal(NcRefusalCodes.MissingProgram, refusal?.Code);
        Assert.Contains($" {path} ", refusal!.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_note_about_a_program_in_another_file_stands_at_the_block_that_called_it()
    {
        var program = NcProgram.FromText("G90 G21\nG0 X0.\nM98 P7\nM30\n");
        var path = NcInterpreter.Run(
            program, NcDialects.Generic, _ => NcProgram.FromText("O7\nG1 X1. F100\nX2.\nX3.\nX4.\nX5.\n"), CancellationToken.None);
        Assert.Equal(("no-return", 2), (Assert.Single(path.Notes).Code, path.Notes[0].Block));
    }

    [Fact]
    public void A_refusal_in_another_file_names_the_block_that_called_and_the_place_there()
    {
        var program = NcProgram.FromText("G90 G21\nN20 M98 P7\nM30\n");
        var path = NcInterpreter.Run(
            program,
            NcDialects.Generic,
            n => n == "O0007" ? NcProgram.FromText("O7\nX1.\nX2.\nN40 M98 P8\nM99\n") : null,
            CancellationToken.None);
        Assert.Equal(("missing-program", "N20", 2), (path.Refusal!.Code, path.Refusal.Place.Block, path.Refusal.Place.Line));
        Assert.Contains("in O0007, N40: ", path.Refusal.Message, StringComparison.Ordinal);
    }
}
