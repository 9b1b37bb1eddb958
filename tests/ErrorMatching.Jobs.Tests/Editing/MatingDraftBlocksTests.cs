using ErrorMatching.Nc;
using ErrorMatching.Testing;

namespace ErrorMatching.Jobs.Tests;

/// <summary>Blocks of a draft's features are proposed where its key points and its program say so.</summary>
public sealed class MatingDraftBlocksTests
{
    private static readonly string Job = Repository.PathTo("samples", "complex-mating", "job.json");
    private static readonly NcPath Path = Interpreted(InputFile.Program(Repository.PathTo("samples", "complex-mating", "counterpart.nc")));

    [Theory]
    [InlineData("N10 N20..N30,N40", "N10|N20..N30|N40")]
    [InlineData(" /a, b/; /c d/ , N5 ", "/a, b/|/c d/|N5")]
    [InlineData("/^N8[0-9]{3}\\b/, /G0?3/", "/^N8[0-9]{3}\\b/|/G0?3/")]
    [InlineData("/a/b/, N1", "/a/b/|N1")]
    [InlineData("/a b, N1", "/a|b|N1")]
    [InlineData("//, /a/", "//|/a/")]
    [InlineData("", "")]
    public void Selectors_in_one_field_are_told_from_one_another(string text, string expected) =>
        Assert.Equal(expected, string.Join('|', new FeatureDraft { Blocks = text }.BlockList));

    [Fact]
    public void A_draft_with_nothing_but_points_and_program_gets_the_blocks_of_the_sample()
    {
        var draft = Without(MatingDraftFiles.Open(Job), 0, 1, 2) with { Name = "" };
        var proposed = MatingDraftBlocks.Propose(draft.With("$.counterpart.toolDiameterMm", "").With("$.counterpart.mapMm", ""), Path);
        Assert.Equal(
            [(0, "L1", "N120"), (1, "L2L3", "N130..N160"), (2, "C1", "N170..N1190")],
            proposed.Select(p => (p.Feature, p.Name, Assert.Single(p.Blocks))));
    }

    [Fact]
    public void The_frame_leads_from_the_part_to_the_program()
    {
        // Turned by 90 degrees and moved, and the frame leads back.
        var draft = Without(MatingDraftFiles.Open(Job), 0);
        var turned = draft.WithFeature(0, f => f with { Flanks = [[.. f.Flanks[0].Select(p => p with { X = Negative(p.Y), Y = p.X })]] });
        Assert.Equal(
            "N120",
            Assert.Single(
                Assert.Single(MatingDraftBlocks.Propose(
                    turned.With("$.counterpart.frame.rotateDeg", "-90"), Path)).Blocks));
        Assert.Empty(Assert.Single(MatingDraftBlocks.Propose(turned, Path)).Blocks);
    }

    [Fact]
    public void Nothing_is_proposed_for_what_has_blocks_or_lacks_a_point_or_lies_at_another_tool_s_distance()
    {
        var draft = MatingDraftFiles.Open(Job);
        Assert.Empty(MatingDraftBlocks.Propose(draft, Path));
        var lacking = Without(draft, 0).WithFeature(0, f => f with { Flanks = [[f.Flanks[0][0], f.Flanks[0][1] with { X = "" }]] });
        Assert.Empty(Assert.Single(MatingDraftBlocks.Propose(lacking, Path)).Blocks);
        Assert.Equal(
            "L1: fewer than two of its points have a place in the program. Give them their coordinates, or name the blocks yourself.",
            Assert.Single(MatingDraftBlocks.Propose(lacking, Path)).Refusal!.Message);
        var other = Assert.Single(MatingDraftBlocks.Propose(
            Without(draft, 0).With("$.counterpart.toolDiameterMm", "10"), Path));
        Assert.Empty(other.Blocks);
        Assert.Contains(" 5 mm", other.Refusal!.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Blocks_without_numbers_are_named_by_their_text()
    {
        var text = System.Text.Encoding.ASCII.GetString(
            InputFile.Program(Repository.PathTo("samples", "complex-mating", "counterpart.nc")).Span)
            .Replace("N120 ", "", StringComparison.Ordinal);
        var proposed = MatingDraftBlocks.Propose(
            Without(MatingDraftFiles.Open(Job), 0), Interpreted(System.Text.Encoding.ASCII.GetBytes(text)));
        Assert.Equal(@"/^X-34\.995\ Y59\.757$/", Assert.Single(Assert.Single(proposed).Blocks));
    }

    // An edited program has other blocks in the same lines: they must not be taken for those that somebody looked at.
    [Fact]
    public void Lines_are_kept_with_the_hash_of_their_program_and_go_with_it()
    {
        var (one, other) = (NcProgram.FromText("X1\nX2\nX2\n"), NcProgram.FromText("X0\nX1\nX2\nX2\n"));
        var draft = Without(MatingDraftFiles.Open(Job), 0, 1);
        Assert.Empty(MatingDraftBlocks.WithBlocks(draft, [(0, ["N120"])], one)["$.counterpart.programSha256"]);
        var lines = MatingDraftBlocks.WithBlocks(draft, [(0, ["L2"]), (1, ["L3"])], one);
        Assert.Equal(DraftProgram.Of(one.Bytes).Sha256, lines["$.counterpart.programSha256"]);

        // One more feature of another program: the line of the first one is gone, the number of the last one stays.
        var mixed = MatingDraftBlocks.WithBlocks(lines, [(1, ["L4"])], other);
        Assert.Equal(["", "L4", "N170..N1190"], mixed.Features.Select(f => f.Blocks));
        Assert.Equal(DraftProgram.Of(other.Bytes).Sha256, mixed["$.counterpart.programSha256"]);

        // What is added to a feature does not bring its old lines back; numbers instead of lines need no hash.
        var more = MatingDraftBlocks.WithBlocks(lines, [(0, ["L4"])], other, isMore: true);
        Assert.Equal(["L4", "", "N170..N1190"], more.Features.Select(f => f.Blocks));
        Assert.Equal("L2, L3", MatingDraftBlocks.WithBlocks(lines, [(0, ["L3"])], one, isMore: true).Features[0].Blocks);
        Assert.Empty(MatingDraftBlocks.WithBlocks(lines, [(0, ["N1"]), (1, ["N2"])], other)["$.counterpart.programSha256"]);

        // The same when another program is imported, and not when it is the same.
        var imported = MatingDraftBlocks.WithProgram(lines, DraftProgram.Of(other.Bytes), "other.nc");
        Assert.Equal(["", "", "N170..N1190"], imported.Features.Select(f => f.Blocks));
        Assert.Equal(("other.nc", ""), (imported["$.counterpart.program"], imported["$.counterpart.programSha256"]));
        Assert.Equal(lines.Features, MatingDraftBlocks.WithProgram(lines, DraftProgram.Of(one.Bytes), "one.nc").Features);

        // Lines of which nobody said whose they are stay, and nothing is said for them.
        var unsaid = lines.With("$.counterpart.programSha256", "");
        var added = MatingDraftBlocks.WithBlocks(unsaid, [(1, ["L4"])], other);
        Assert.Equal(("L2", "L4", ""), (added.Features[0].Blocks, added.Features[1].Blocks, added["$.counterpart.programSha256"]));
        Assert.Empty(MatingDraftBlocks.WithBlocks(unsaid, [(0, ["L4"]), (1, ["L4"])], other, isMore: true)["$.counterpart.programSha256"]);

        // Typed before the first program, they are for it.
        var typed = (unsaid with { Program = null }).With("$.counterpart.program", "");
        Assert.Equal("L2", MatingDraftBlocks.WithProgram(typed, DraftProgram.Of(one.Bytes), "one.nc").Features[0].Blocks);
    }

    private static NcPath Interpreted(ReadOnlyMemory<byte> bytes) =>
        NcInterpreter.Run(NcProgram.Read(bytes, NcDialects.DeltaNc300.Syntax), NcDialects.DeltaNc300);

    private static MatingDraft Without(MatingDraft draft, params int[] features) =>
        features.Aggregate(draft, (to, i) => to.WithFeature(i, f => f with { Blocks = "" }));

    private static string Negative(string number) => number.StartsWith('-') ? number[1..] : "-" + number;
}
