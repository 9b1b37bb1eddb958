using ErrorMatching.Jobs;
using ErrorMatching.Refusals;
using ErrorMatching.Testing;

namespace ErrorMatching.Cell.Tests;

/// <summary>A job is prepared beside the one that runs, which stays until somebody signs that another one takes its place.</summary>
public sealed class PreparedJobTests : PeopleTest
{
    private static readonly string Sample = Repository.PathTo("samples", "complex-mating");

    [Fact]
    public void Saving_a_new_job_leaves_the_running_one_byte_for_byte_and_takes_no_signature()
    {
        var (settings, edits, by) = Begin();
        var (running, before) = (settings.Jobs[0], Contents());
        Users.Demand(by, Act.EditJobs);
        var prepared = edits.Prepare(running, Anew(running), by);
        Assert.Equal(before, Contents());
        Assert.Equal(("one/Bracket", "m", "A"), (prepared.Name, prepared.Machine, prepared.Slot));
        Assert.Equal((true, false, running), (edits.IsInUse(running), edits.IsInUse(prepared), edits.PlaceOf(prepared)));
        Assert.Equal([prepared], edits.PreparedFor(running));

        // It is a job of its own, whole: what it names is with it, and what belongs to the cell is found from there.
        var job = InputFile.Job(prepared.File);
        Assert.Equal(("Bracket", "theoretical.csv", "counterpart.nc"), (job.Name, job.Part.Theoretical, job.Counterpart.Program));
        Assert.Equal(
            ["counterpart.nc", "job.json", "theoretical.csv"],
            Directory.GetFileSystemEntries(Path.GetDirectoryName(prepared.File)!)
                .Select(f => Path.GetFileName(f))
                .Order(StringComparer.Ordinal));
        Assert.Equal(PathOf(Path.Combine("one", "part.csv")), Path.GetFullPath(job.PathOf(job.Part.Measured)));
        Assert.StartsWith($"{by.Name} job-prepared one/Bracket job-files(job-file(theoretical.csv, ", Trail[^1], StringComparison.Ordinal);
        Assert.EndsWith($"; job-file(job.json, {JobEdits.Sha256Of(prepared)}))", Trail[^1], StringComparison.Ordinal);

        // The configuration is as it was: the cell runs what it names.
        Assert.Equal([running.File], CellSettingsReader.Read(PathOf("cell.json")).Jobs.Select(j => j.File));
    }

    [Fact]
    public void It_is_opened_changed_and_saved_again_and_both_versions_are_kept()
    {
        var (settings, edits, by) = Begin();
        var (running, before) = (settings.Jobs[0], Contents());
        var prepared = edits.Prepare(running, Anew(running), by);
        var first = MatingDraftFiles.Open(prepared.File);
        edits.Save(prepared, first with { Name = "Bracket 2", OtherPoints = [new("O", "1", "0")] }, JobEdits.Sha256Of(prepared), by);
        Assert.Equal(["Bracket 2", "Bracket"], edits.Versions(prepared).Select(v => v.Name));
        Assert.Empty(edits.Versions(running));
        edits.Save(prepared, edits.Open(prepared, edits.Versions(prepared)[1]), JobEdits.Sha256Of(prepared), by);
        Assert.True(first.IsSame(MatingDraftFiles.Open(prepared.File)));
        Assert.Equal(["Bracket", "Bracket 2", "Bracket"], edits.Versions(prepared).Select(v => v.Name));
        Assert.Equal(before, Contents());
        Refused(JobEditException.ChangedMeanwhile, () => edits.Save(prepared, first, new('0', 64), by));
    }

    [Fact]
    public void Putting_it_in_use_takes_a_signature_and_is_in_the_trail()
    {
        var (settings, edits, by) = Begin();
        var (running, was) = (settings.Jobs[0], MatingDraftFiles.Open(settings.Jobs[0].File));
        var (program, sha256) = (File.ReadAllBytes(PathOf(Path.Combine("one", "counterpart.nc"))), JobEdits.Sha256Of(running));
        var other = DraftProgram.Of(program.Append((byte)'\n').ToArray());
        var prepared = edits.Prepare(running, Anew(running) with { Program = other }, by);
        var draft = MatingDraftFiles.Open(prepared.File);
        Users.Demand(by, Act.EditJobs);
        Refused(PeopleError.NotSigned, () => edits.PutInUse(prepared, draft, sha256, by));
        Assert.Equal(sha256, JobEdits.Sha256Of(running));

        edits.PutInUse(prepared, draft, sha256, Anna());
        Assert.Equal("Bracket", InputFile.Job(running.File).Name);
        Assert.StartsWith("Anna job-edited one ", Trail[^1], StringComparison.Ordinal);
        Assert.EndsWith($"; job-file(job.json, {JobEdits.Sha256Of(running)})), {sha256})", Trail[^1], StringComparison.Ordinal);
        Assert.Equal(program, File.ReadAllBytes(PathOf(Path.Combine("one", "counterpart.nc"))));
        var inUse = PathOf(Path.Combine("one", InputFile.Job(running.File).Counterpart.Program));
        Assert.Equal(other.Bytes.ToArray(), File.ReadAllBytes(inUse));
        Assert.Equal(["Bracket", was.Name], edits.Versions(running).Select(v => v.Name));
        Assert.Equal(was.Name, edits.Open(running, edits.Versions(running)[1]).Name);

        // What was put in use is prepared as before, and what somebody saved in between is not replaced.
        Assert.Equal([prepared], edits.PreparedFor(running));
        Refused(JobEditException.ChangedMeanwhile, () => edits.PutInUse(prepared, draft, sha256, Anna()));
        Assert.Null(new AuditTrail(Store, Keys).Verify().Fault);
    }

    [Fact]
    public void Only_what_was_seen_is_put_in_use()
    {
        var (settings, edits, by) = Begin();
        var (running, sha256) = (settings.Jobs[0], JobEdits.Sha256Of(settings.Jobs[0]));
        var prepared = edits.Prepare(running, Anew(running), by);
        var seen = MatingDraftFiles.Open(prepared.File);

        // Another station moves a point: the job's own file stays the same.
        edits.Save(prepared, seen with { OtherPoints = [new("O", "1", "0")] }, JobEdits.Sha256Of(prepared), by);
        Refused(JobEditException.ChangedMeanwhile, () => edits.PutInUse(prepared, seen, sha256, Anna()));
        File.Delete(Path.Combine(Path.GetDirectoryName(prepared.File)!, "theoretical.csv"));
        Assert.Throws<InputException>(() => edits.PutInUse(prepared, seen, sha256, Anna()));
        File.WriteAllText(prepared.File, "{}");
        Refused(JobEditException.ChangedMeanwhile, () => edits.PutInUse(prepared, seen, sha256, Anna()));
        Assert.Equal(sha256, JobEdits.Sha256Of(running));
    }

    [Theory]
    [InlineData("", JobEditException.NotAName)]
    [InlineData("../x", JobEditException.NotAName)]
    [InlineData("..", JobEditException.NotAName)]
    [InlineData("a\\b", JobEditException.NotAName)]
    [InlineData("C:x", JobEditException.NotAName)]
    [InlineData(".hidden", JobEditException.NotAName)]
    [InlineData("end.", JobEditException.NotAName)]
    [InlineData("con", JobEditException.NotAName)]
    [InlineData("LPT1.a", JobEditException.NotAName)]
    [InlineData("a\u202eb", JobEditException.NotAName)]
    [InlineData("a\u0007b", JobEditException.NotAName)]
    [InlineData("a\ud842", JobEditException.NotAName)]
    [InlineData("BRACKET", JobEditException.NameTaken)]
    [InlineData("file", JobEditException.NameTaken)]
    [InlineData("link", JobEditException.NameTaken)]
    [InlineData("broken", JobEditException.NameTaken)]
    public void A_name_that_is_taken_or_that_no_folder_can_have_is_refused(string name, string code)
    {
        var (settings, edits, by) = Begin();
        var running = settings.Jobs[0];
        edits.Prepare(running, Anew(running), by);
        edits.Prepare(running, Anew(running) with { Name = " 托架 \U00020bb7 " }, by);
        var saved = running.File + ".saved";
        File.WriteAllText(Path.Combine(saved, "file"), "");
        Directory.CreateSymbolicLink(Path.Combine(saved, "link"), PathOf("in"));
        Directory.CreateSymbolicLink(Path.Combine(saved, "broken"), PathOf("nowhere"));
        var before = Contents(SearchOption.AllDirectories);
        Refused(code, () => edits.Prepare(running, Anew(running) with { Name = name }, by));
        Assert.Equal(before, Contents(SearchOption.AllDirectories));
        Assert.Equal(["one/Bracket", "one/托架 \U00020bb7"], edits.PreparedFor(running).Select(j => j.Name));
    }

    [Fact]
    public void Where_saved_jobs_would_lie_behind_a_link_nothing_is_written()
    {
        var (settings, edits, by) = Begin();
        Directory.CreateDirectory(PathOf("elsewhere"));
        Directory.CreateSymbolicLink(settings.Jobs[0].File + ".saved", PathOf("elsewhere"));
        Refused(JobEditException.NoFolder, () => edits.Prepare(settings.Jobs[0], Anew(settings.Jobs[0]), by));
        Assert.Empty(Directory.EnumerateFileSystemEntries(PathOf("elsewhere")));
        Assert.Empty(edits.PreparedFor(settings.Jobs[0]));
    }

    [Fact]
    public void A_saved_job_writes_into_its_own_folder_alone()
    {
        var (settings, edits, by) = Begin();
        var (running, before) = (settings.Jobs[0], Contents());
        var prepared = edits.Prepare(running, Anew(running), by);
        var draft = MatingDraftFiles.Open(prepared.File);
        var outside = (draft with { OtherPoints = [new("O", "1", "0")] }).With("$.part.theoretical", "../../theoretical.csv");
        Refused(JobEditException.Shared, () => edits.Save(prepared, outside, JobEdits.Sha256Of(prepared), by));

        // Nor is a folder that became a link meanwhile followed.
        var folder = Path.GetDirectoryName(prepared.File)!;
        Directory.Move(folder, folder + " before");
        Directory.CreateSymbolicLink(folder, PathOf("one"));
        var sha256 = JobEdits.Sha256Of(prepared);
        Refused(JobEditException.NoFolder, () => edits.Save(prepared, draft with { Program = null }, sha256, by));
        Assert.Equal(before, Contents());
        Assert.Throws<ArgumentException>(() => edits.PlaceOf(running with { File = PathOf(Path.Combine("one", "other.json")) }));
    }

    [Fact]
    public void Who_may_not_prepare_jobs_and_what_is_wrong_leaves_nothing()
    {
        var (settings, edits, by) = Begin();
        var running = settings.Jobs[0];
        Refused(JobEditException.Wrong, () => edits.Prepare(running, Anew(running) with { Features = [] }, by));
        Users.Add(Users.SignIn("Anna", Right), "Ben", Role.Operator, Other);
        Refused(PeopleError.NotAllowed, () => edits.Prepare(running, Anew(running), Users.SignIn("Ben", Other)));
        Assert.False(Path.Exists(running.File + ".saved"));
        Assert.DoesNotContain(Trail, e => e.Contains("job-prepared", StringComparison.Ordinal));
    }

    [Fact]
    public void Where_writing_fails_nothing_of_it_is_left()
    {
        var (settings, edits, by) = Begin();
        var running = settings.Jobs[0];
        edits.Prepare(running, Anew(running), by);

        // The program is written after the points, and its name is one that no file can have.
        var program = DraftProgram.Of(File.ReadAllBytes(PathOf(Path.Combine("one", "counterpart.nc"))));
        var draft = Anew(running) with { Name = "Second", Program = program };
        var unwritable = draft.With("$.counterpart.program", new string('x', 300));
        var before = Contents(SearchOption.AllDirectories);
        Assert.Throws<OutputException>(() => edits.Prepare(running, unwritable, by));
        Assert.Equal(before, Contents(SearchOption.AllDirectories));
        Assert.Equal(["one/Bracket"], edits.PreparedFor(running).Select(j => j.Name));
        Assert.DoesNotContain(Trail, e => e.Contains("Second", StringComparison.Ordinal));

        // And where the trail cannot tell of it, it is not saved.
        Store.Dispose();
        Assert.ThrowsAny<Exception>(() => edits.Prepare(running, draft, by));
        Assert.Equal(before, Contents(SearchOption.AllDirectories));
    }

    private static void Refused(string code, Action save) => Assert.Equal(code, Assert.Throws<JobEditException>(save).Code);

    private static MatingDraft Anew(CellJobSettings running) =>
        MatingDraftFiles.Open(running.File) with { Name = "Bracket", IsBegunAnew = true };

    private List<(string Name, string Sha256)> Contents(SearchOption depth = SearchOption.TopDirectoryOnly) =>
    [
        .. Directory.EnumerateFileSystemEntries(PathOf("one"), "*", depth).Where(f => !f.EndsWith(".saved", StringComparison.Ordinal))
            .Order(StringComparer.Ordinal)
            .Select(f => (f, new FileInfo(f) is { Exists: true, LinkTarget: null } ? Convert.ToHexString(File.ReadAllBytes(f)) : "")),
    ];

    private (CellSettings Settings, JobEdits Edits, SignedIn By) Begin()
    {
        Directory.CreateDirectory(PathOf("one"));
        foreach (var file in Directory.EnumerateFiles(Sample))
        {
            File.Copy(file, PathOf(Path.Combine("one", Path.GetFileName(file))));
        }

        Directory.CreateDirectory(PathOf("in"));
        Directory.CreateDirectory(PathOf("machine"));
        var cell = PathOf("cell.json");
        File.WriteAllText(cell, """
            { "kind": "cell", "name": "test", "store": { "kind": "sqlite", "file": "run/cell.db" }, "keys": "run/keys", "logs": "run/logs",
              "gauges": [{ "name": "cmm", "incoming": "in", "files": "*.csv", "format": "points", "finished": { "atRestS": 0.5 } }],
              "machines": [{ "name": "m", "dialect": "delta-nc300", "transport": { "kind": "folder", "folder": "machine" },
                "slots": [{ "name": "A", "program": "P.NC" }] }],
              "jobs": [{ "name": "one", "job": "one/job.json", "gauges": ["cmm"], "recognize": { "fileName": "^part" },
                "machine": "m", "slot": "A" }],
              "policy": { "approve": "person" } }
            """);
        var settings = CellSettingsReader.Read(cell);
        return (settings, new(settings, Store, Users), Anna());
    }
}
