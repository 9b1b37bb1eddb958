using System.Text;
using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Jobs.Tests;

public sealed class DraftFolderTests
{
    private static readonly DateTimeOffset At = new(2026, 11, 22, 5, 0, 0, TimeSpan.Zero);

    [Fact]
    public void What_was_kept_is_found_by_whoever_comes_next()
    {
        using var folder = new TemporaryFolder();
        var program = DraftProgram.Of("N10 G0 X0\n"u8.ToArray());
        var draft = RandomDraft.Of(3) with { Program = program };
        new DraftFolder(folder.Path).Keep(Stored("A/B", RandomDraft.Of(2)));
        new DraftFolder(folder.Path).Keep(Stored("A/B", draft));
        var found = new DraftFolder(folder.Path).Find("A/B")!;
        Assert.Equal(("anna", At, "00"), (found.By, found.At, found.BaseSha256));
        Assert.True(draft.IsSame(found.Draft));
        Assert.Equal(program.Bytes.ToArray(), found.Draft.Program!.Bytes.ToArray());
        Assert.Null(new DraftFolder(folder.Path).Find("A"));
    }

    [Fact]
    public void What_is_forgotten_leaves_nothing()
    {
        using var folder = new TemporaryFolder();
        var drafts = new DraftFolder(folder["drafts"]);
        drafts.Forget("A");
        drafts.Keep(Stored("A", RandomDraft.Of(1) with { Program = DraftProgram.Of("N10\n"u8.ToArray()) }));
        drafts.Keep(Stored("B", RandomDraft.Of(1)));
        drafts.Forget("A");
        Assert.Null(drafts.Find("A"));
        Assert.Single(Directory.GetFiles(folder["drafts"]));
        Assert.NotNull(drafts.Find("B"));
    }

    [Theory]
    [InlineData("")]
    [InlineData("{")]
    [InlineData("null")]
    [InlineData("{\"Job\":\"A\",\"By\":null,\"At\":\"2026-11-22T05:00:00+00:00\",\"BaseSha256\":\"\",\"Draft\":{}}")]
    [InlineData("{\"Job\":\"B\",\"By\":\"x\",\"At\":\"2026-11-22T05:00:00+00:00\",\"BaseSha256\":\"\",\"Draft\":{}}")]
    [InlineData("{" + Head + "\"Draft\":{\"Program\":{\"Sha256\":\"../../x\"}}}")]
    [InlineData("{" + Head + "\"Draft\":{\"Document\":null}}")]
    [InlineData("{" + Head + "\"Draft\":{\"Document\":{},\"Features\":[null]}}")]
    [InlineData("{" + Head + "\"Draft\":{\"Document\":{},\"Features\":[{\"Document\":{\"kind\":\"line\"},\"Flanks\":[]}]}}")]
    [InlineData("{" + Head + "\"Draft\":{\"Document\":{},\"Features\":[{\"Document\":{\"kind\":\"Line\"},\"Flanks\":[[]]}]}}")]
    [InlineData("{" + Head + "\"Draft\":{\"Document\":{},\"Program\":{\"Sha256\":\"../../x\"}}}")]
    public void What_is_no_draft_is_an_error_and_can_be_forgotten(string content)
    {
        using var folder = new TemporaryFolder();
        var drafts = new DraftFolder(folder.Path);
        drafts.Keep(Stored("A", RandomDraft.Of(1)));
        File.WriteAllText(Directory.GetFiles(folder.Path)[0], content, Encoding.UTF8);
        Assert.Throws<InputException>(() => drafts.Find("A"));
        drafts.Forget("A");
        Assert.Null(drafts.Find("A"));
    }

    // Earlier versions kept a field of their own for each key.
    [Fact]
    public void What_an_earlier_version_kept_is_refused_as_such()
    {
        using var folder = new TemporaryFolder();
        var drafts = new DraftFolder(folder.Path);
        drafts.Keep(Stored("A", RandomDraft.Of(1)));
        File.WriteAllText(
            Directory.GetFiles(folder.Path)[0], "{" + Head + "\"Draft\":{\"Name\":\"a\",\"Features\":[]}}", Encoding.UTF8);
        var refused = Assert.Throws<InputException>(() => drafts.Find("A"));
        Assert.Contains("unsaved changes of this version", refused.Message, StringComparison.Ordinal);
    }

    private const string Head = "\"Job\":\"A\",\"By\":\"x\",\"At\":\"2026-11-22T05:00:00+00:00\",\"BaseSha256\":\"\",";

    private static StoredDraft Stored(string job, MatingDraft draft) =>
        new() { Job = job, By = "anna", At = At, BaseSha256 = "00", Draft = draft };
}
