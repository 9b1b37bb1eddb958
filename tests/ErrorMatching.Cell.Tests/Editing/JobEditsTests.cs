using ErrorMatching.Jobs;
using ErrorMatching.Testing;

namespace ErrorMatching.Cell.Tests;

/// <summary>An edited job takes the place of the one that stands there as a whole, with evidence, or not at all.</summary>
public sealed class JobEditsTests : PeopleTest
{
    private static readonly string Sample = Repository.PathTo("samples", "complex-mating");

    [Fact]
    public void A_setter_s_edit_is_the_job_and_stands_in_the_trail_before_it()
    {
        var (settings, edits, by) = Begin();
        var draft = MatingDraftFiles.Open(settings.Jobs[0].File) with
        {
            Name = "Edited",
            Program = DraftProgram.Of(File.ReadAllBytes(Path.Combine(Sample, "counterpart.nc")).Append((byte)'\n').ToArray())
        };
        var saved = edits.Save(settings.Jobs[0], draft, JobEdits.Sha256Of(settings.Jobs[0]), by);
        Assert.Equal(JobEdits.Sha256Of(settings.Jobs[0]), saved);
        Assert.Equal("Edited", InputFile.Job(settings.Jobs[0].File).Name);
        Assert.Equal(draft.Program.Bytes.ToArray(), File.ReadAllBytes(PathOf(Path.Combine("one", "counterpart.nc"))));
        Assert.StartsWith(
            $"{by.Name} job-edited one job-in-place(job-files(job-file(theoretical.csv, ",
            Trail[^1],
            StringComparison.Ordinal);
        Assert.Contains($"; job-file(counterpart.nc, {draft.Program.Sha256}); ", Trail[^1], StringComparison.Ordinal);
        Assert.Contains($"; job-file(job.json, {saved})), ", Trail[^1], StringComparison.Ordinal);
    }

    [Fact]
    public void What_is_wrong_or_was_changed_meanwhile_is_not_saved()
    {
        var (settings, edits, by) = Begin();
        var job = settings.Jobs[0];
        var (draft, sha256, was) = (
            MatingDraftFiles.Open(job.File) with { Name = "Edited" }, JobEdits.Sha256Of(job), File.ReadAllBytes(job.File));
        Refused(JobEditException.Wrong, () => edits.Save(job, draft with { Name = "" }, sha256, by));
        Refused(JobEditException.ChangedMeanwhile, () => edits.Save(job, draft, new('0', 64), by));
        Refused(
            JobEditException.Wrong,
            () => edits.Save(job, draft.With("$.counterpart.dialect", "fanuc"), sha256, by));
        Refused(
            JobEditException.Wrong,
            () => edits.Save(job, draft.With("$.compensation.from", "counterpart"), sha256, by));
        Assert.Equal(was, File.ReadAllBytes(job.File));
        Assert.DoesNotContain(Trail, e => e.Contains("job-edited", StringComparison.Ordinal));
    }

    [Fact]
    public void A_file_of_another_job_is_not_changed_with_it()
    {
        var (settings, edits, by) = Begin();
        File.Copy(PathOf(Path.Combine("one", "job.json")), PathOf(Path.Combine("one", "second.json")));
        settings = settings with
        {
            Jobs = [settings.Jobs[0], settings.Jobs[0] with { Name = "second", File = PathOf(Path.Combine("one", "second.json")) }]
        };
        edits = new(settings, Store, Users);
        var (draft, sha256) = (MatingDraftFiles.Open(settings.Jobs[0].File), JobEdits.Sha256Of(settings.Jobs[0]));
        Refused(JobEditException.Shared, () => edits.Save(settings.Jobs[0], draft with { OtherPoints = [new("O", "0", "0")] }, sha256, by));
        edits.Save(settings.Jobs[0], draft with { Name = "Edited", OtherPoints = draft.OtherPoints }, sha256, by);
    }

    [Fact]
    public void Every_version_is_kept_and_can_be_opened_and_saved_again()
    {
        var (settings, edits, by) = Begin();
        var job = settings.Jobs[0];
        Assert.Empty(edits.Versions(job));
        var (first, was) = (MatingDraftFiles.Open(job.File), File.ReadAllBytes(job.File));
        var program = File.ReadAllBytes(PathOf(Path.Combine("one", "counterpart.nc")));
        var other = DraftProgram.Of(program.Append((byte)'\n').ToArray());
        edits.Save(job, first with { Name = "Edited", Program = other, OtherPoints = [new("O", "0", "0")] }, JobEdits.Sha256Of(job), by);

        // What nobody had saved here was kept when something took its place.
        var versions = edits.Versions(job);
        Assert.Equal((2, by.Name), (versions.Count, versions[1].By));
        Assert.Equal(["theoretical.csv", "counterpart.nc", "job.json"], versions[1].Files.Select(f => f.Name));
        Assert.Equal(was, Store.Content(versions[1].Sha256));
        Assert.Equal("Edited", edits.Open(job, versions[0]).Name);

        // Restored it is a new saved version, signed like any other.
        var restored = edits.Open(job, versions[1]);
        Assert.True(first.IsSame(restored with { Program = null }));
        var unsigned = Assert.Throws<PeopleException>(() => edits.Save(job, restored, JobEdits.Sha256Of(job), by));
        Assert.Equal(PeopleError.NotSigned, unsigned.Error);
        edits.Save(job, restored, JobEdits.Sha256Of(job), Users.SignIn("Anna", Right));
        Assert.Equal(program, File.ReadAllBytes(PathOf(Path.Combine("one", "counterpart.nc"))));
        Assert.True(first.IsSame(MatingDraftFiles.Open(job.File)));
        Assert.Equal(3, edits.Versions(job).Count);
    }

    [Fact]
    public void A_new_job_gets_files_of_its_own_and_writes_into_none_of_the_job_before()
    {
        var (settings, edits, by) = Begin();
        var job = settings.Jobs[0];
        var (first, points) = (MatingDraftFiles.Open(job.File), PathOf(Path.Combine("one", "theoretical.csv")));
        var program = PathOf(Path.Combine("one", "counterpart.nc"));
        var (pointsWere, programWas) = (File.ReadAllBytes(points), File.ReadAllBytes(program));
        var anew = first with
        {
            Name = "Bracket",
            IsBegunAnew = true,
            OtherPoints = [new("O", "0", "0")],
            Program = DraftProgram.Of(programWas.Append((byte)'\n').ToArray()),
        };
        Refused(JobEditException.Shared, () => edits.Save(job, anew, JobEdits.Sha256Of(job), by));
        edits.Save(job, JobEdits.WithOwnFiles(job, anew), JobEdits.Sha256Of(job), by);
        Assert.Equal(pointsWere, File.ReadAllBytes(points));
        Assert.Equal(programWas, File.ReadAllBytes(program));
        var saved = InputFile.Job(job.File);
        Assert.Equal(("theoretical-2.csv", "counterpart-2.nc"), (saved.Part.Theoretical, saved.Counterpart.Program));
        Assert.Equal(["Bracket", first.Name], edits.Versions(job).Select(v => edits.Open(job, v).Name));
    }

    private static void Refused(string code, Action save) => Assert.Equal(code, Assert.Throws<JobEditException>(save).Code);

    private (CellSettings Settings, JobEdits Edits, SignedIn By) Begin()
    {
        Directory.CreateDirectory(PathOf("one"));
        foreach (var file in Directory.EnumerateFiles(Sample))
        {
            File.Copy(file, PathOf(Path.Combine("one", Path.GetFileName(file))));
        }

        // As an editor left it: points in the order of the features.
        var draft = MatingDraftFiles.Open(PathOf(Path.Combine("one", "job.json")));
        File.WriteAllBytes(PathOf(Path.Combine("one", "theoretical.csv")), MatingDraftFiles.Theoretical(draft));
        Directory.CreateDirectory(PathOf("in"));
        Directory.CreateDirectory(PathOf("machine"));
        var cell = PathOf("cell.json");
        File.WriteAllText(cell, """
            { "kind": "cell", "name": "test", "store": { "kind": "sqlite", "file": "run/cell.db" }, "keys": "run/keys", "logs": "run/logs",
              "gauges": [{ "name": "cmm", "incoming": "in", "files": "*.csv", "format": "points", "finished": { "atRestS": 0.5 } }],
              "machines": [{ "name": "m", "dialect": "delta-nc300", "transport": { "kind": "folder", "folder": "machine" }, "slots": [{ "name": "A", "program": "P.NC" }] }],
              "jobs": [{ "name": "one", "job": "one/job.json", "gauges": ["cmm"], "recognize": { "fileName": "^part" }, "machine": "m", "slot": "A" }],
              "policy": { "approve": "person" } }
            """);
        var settings = CellSettingsReader.Read(cell);
        Users.AddFirst("Anna", Right);
        return (settings, new(settings, Store, Users), Users.SignIn("Anna", Right));
    }
}
