using System.Text;
using System.Text.Json.Nodes;
using ErrorMatching.Testing;
using FsCheck;
using FsCheck.Fluent;

namespace ErrorMatching.Jobs.Tests;

/// <summary>A draft that is written and read again is the same draft, and a job that goes through one gives the same answer.</summary>
public sealed class MatingDraftFilesTests
{
    [Fact]
    public void A_draft_comes_back_from_its_files_as_it_was() => Prop.ForAll<int>(seed =>
    {
        var draft = RandomDraft.Of(seed);
        var (job, theoretical) = (MatingDraftFiles.Job(draft), MatingDraftFiles.Theoretical(draft));
        Assert.Equal(
            "", string.Join('\n', MatingDraftCheck.Run(draft, "job.json").Problems.Where(p => p.Field != MatingDraftCheck.Program)));
        Assert.Equal(
            Encoding.UTF8.GetString(draft.ToJson()), Encoding.UTF8.GetString(MatingDraftFiles.Read(job, "job.json", theoretical).ToJson()));
    }).QuickCheckThrowOnFailure();

    [Theory]
    [InlineData("complex-mating")]
    [InlineData("curve-mating")]
    [InlineData("circle-mating")]
    [InlineData("slot-mating")]
    public void A_job_that_went_through_a_draft_gives_the_same_report(string sample)
    {
        using var folder = new TemporaryFolder();
        foreach (var file in Directory.EnumerateFiles(Repository.PathTo("samples", sample)))
        {
            File.Copy(file, folder[Path.GetFileName(file)]);
        }

        var job = folder["job.json"];
        var before = Report(job);
        var draft = MatingDraftFiles.Open(job);
        Assert.Empty(MatingDraftCheck.Run(draft, job).Problems);
        File.WriteAllBytes(job, MatingDraftFiles.Job(draft));
        File.WriteAllBytes(folder["theoretical.csv"], MatingDraftFiles.Theoretical(draft));
        Assert.Equal(before, Report(job));
        Assert.True(draft.IsSame(MatingDraftFiles.Open(job)));
    }

    [Theory]
    [InlineData("\"N120\"", "\"/N12, 3/\", \"N120\"", "$.features[0].blocks")]
    [InlineData("\"6..14\"", "\"a,b\"", "$.verify[1].points")]
    public void What_would_be_lost_is_refused_by_its_place(string was, string now, string path)
    {
        var job = File.ReadAllText(Repository.PathTo("samples", "complex-mating", "job.json")).Replace(was, now, StringComparison.Ordinal);
        var theoretical = File.ReadAllBytes(Repository.PathTo("samples", "complex-mating", "theoretical.csv"));
        var error = Xunit.Record.Exception(() => MatingDraftFiles.Read(Encoding.UTF8.GetBytes(job), "job.json", theoretical));
        if (path.StartsWith("$.features", StringComparison.Ordinal))
        {
            // A comma inside of an expression is no separator.
            Assert.Null(error);
        }
        else
        {
            Assert.Equal(path, Assert.IsType<DraftException>(error).Path);
        }
    }

    [Fact]
    public void A_column_that_a_draft_has_no_field_for_is_refused()
    {
        var job = File.ReadAllBytes(Repository.PathTo("samples", "complex-mating", "job.json"));
        var theoretical = File.ReadAllText(Repository.PathTo(
            "samples", "complex-mating", "theoretical.csv")).Replace("\n", ",note\n", StringComparison.Ordinal);
        Assert.Equal(
            "$.part.theoretical",
            Assert.Throws<DraftException>(() => MatingDraftFiles.Read(job, "job.json", Encoding.UTF8.GetBytes(theoretical))).Path);
    }

    [Fact]
    public void Comments_are_seen()
    {
        Assert.True(MatingDraftFiles.HasComments(File.ReadAllBytes(Repository.PathTo("samples", "complex-mating", "job.json"))));
        Assert.False(MatingDraftFiles.HasComments(MatingDraftFiles.Job(RandomDraft.Of(1))));
    }

    // Everything but what names the job's own bytes.
    private static string Report(string job)
    {
        var outcome = MatingRun.Run(new(job), new(), TestContext.Current.CancellationToken);
        Assert.NotNull(outcome.Result);
        var report = JsonNode.Parse(outcome.Result.ReportJson())!.AsObject();
        report["job"]!.AsObject().Remove("sha256");
        foreach (var input in report["inputs"]!.AsArray().Where(i => i!["role"]!.GetValue<string>() == "theoretical"))
        {
            input!.AsObject().Remove("sha256");
        }

        return report.ToJsonString();
    }
}
