using Avalonia;
using Avalonia.Controls;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Nothing is decided by a finger that was on its way when something changed,
/// and what a person chose is there when they come back.</summary>
public sealed class DecidingTests
{
    [Fact]
    public Task The_oldest_that_waits_is_shown_rows_keep_their_places_and_what_was_approved_is_there_to_be_seen() => Seat.AtAsync(seat =>
    {
        Wait(seat, 1, 2);
        seat.SignIn(DemoCell.Setter).Tap("nav-compensation").See("pair");
        var screen = (CompensationViewModel)seat.Shell.Current!;
        Assert.Equal("#1 · 0001", seat.TextOf("detail-title"));
        Assert.Equal(
            new[] { 1L, 2L }.Select(id => (id, "Complex mating", Shown.Mm(seat.Station.Store.Find(id)!.LargestMm))),
            screen.Rows.Select(r => (r.Id, r.Job, r.Largest)));
        var approve = Place(seat, "approve");
        seat.Tap("approve").Type("signing-password", DemoCell.Password).Tap("signing-confirm");
        seat.WaitFor(() => seat.TextOf("detail-title") == "#2 · 0002", "The next one does not open.");
        Assert.Equal("#1 · 0001 is approved. This is the next one.", seat.TextOf("compensation-decided"));
        seat.Tap("correction-1");
        seat.WaitFor(
            () => seat.TextOf("detail-state") == "At the machine" && screen.Rows.First(r => r.Id == 1).State == "At the machine",
            "The screen does not follow.");
        Assert.Null(seat.Find("compensation-decided"));
        Assert.Equal("Is at vmc1/A as counterpart.nc", seat.TextOf("detail-target"));
        Assert.Equal([1L, 2L], screen.Rows.Select(r => r.Id));

        // What releases stands elsewhere and looks otherwise.
        Assert.False(approve.Intersects(Place(seat, "release")) || approve.Intersects(Place(seat, "revert")));
        Assert.DoesNotContain("accent", seat.See("release").Classes);
        seat.WaitFor(
            () => seat.Find("forbidden") is not null
                && seat.TextOf("forbidden") == "The slot had no program before, so there is none to restore.",
            "It is not said why nothing is restored.");

        // Cut and released, it stays to be seen, with nothing left to tap.
        seat.Cell.FinishPiece();
        seat.WaitFor(() => seat.TextOf("detail-state") == "Cut and released", "The screen does not follow the release.");
        Assert.Equal("#1 · 0001", seat.TextOf("detail-title"));
        Assert.All(new[] { "approve", "reject", "release", "revert" }, id => Assert.Null(seat.Find(id)));
        seat.WaitFor(
            () => seat.TextOf("forbidden") == "Nothing is left to decide for this piece. Choose another one on the left.",
            "It is not said that nothing is left.");

        // It is gone from the list, so a user who comes back begins at what waits. The list follows a moment after the piece itself.
        seat.WaitFor(() => screen.Rows.All(r => r.Id != 1), "The list does not follow the release.");
        seat.Tap("nav-overview").See("waiting-2");
        Assert.Equal("Complex mating", ((OverviewViewModel)seat.Shell.Current!).Waiting.Single().Job);
        seat.Tap("nav-compensation").WaitFor(
            () => seat.Find("detail-title") is not null && seat.TextOf("detail-title") == "#2 · 0002", "What waits is not shown.");
    });

    [Fact]
    public Task What_changes_by_itself_is_not_decided_about_for_a_second() => Seat.AtAsync(seat =>
    {
        Wait(seat, 1, 2);
        seat.SignIn(DemoCell.Setter).Tap("nav-compensation").See("pair");
        seat.WaitFor(() => seat.See("approve").IsEffectivelyEnabled, "Who comes to the screen has to wait.");

        // Somebody else decides at a console, and the next one takes its place under the finger.
        seat.Clock.Stand();
        new CorrectionDecisions(seat.Station.Store).Reject(1, DemoCell.Operator, "chip under the probe");
        seat.WaitFor(() => seat.TextOf("detail-title") == "#2 · 0002", "The next one is not shown.");
        Assert.False(seat.See("approve").IsEffectivelyEnabled);
        Assert.False(seat.See("reject").IsEffectivelyEnabled);
        Assert.Equal("This has just changed. You can decide in a moment.", seat.TextOf("forbidden"));
        seat.Clock.Advance(Pause.Length);
        seat.WaitFor(() => seat.See("approve").IsEffectivelyEnabled && seat.See("reject").IsEffectivelyEnabled, "The pause does not end.");

        // What is chosen by the person changes nothing under the finger, but its state may.
        new CorrectionDecisions(seat.Station.Store).Approve(2, DemoCell.Setter, null);
        seat.WaitFor(() => seat.Find("release") is not null, "The screen does not follow.");
        Assert.False(seat.See("release").IsEffectivelyEnabled);
        seat.Clock.Advance(Pause.Length);
        seat.WaitFor(() => seat.See("release").IsEffectivelyEnabled, "The pause does not end.");
    });

    [Fact]
    public Task The_next_one_opens_after_a_decision_and_takes_none_for_a_second() => Seat.AtAsync(seat =>
    {
        Wait(seat, 1, 2, 3);
        seat.SignIn(DemoCell.Setter).Tap("nav-compensation").See("pair");
        seat.Tap("correction-2").WaitFor(() => seat.TextOf("detail-title") == "#2 · 0002", "It is not shown.");
        seat.Clock.Stand();
        Reject("#3 · 0003");
        Assert.Equal("#2 · 0002 is rejected. This is the next one.", seat.TextOf("compensation-decided"));

        // A second tap meant for the one before decides nothing.
        Assert.False(seat.See("reject").IsEffectivelyEnabled);
        seat.Clock.Advance(Pause.Length);
        seat.WaitFor(() => seat.See("reject").IsEffectivelyEnabled, "The pause does not end.");

        // Below the last one begins the list again; after the very last one, that one stays.
        Reject("#1 · 0001");
        seat.Clock.Advance(Pause.Length);
        seat.WaitFor(() => seat.See("reject").IsEffectivelyEnabled, "The pause does not end.");
        Reject("#1 · 0001");
        seat.WaitFor(() => seat.TextOf("detail-state") == "Rejected", "What becomes of it is not shown.");

        void Reject(string next)
        {
            seat.Tap("reject").Type("signing-reason", "chip under the probe").Tap("signing-confirm");
            seat.WaitFor(() => seat.Shell.Signing is null && seat.TextOf("detail-title") == next, "The next one does not open.");
        }
    });

    [Fact]
    public Task Where_nothing_is_left_to_decide_nobody_is_told_to_wait() => Seat.AtAsync(seat =>
    {
        Wait(seat, 1);
        seat.SignIn(DemoCell.Setter).Tap("nav-compensation").See("pair");
        seat.Clock.Stand();
        seat.Tap("reject").Type("signing-reason", "chip under the probe").Tap("signing-confirm");
        seat.WaitFor(() => seat.TextOf("detail-state") == "Rejected", "The screen does not follow.");
        Assert.Equal("Nothing is left to decide for this piece. Choose another one on the left.", seat.TextOf("forbidden"));
    });

    [Fact]
    public Task What_a_person_chose_is_there_when_they_come_back_and_not_for_somebody_else() => Seat.AtAsync(seat =>
    {
        Wait(seat, 1, 2);
        seat.SignIn(DemoCell.Setter).Tap("nav-compensation").See("pair");
        Choose("correction-2", "detail-title", "#2 · 0002");
        seat.Tap("nav-verification").See("piece-title");
        Assert.Equal("#2 · 0002", seat.TextOf("piece-title"));
        Assert.Equal("Complex mating", seat.TextOf("piece-job"));
        Choose("piece-1", "piece-title", "#1 · 0001");
        seat.Tap("nav-system").Tap("side-gauge").Tap("nav-compensation").See("pair");
        seat.WaitFor(() => seat.TextOf("detail-title") == "#2 · 0002", "The chosen correction is forgotten.");
        seat.Tap("nav-verification").See("piece-title");
        seat.WaitFor(() => seat.TextOf("piece-title") == "#1 · 0001", "The chosen piece is forgotten.");
        seat.Tap("nav-system").See("side-gauge");
        Assert.True(((TabItem)seat.See("side-gauge")).IsSelected);

        seat.Tap("sign-out")
            .WaitFor(() => seat.Shell.IsLocked, "The station does not lock.")
            .SignIn(DemoCell.Operator)
            .Tap("nav-compensation")
            .See("pair");
        seat.WaitFor(() => seat.TextOf("detail-title") == "#1 · 0001", "Somebody else finds the choice of who sat there before.");

        void Choose(string row, string title, string label) =>
            seat.Tap(row).WaitFor(() => seat.TextOf(title) == label, $"{row} is not shown.");
    });

    [Fact]
    public Task What_was_looked_at_is_there_again_where_another_one_that_waits_longer_came_meanwhile() => Seat.AtAsync(seat =>
    {
        Wait(seat, 1, 2);

        // The first one is approved for a machine that is away, so the second one is shown; nobody chooses it.
        Directory.Move(seat.Cell.MachineFolder, seat.Cell.MachineFolder + "-away");
        new CorrectionDecisions(seat.Station.Store).Approve(1, DemoCell.Setter, null);
        seat.WaitFor(() => seat.Station.State.Status?.Proposed.Count == 1, "The approval is not seen.");

        // A banner that comes while a finger is down moves what is below it.
        seat.WaitFor(() => seat.Shell.Banner is not null, "Nothing is said of the machine that is away.");
        seat.SignIn(DemoCell.Setter).Tap("nav-compensation").See("pair");
        Assert.Equal("#2 · 0002", seat.TextOf("detail-title"));
        seat.Tap("nav-system").See("side-gauge");

        // Somebody changed the program there, so the first one fails, and waits for a person longer than the second.
        Directory.Move(seat.Cell.MachineFolder + "-away", seat.Cell.MachineFolder);
        File.WriteAllText(Path.Combine(seat.Cell.MachineFolder, "counterpart.nc"), "somebody's\n");
        seat.WaitFor(1, CorrectionState.Failed);
        seat.WaitFor(
            () => seat.Station.State.Status?.Failed.Count == 1 && seat.Shell.Banner is null,
            "The failure is not seen, or the machine is still said to be away.");
        seat.Tap("nav-compensation").See("pair");
        Assert.Equal(["#1 · 0001", "#2 · 0002"], ((CompensationViewModel)seat.Shell.Current!).Rows.Select(r => r.Title));
        seat.WaitFor(() => seat.TextOf("detail-title") == "#2 · 0002", "What was looked at is forgotten.");
    });

    private static void Wait(Seat seat, params int[] serials)
    {
        seat.Cell.Run();
        foreach (var serial in serials)
        {
            seat.Cell.Deliver(serial, serial == 1 ? 0 : 0.02);
            seat.WaitFor(serial, CorrectionState.Proposed);
        }

        seat.WaitFor(() => seat.Station.State.Status?.Proposed.Count == serials.Length, "What waits is not seen.");
    }

    private static Rect Place(Seat seat, string id) =>
        new Rect(seat.See(id).Bounds.Size).TransformToAABB(seat.See(id).TransformToVisual(seat.Window)!.Value);
}
