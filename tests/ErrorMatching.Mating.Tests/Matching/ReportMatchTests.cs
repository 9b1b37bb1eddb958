namespace ErrorMatching.Mating.Tests;

/// <summary>What the report of a match shows beside its numbers: blocks side by side, outlines, inputs.</summary>
public sealed class ReportMatchTests
{
    [Fact]
    public void Changed_words_are_marked_in_both_programs()
    {
        var match = new MatchCase(Programs.ToolBelow) { Part = "1 10 0.1; 2 40 0.2" };
        var report = match.Report();
        var blocks = report.Program.Blocks;

        Assert.Equal((match.Job.Name, match.Job.File, match.Job.Sha256), (report.Job.Name, report.Job.File, report.Job.Sha256));

        Assert.Equal(
            [("N40", 6, "N40 G1 X0. Y-3. F300", "N40 G1 X0. Y-2.933 F300"), ("N50", 7, "N50 X50.", "N50 X50. Y-2.767")],
            blocks.Select(b => (b.Number, b.Line, b.Original, b.Modified)));
        Assert.Equal(["-3."], Cut(blocks[0].Original, blocks[0].OriginalSpans));
        Assert.Equal(["-2.933"], Cut(blocks[0].Modified, blocks[0].ModifiedSpans));
        Assert.Equal([""], Cut(blocks[1].Original, blocks[1].OriginalSpans));
        Assert.Equal([" Y-2.767"], Cut(blocks[1].Modified, blocks[1].ModifiedSpans));
    }

    [Fact]
    public void Several_changed_words_of_a_block_are_marked_each()
    {
        var match = new MatchCase(Programs.FilletedNotch)
        {
            Theoretical = "1 3 -4; 2 9 -12; 3 21 -12; 4 27 -4",
            Part = "1 3.08 -3.94; 2 9.08 -11.94; 3 20.92 -11.94; 4 26.92 -3.94",
            Features = [MatchCase.Feature("triangle", "T1", "N50..N60", """[["1", "2"], ["3", "4"]]""")],
        };
        var report = match.Report();
        var arc = report.Program.Blocks.Single(b => b.Number == "N55");

        Assert.Equal(["17.4", "-16.8", "2.4", "1.8"], Cut(arc.Original, arc.OriginalSpans));
        Assert.Equal(["17.32", "-16.74", "2.32", "1.74"], Cut(arc.Modified, arc.ModifiedSpans));

        // N40 one, N50 two, N55 four, N60 one.
        Assert.Equal((4, 8), (report.Program.ChangedBlocks, report.Program.ChangedWords));
        Assert.Equal(["N40", "N70"], report.Proof.Neighbors.Select(n => n.Block).Order());
        Assert.InRange(report.Proof.MaxDeviationFromWantedMm, 0, 0.0005);
    }

    [Fact]
    public void Outlines_are_the_boundaries_in_the_parts_frame()
    {
        // The program's frame is mirrored and shifted; in the part's frame the boundary is y = 0 all the same, and the part is 0.1 high.
        var feature = (
            new MatchCase(Programs.ToolBelow)
            {
                Theoretical = "1 90 0; 2 120 0",
                Part = "1 90 0.1; 2 120 0.1",
                Frame = """{ "mirror": "y", "translateMm": [-80, 0] }"""
            }).Report().Features[0];

        Assert.Equal([(80, 0), (130, 0)], feature.TheoreticalOutline.Select(p => (Math.Round(p.X, 6), Math.Round(p.Y, 6))));
        Assert.Equal([(80, 0.1), (130, 0.1)], feature.CorrectedOutline.Select(p => (Math.Round(p.X, 6), Math.Round(p.Y, 6))));
        Assert.Equal([(90, 0.1), (120, 0.1)], feature.ActualOutline.Select(p => (Math.Round(p.X, 6), Math.Round(p.Y, 6))));
    }

    [Fact]
    public void Inputs_and_program_are_named_with_their_hashes()
    {
        var match = new MatchCase(Programs.ToolBelow)
        {
            Counterpart = "1 10 -0.04; 2 40 -0.04",
            Compensation = """{ "from": "counterpart" }"""
        };
        var report = match.Report();

        Assert.Equal(["theoretical", "part", "counterpart", "program"], report.Inputs.Select(i => i.Role));
        Assert.Equal(["part", "counterpart"], report.Alignments.Select(a => a.Role));
        Assert.Equal(match.Input.ProgramSha256, report.Inputs[^1].Sha256);
        Assert.Equal(
            ("out/counterpart.nc", Convert.ToHexStringLower(System.Security.Cryptography.SHA256.HashData(match.Match().Program.Span))),
            (report.Program.File, report.Program.Sha256));
    }

    private static IEnumerable<string> Cut(string text, IReadOnlyList<TextSpan> spans) =>
        spans.Select(s => text.Substring(s.Start, s.Length));
}
