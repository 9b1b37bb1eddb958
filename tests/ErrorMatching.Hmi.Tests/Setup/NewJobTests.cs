using Avalonia.Controls;
using ErrorMatching.Cell;
using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi.Tests;

/// <summary>A new job is begun at the beginning, is called what it is, and takes the place of one that is used only where somebody says so.</summary>
public sealed class NewJobTests
{
    [Fact]
    public Task A_new_job_is_read_from_the_first_side() => SetupSeat.AtAsync(Screens.System, seat =>
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
    public Task The_box_has_the_name_of_the_draft_and_says_that_it_is_not_saved() => SetupSeat.AtAsync(Screens.Points, seat =>
    {
        Assert.Equal(("Complex mating", "complex-mating"), (seat.TextOf("setup-job-title"), seat.TextOf("setup-job-state")));
        seat.Seat.Tap("setup-anew");
        Assert.Equal(("New job", "Not saved · complex-mating"), (seat.TextOf("setup-job-title"), seat.TextOf("setup-job-state")));
        seat.Seat.Type("edit-name", "Bracket");
        Assert.Equal(("Bracket", "Not saved · complex-mating"), (seat.TextOf("setup-job-title"), seat.TextOf("setup-job-state")));
        BothLanguages.Take(seat.Seat, "setup-job-unsaved");
        seat.Seat.Tap("setup-discard");
        Assert.Equal(("Complex mating", "complex-mating"), (seat.TextOf("setup-job-title"), seat.TextOf("setup-job-state")));
    });

    [Fact]
    public Task Another_job_takes_the_place_of_one_that_is_used_only_where_somebody_says_so() => SetupSeat.AtAsync(Screens.System, seat =>
    {
        var (job, here) = (File.ReadAllBytes(seat.JobFile), seat.Seat);
        here.Cell.Run();
        here.Cell.Deliver(1, 0);
        here.WaitFor(1, CorrectionState.Proposed);
        SetUp(seat);
        here.Tap("setup-save").See("signing-subject");
        Assert.Equal("Bracket", here.TextOf("signing-subject"));
        Assert.Equal(
            "The old job and its files are kept and can be restored. "
            + "From the next measurement on, vmc1, slot A uses Bracket instead of Complex mating.",
            here.TextOf("signing-consequence"));
        Assert.Equal(
            [new Fact("Waiting corrections of the old job: 1. After saving, you can recalculate them.", Severity.Attention), new("Saving removes the comments in its file.", Severity.Attention)], here.Shell.Signing!.Facts);

        // What a gauge runs changes by a signature alone, as a program does at its machine.
        Assert.NotNull(here.Find("signing-password"));
        Assert.False(here.See("signing-confirm").IsEffectivelyEnabled);
        BothLanguages.Take(here, "setup-replace");
        here.Tap("signing-leave");
        seat.Settle();
        Assert.Equal((true, null), (seat.Shell.Editing.IsChanged, seat.Shell.Editing.Notice));
        Assert.Equal(job, File.ReadAllBytes(seat.JobFile));

        here.User.Wait(TimeSpan.FromMilliseconds(600));
        here.Save().WaitFor(() => seat.Shell.Editing.Notice is not null, "It is not saved.");
        Assert.Equal("Bracket", InputFile.Job(seat.JobFile).Name);
        Assert.Equal(("Bracket", "complex-mating"), (seat.TextOf("setup-job-title"), seat.TextOf("setup-job-state")));

        // From now on it is the one that is used, and edited as any other.
        seat.Shell.Editing.Change("", d => d with { WorkOrder = "WO-9" });
        seat.Settle();
        here.User.Wait(TimeSpan.FromMilliseconds(600));
        here.Save().WaitFor(() => seat.Shell.Editing.Notice is not null, "An ordinary change is asked about.");
        Assert.Equal("WO-9", InputFile.Job(seat.JobFile).WorkOrder);
    });

    [Fact]
    public Task Where_the_station_locks_while_it_is_asked_nothing_is_saved_and_it_can_be_saved_again() => SetupSeat.AtAsync(Screens.System, seat =>
    {
        var job = File.ReadAllBytes(seat.JobFile);
        SetUp(seat);
        seat.Seat.Tap("setup-save").See("signing-subject");
        seat.Shell.SignOut.Execute(null);
        seat.Seat.WaitFor(() => seat.Shell.IsLocked, "The station does not lock.").SignIn(DemoCell.Setter);
        Assert.Equal(job, File.ReadAllBytes(seat.JobFile));
        seat.Seat.Save().WaitFor(() => seat.Shell.Editing.Notice is not null, "It is not saved.");
        Assert.Equal("Bracket", InputFile.Job(seat.JobFile).Name);
    });

    [Fact]
    public Task A_new_job_that_was_kept_is_still_another_one_and_one_that_was_taken_back_is_not() => SetupSeat.AtAsync(Screens.System, seat =>
    {
        SetUp(seat);
        var kept = new DraftFolder(Path.Combine(Path.GetDirectoryName(seat.Seat.Station.Settings.File)!, "drafts")).Find(seat.Shell.Editing.Job!.Name);
        Assert.True(kept!.Draft.IsBegunAnew);
        seat.Shell.Editing.Undo.Execute(null);
        seat.Shell.Editing.Undo.Execute(null);
        seat.Shell.Editing.Change("", d => d with { WorkOrder = "WO-9" });
        seat.Settle();
        seat.Seat.Save().WaitFor(() => seat.Shell.Editing.Notice is not null, "What was taken back is asked about.");
        Assert.Equal("Complex mating", InputFile.Job(seat.JobFile).Name);
    });

    [Fact]
    public Task A_new_job_leaves_the_files_of_the_one_before_alone_and_that_one_can_be_restored() => SetupSeat.AtAsync(Screens.System, seat =>
    {
        var (here, editing, folder) = (seat.Seat, seat.Shell.Editing, Path.GetDirectoryName(seat.JobFile)!);
        var before = MatingDraftFiles.Open(seat.JobFile);
        var (points, program) = (Path.Combine(folder, before.TheoreticalFile), Path.Combine(folder, before.Counterpart.Program));
        var (pointsWere, programWas) = (File.ReadAllBytes(points), File.ReadAllBytes(program));
        SetUp(seat);
        var imported = DraftProgram.Of(programWas.Append((byte)'\n').ToArray());
        editing.Change("", d => d with { OtherPoints = [new("O", "0", "0")], Program = imported });
        seat.Settle();
        here.Save().WaitFor(() => editing.Notice is not null && editing.Versions.Count == 2, "It is not saved.");
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
        Assert.Equal([JobEdits.Found, JobEdits.Edited, JobEdits.Edited], words);
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
}
