using System.Security.Cryptography;
using Avalonia;
using Avalonia.Controls;
using ErrorMatching.Cell;
using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi.Tests;

/// <summary>A new job is begun at the beginning, is called what it is, is saved under that name beside the one that runs, and takes its
/// place only where somebody signs that.</summary>
public sealed class NewJobTests
{
    [Fact]
    public Task A_new_job_is_read_from_the_first_side() => SetupSeat.AtAsync(ScreenKeys.System, seat =>
    {
        seat.Seat.Tap("side-gauge").Tap("setup-anew");
        seat.Settle();
        Assert.True(((TabItem)seat.Seat.See("side-coordinates")).IsSelected);
        seat.Seat.Tap("side-gauge").Tap("nav-points").Tap("setup-anew").Tap("nav-system");
        Assert.True(((TabItem)seat.Seat.See("side-coordinates")).IsSelected);

        // Whoever only comes back to it finds the side where they were.
        seat.Seat.Tap("side-gauge").Tap("nav-points").Tap("nav-system");
        Assert.True(((TabItem)seat.Seat.See("side-gauge")).IsSelected);
    });

    [Fact]
    public Task The_box_has_the_name_of_the_draft_and_says_that_it_is_not_saved() => SetupSeat.AtAsync(ScreenKeys.Points, seat =>
    {
        Assert.Equal(("Complex mating", "complex-mating"), (seat.TextOf("setup-job-title"), seat.TextOf("setup-job-state")));
        seat.Seat.Tap("setup-anew");
        Assert.Equal(("New job", "Not saved · complex-mating"), (seat.TextOf("setup-job-title"), seat.TextOf("setup-job-state")));
        seat.Seat.Type("edit-name", "Bracket");
        Assert.Equal(("Bracket", "Not saved · complex-mating"), (seat.TextOf("setup-job-title"), seat.TextOf("setup-job-state")));
        BothLanguages.Take(seat.Seat, "setup-job-unsaved");
        InAllSizes(seat);
        seat.Seat.Tap("setup-discard");
        Assert.Equal(("Complex mating", "complex-mating"), (seat.TextOf("setup-job-title"), seat.TextOf("setup-job-state")));
    });

    [Fact]
    public Task A_new_job_is_saved_beside_the_one_that_runs_without_a_signature() => SetupSeat.AtAsync(ScreenKeys.System, seat =>
    {
        var (here, editing, folder) = (seat.Seat, seat.Shell.Editing, Path.GetDirectoryName(seat.JobFile)!);
        var before = Contents(folder);
        SetUp(seat);
        var places = Places();
        here.Tap("setup-save").WaitFor(() => editing.Notice is not null, "It is not saved.");
        Assert.Null(here.Find("signing-subject"));
        Assert.Equal(before, Contents(folder));
        seat.Settle();
        Assert.Equal(places, Places());
        Assert.Equal(("Bracket", "Not used · complex-mating"), (seat.TextOf("setup-job-title"), seat.TextOf("setup-job-state")));
        Assert.Equal(
            "Saved as complex-mating/Bracket. It is not in use: complex-mating still runs at vmc1, slot A.", seat.TextOf("setup-notice"));
        BothLanguages.Take(here, "setup-saved-beside");
        InAllSizes(seat);

        // It is opened, changed and saved as any other, and both of its versions are kept.
        editing.Change("", d => d.With("$.workOrder", "WO-9"));
        seat.Settle();
        Assert.Equal("Not saved: complex-mating still runs at vmc1, slot A.", seat.TextOf("setup-state"));
        Assert.False(here.See("setup-put-in-use").IsEffectivelyEnabled);
        here.User.Wait(TimeSpan.FromMilliseconds(600));
        here.Tap("setup-save").WaitFor(() => editing.Notice is not null && editing.Versions.Count == 2, "A change is not saved.");
        Assert.Null(here.Find("signing-subject"));
        editing.Choose(editing.Jobs[0]);
        seat.Settle();
        Assert.Equal("Complex mating", editing.Draft.Name);
        editing.Choose(Beside(editing));
        seat.Settle();
        Assert.Equal(("Bracket", "WO-9"), (editing.Draft.Name, editing.Draft["$.workOrder"]));
        here.Tap("side-gauge").Tap(editing.Versions[1].AutomationId);
        here.WaitFor(() => editing.Draft["$.workOrder"] != "WO-9", "The first version is not brought back.");
        seat.Settle();
        Assert.Contains(" · Bracket · ", editing.Versions[1].Text, StringComparison.Ordinal);
        Assert.Equal(before, Contents(folder));
        var entries = here.Station.Store.AuditEntries(0, 1000).Where(e => e.What.StartsWith("job-", StringComparison.Ordinal));
        Assert.Equal(
            [("job-prepared", "complex-mating/Bracket"), ("job-prepared", "complex-mating/Bracket")],
            entries.Select(e => (e.What, e.Subject)));

        (int X, int Y)[] Places() =>
        [
            .. new[] { "setup-undo", "setup-save", "setup-step", "side-gauge", "points-paste", "dry-run-file", "dry-run" }
                .Select(id => here.See(id).TranslatePoint(default, here.Window)!.Value).Select(p => ((int)p.X, (int)p.Y)),
        ];
    });

    [Fact]
    public Task It_takes_the_place_of_the_one_that_runs_only_where_somebody_signs_that() => SetupSeat.AtAsync(ScreenKeys.System, seat =>
    {
        var (job, here) = (File.ReadAllBytes(seat.JobFile), seat.Seat);
        here.Cell.Run();
        here.Cell.Deliver(1, 0);
        here.WaitFor(1, CorrectionState.Proposed);
        SaveBeside(seat);
        here.Tap("setup-put-in-use").See("signing-subject");
        Assert.Equal("Bracket", here.TextOf("signing-subject"));
        Assert.Equal(
            "The old job and its files are kept and can be restored. "
            + "From the next measurement on, vmc1, slot A uses Bracket instead of Complex mating.",
            here.TextOf("signing-consequence"));
        Assert.Equal(
            [
                new Fact(
                    "Waiting corrections of the old job: 1. Once the new job is in use, you can recalculate them.", Severity.Attention),
                new("Saving removes the comments in its file.", Severity.Attention)],
            here.Shell.Signing!.Facts);

        // What a gauge runs changes by a signature alone, as a program does at its machine.
        Assert.NotNull(here.Find("signing-password"));
        Assert.False(here.See("signing-confirm").IsEffectivelyEnabled);
        BothLanguages.Take(here, "setup-replace");
        here.Tap("signing-leave");
        seat.Settle();
        Assert.Equal(job, File.ReadAllBytes(seat.JobFile));

        here.User.Wait(TimeSpan.FromMilliseconds(600));
        PutInUse(seat);
        Assert.Equal("Bracket", InputFile.Job(seat.JobFile).Name);
        Assert.Equal(("Bracket", "complex-mating"), (seat.TextOf("setup-job-title"), seat.TextOf("setup-job-state")));
        Assert.NotNull(here.Find("setup-recalculate"));

        // From now on it is the one that is used, and edited as any other.
        seat.Shell.Editing.Change("", d => d.With("$.workOrder", "WO-9"));
        seat.Settle();
        here.User.Wait(TimeSpan.FromMilliseconds(600));
        here.Save().WaitFor(() => seat.Shell.Editing.Notice is not null, "An ordinary change is not saved.");
        Assert.Equal("WO-9", InputFile.Job(seat.JobFile).WorkOrder);
    });

    [Fact]
    public Task Where_the_station_locks_while_it_is_asked_nothing_is_put_in_use_and_it_can_be_later() =>
        SetupSeat.AtAsync(ScreenKeys.System, seat =>
    {
        var job = File.ReadAllBytes(seat.JobFile);
        SaveBeside(seat);
        seat.Seat.Tap("setup-put-in-use").See("signing-subject");
        seat.Shell.SignOut.Execute(null);
        seat.Seat.WaitFor(() => seat.Shell.IsLocked, "The station does not lock.").SignIn(DemoCell.Setter);
        Assert.Equal(job, File.ReadAllBytes(seat.JobFile));
        PutInUse(seat);
        Assert.Equal("Bracket", InputFile.Job(seat.JobFile).Name);
    });

    [Fact]
    public Task A_name_that_is_taken_or_is_none_is_refused_in_words() => SetupSeat.AtAsync(ScreenKeys.System, seat =>
    {
        var (here, editing) = (seat.Seat, seat.Shell.Editing);
        SaveBeside(seat);
        SetUp(seat);
        here.Tap("setup-save").WaitFor(() => seat.TextOf("setup-message") is not null, "It is not refused.");
        Assert.Equal(
            "A saved job has this workpiece name already. Give the new one another name, or open the saved one and change it.",
            seat.TextOf("setup-message"));
        BothLanguages.Take(here, "setup-name-taken");
        editing.Change("", d => d with { Name = "../Bracket" });
        seat.Settle();
        here.User.Wait(TimeSpan.FromMilliseconds(600));
        here.Tap("setup-save").WaitFor(() => seat.TextOf("setup-message") is not null, "It is not refused.");
        Assert.StartsWith("A saved job cannot be called so: ", seat.TextOf("setup-message"), StringComparison.Ordinal);
        Assert.True(editing.IsChanged);
    });

    [Fact]
    public Task A_new_job_that_was_kept_is_still_another_one_and_one_that_was_taken_back_is_not() =>
        SetupSeat.AtAsync(ScreenKeys.System, seat =>
    {
        SetUp(seat);
        var kept = new DraftFolder(Path.Combine(
            Path.GetDirectoryName(seat.Seat.Station.Settings.File)!, "drafts")).Find(seat.Shell.Editing.Job!.Name);
        Assert.True(kept!.Draft.IsBegunAnew);
        seat.Shell.Editing.Undo.Execute(null);
        seat.Shell.Editing.Undo.Execute(null);
        seat.Shell.Editing.Change("", d => d.With("$.workOrder", "WO-9"));
        seat.Settle();
        seat.Seat.Save().WaitFor(() => seat.Shell.Editing.Notice is not null, "What was taken back is asked about.");
        Assert.Equal("Complex mating", InputFile.Job(seat.JobFile).Name);
    });

    [Fact]
    public Task A_new_job_leaves_the_files_of_the_one_before_alone_and_that_one_can_be_restored() =>
        SetupSeat.AtAsync(ScreenKeys.System, seat =>
    {
        var (here, editing, folder) = (seat.Seat, seat.Shell.Editing, Path.GetDirectoryName(seat.JobFile)!);
        var before = MatingDraftFiles.Open(seat.JobFile);
        var (points, program) = (Path.Combine(folder, before["$.part.theoretical"]), Path.Combine(folder, before["$.counterpart.program"]));
        var (pointsWere, programWas) = (File.ReadAllBytes(points), File.ReadAllBytes(program));
        SetUp(seat);
        var imported = DraftProgram.Of(programWas.Append((byte)'\n').ToArray());
        editing.Change("", d => d with { OtherPoints = [new("O", "0", "0")], Program = imported });
        seat.Settle();
        here.Tap("setup-save").WaitFor(() => editing.Notice is not null, "It is not saved.");
        seat.Settle();
        PutInUse(seat);
        here.WaitFor(() => editing.Versions.Count == 2, "The versions are not read.");
        Assert.Equal("Bracket", InputFile.Job(seat.JobFile).Name);
        Assert.Equal(pointsWere, File.ReadAllBytes(points));
        Assert.Equal(programWas, File.ReadAllBytes(program));

        // The job before is a version: brought back into the form it is not yet saved, and saving it takes a signature.
        here.Tap("side-gauge").Tap(editing.Versions[1].AutomationId);
        here.WaitFor(() => editing.Draft.Name == before.Name, "It is not brought back.");
        seat.Settle();
        Assert.Equal("Bracket", InputFile.Job(seat.JobFile).Name);
        here.Save().WaitFor(() => InputFile.Job(seat.JobFile).Name == before.Name && editing.Versions.Count == 3, "It is not restored.");
        Assert.Equal(programWas, File.ReadAllBytes(program));
        var words = here.Station.Store.AuditEntries(0, 1000).Select(e => e.What).Where(w => w.StartsWith("job-", StringComparison.Ordinal));
        Assert.Equal(["job-prepared", JobEdits.Found, JobEdits.Edited, JobEdits.Edited], words);
    });

    // What the sample has, set up anew under another name.
    private static void SetUp(SetupSeat seat)
    {
        var sample = MatingDraftFiles.Open(seat.JobFile);
        seat.Seat.Tap("setup-anew");
        seat.Shell.Editing.Change("", d => sample with { Name = "Bracket", IsBegunAnew = d.IsBegunAnew });
        seat.Settle();
        Assert.Empty(seat.Shell.Editing.Problems);
    }

    // The larger the targets, the less room has the box of jobs; in both languages everything in it is read.
    private static void InAllSizes(SetupSeat seat)
    {
        foreach (var touch in new[] { TouchSize.Large, TouchSize.Largest, TouchSize.Standard })
        {
            seat.Shell.Preferences.TouchSize = touch;
            foreach (var language in new[] { Language.TraditionalChinese, Language.English })
            {
                Texts.Current.Language = language;
                seat.Settle();
                Assert.Empty(Layout.Problems(seat.Seat.Window));
            }
        }
    }

    private static void SaveBeside(SetupSeat seat)
    {
        SetUp(seat);
        seat.Seat.Tap("setup-save").WaitFor(() => seat.Shell.Editing.Notice is not null, "It is not saved.");
        seat.Settle();
        seat.Seat.User.Wait(TimeSpan.FromMilliseconds(600));
    }

    private static void PutInUse(SetupSeat seat)
    {
        var (here, editing) = (seat.Seat, seat.Shell.Editing);
        here.Tap("setup-put-in-use").Type("signing-password", DemoCell.Password).Tap("signing-confirm");
        here.WaitFor(() => editing.Notice is not null && editing.Job == editing.Jobs[0], "It is not put in use.");
        seat.Settle();
    }

    private static CellJobSettings Beside(JobEditing editing) => editing.Jobs.Single(j => j.Name == "complex-mating/Bracket");

    // Of the running job: what lies in its folder itself.
    private static List<(string Name, string Sha256)> Contents(string folder) =>
    [
        .. Directory.EnumerateFiles(folder).Order(StringComparer.Ordinal)
            .Select(f => (Path.GetFileName(f), Convert.ToHexString(SHA256.HashData(File.ReadAllBytes(f))))),
    ];
}
