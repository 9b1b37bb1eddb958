using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Rows leave lists by themselves: a finger that was on its way to one of them does not act upon the one that took its
/// place.</summary>
public sealed class AimTests
{
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public Task A_row_that_has_just_moved_under_the_finger_is_not_chosen_for_a_moment(bool isFinger) => At(seat =>
    {
        seat.Tap("nav-compensation").See("correction-3");
        var screen = (CompensationViewModel)seat.Shell.Current!;
        var place = PlaceOf(seat, "correction-2");
        Leave(seat, 1, "correction-1");
        seat.WaitFor(() => Covers(seat, "correction-3", place) && screen.Chosen?.Id == 2, "The rows do not move up.");
        Tap(seat, place, isFinger);
        Assert.Equal(2, screen.Chosen!.Id);
        seat.Clock.Advance(AimKeeper.OnItsWay);
        Tap(seat, place, isFinger);
        Assert.Equal(3, screen.Chosen!.Id);
    });

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public Task A_tile_that_has_just_moved_under_the_finger_does_not_open_for_a_moment(bool isFinger) => At(seat =>
    {
        var place = PlaceOf(seat, "waiting-2");
        Leave(seat, 1, "waiting-1");
        seat.WaitFor(() => Covers(seat, "waiting-3", place), "The tiles do not move up.");
        Tap(seat, place, isFinger);
        Assert.Equal(ScreenKeys.Overview, seat.Shell.Chosen!.Screen.Key);
        seat.Clock.Advance(AimKeeper.OnItsWay);
        Tap(seat, place, isFinger);
        Assert.Equal("#3 · 0003", seat.TextOf("detail-title"));
    });

    [Fact]
    public Task Machines_keep_their_places_whatever_waits_and_open_at_once() => At(seat =>
    {
        seat.User.Settle();
        var place = PlaceOf(seat, "slot-vmc1/A");
        Leave(seat, 1, "waiting-1");
        Leave(seat, 2, "waiting-2");
        Leave(seat, 3, "waiting-3");
        Assert.Equal(place, PlaceOf(seat, "slot-vmc1/A"));
        Assert.False(seat.Window.Aim.IsMissed(seat.Window.InputHitTest(place), place));
    });

    [Fact]
    public Task What_stayed_where_it_was_and_what_came_where_nothing_was_opens_at_once() => At(seat =>
    {
        seat.Tap("nav-compensation").See("correction-3");
        var screen = (CompensationViewModel)seat.Shell.Current!;
        Leave(seat, 3, "correction-3");
        Tap(seat, PlaceOf(seat, "correction-2"), isFinger: true);
        Assert.Equal(2, screen.Chosen!.Id);
        seat.Clock.Advance(AimKeeper.OnItsWay);
        seat.Cell.Deliver(4, 0.02);
        seat.See("correction-4");
        Tap(seat, PlaceOf(seat, "correction-4"), isFinger: true);
        Assert.Equal(4, screen.Chosen!.Id);
    });

    [Fact]
    public Task Keys_are_taken_at_once() => At(seat =>
    {
        seat.Tap("nav-compensation").Tap("correction-2");
        var screen = (CompensationViewModel)seat.Shell.Current!;
        seat.WaitFor(() => screen.Chosen?.Id == 2, "The second one is not chosen.");
        Leave(seat, 1, "correction-1");
        seat.User.Press(Key.Down);
        Assert.Equal(3, screen.Chosen!.Id);
    });

    [Fact]
    public Task A_row_that_comes_under_a_finger_that_is_down_on_one_that_leaves_is_not_chosen() => At(seat =>
    {
        seat.Tap("nav-compensation").See("correction-3");
        var screen = (CompensationViewModel)seat.Shell.Current!;
        var place = PlaceOf(seat, "correction-2");
        seat.User.Tap(seat.See("correction-2"), () =>
        {
            Leave(seat, 2, "correction-2");
            seat.WaitFor(() => Covers(seat, "correction-3", place), "The rows do not move up.");
        });
        Assert.Equal(1, screen.Chosen!.Id);
    });

    [Fact]
    public Task A_row_that_is_put_in_the_place_of_one_under_a_finger_that_is_down_is_not_chosen() => At(seat =>
    {
        seat.Tap("nav-compensation").See("correction-3");
        var screen = (CompensationViewModel)seat.Shell.Current!;

        // One leaves and one comes at the same time.
        seat.User.Tap(seat.See("correction-2"), () => screen.Rows.Show([screen.Rows[0], screen.Rows[2], screen.Rows[2] with { Id = 4 }]));
        Assert.Equal(1, screen.Chosen!.Id);
    });

    // Somebody else decides.
    private static void Leave(Seat seat, long id, string row)
    {
        new CorrectionDecisions(seat.Station.Store).Reject(id, DemoCell.Operator, "chip under the probe");
        seat.WaitFor(() => seat.Find(row) is null, "The row does not leave.");
    }

    private static Point PlaceOf(Seat seat, string id)
    {
        var control = seat.See(id);
        seat.User.Settle();
        return control.TranslatePoint(new Rect(control.Bounds.Size).Center, seat.Window)!.Value;
    }

    private static bool Covers(Seat seat, string id, Point place) =>
        seat.Find(id) is Control control
            && seat.Window.TranslatePoint(place, control) is { } within
            && new Rect(control.Bounds.Size).Contains(within);

    private static void Tap(Seat seat, Point place, bool isFinger)
    {
        _ = isFinger ? seat.User.Tap(seat.Window, place) : seat.User.Click(seat.Window, place);
    }

    // Three wait, and no time passes by itself.
    private static Task At(Action<Seat> test) => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.SignIn(DemoCell.Setter);
        for (var serial = 1; serial <= 3; serial++)
        {
            seat.Cell.Deliver(serial, serial == 1 ? 0 : 0.02);
            seat.WaitFor(serial, CorrectionState.Proposed);
        }

        seat.See("waiting-3");
        seat.Clock.Stand();
        seat.Clock.Advance(AimKeeper.OnItsWay);
        test(seat);
    });
}
