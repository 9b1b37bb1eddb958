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
