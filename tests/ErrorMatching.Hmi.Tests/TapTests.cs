using System.Diagnostics;
using Avalonia;
using Avalonia.Controls;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What follows the cell is made anew under a finger that is down: the tap opens what was pressed all the same.</summary>
public sealed class TapTests
{
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public Task A_tile_that_changes_while_it_is_pressed_opens(bool isFinger) => At(seat =>
    {
        Press(seat, "waiting-1", isFinger, () => Texts.Current.Language = Language.TraditionalChinese);
        Assert.Equal(("#1 · 0001", ScreenKeys.Compensation), (seat.TextOf("detail-title"), seat.Shell.Chosen!.Screen.Key));
    });

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public Task A_slot_that_gets_another_one_in_line_while_it_is_pressed_opens(bool isFinger) => At(seat =>
    {
        new CorrectionDecisions(seat.Station.Store).Approve(1, DemoCell.Setter, null);
        seat.WaitFor(() => Slots(seat)[0].Correction == 1, "The first part does not take the slot.");
        Press(seat, "slot-vmc1/A", isFinger, () =>
        {
            var before = Slots(seat)[0].Waiting;
            seat.Cell.Deliver(2, 0.02);
            seat.WaitFor(() => Slots(seat)[0].Waiting != before, "The slot's tile does not change.");
        });
        Assert.Equal("#1 · 0001", seat.TextOf("detail-title"));
    });

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public Task A_tile_that_another_one_moves_away_opens_and_the_other_one_does_not(bool isFinger) => At(seat =>
    {
        seat.Cell.Deliver(2, 0.02);
        seat.WaitFor(() => Waiting(seat).Count == 2, "The second part does not appear.");
        Press(seat, "waiting-2", isFinger, () =>
        {
            new CorrectionDecisions(seat.Station.Store).Reject(1, DemoCell.Setter, "no");
            seat.WaitFor(() => Waiting(seat) is [{ Id: 2 }], "The first part does not leave.");
        });
        Assert.Equal("#2 · 0002", seat.TextOf("detail-title"));
    });

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public Task A_message_that_changes_while_it_is_pressed_opens(bool isFinger) => At(seat =>
    {
        seat.Tap("nav-messages").See("message-1");
        Press(seat, "message-1", isFinger, () => Texts.Current.Language = Language.TraditionalChinese);
        Assert.Equal("#1 · 0001", seat.TextOf("detail-title"));
    });

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public Task A_row_that_changes_while_it_is_pressed_opens(bool isFinger) => At(seat =>
    {
        seat.Cell.Deliver(2, 0.02);
        seat.WaitFor(2, CorrectionState.Proposed);
        seat.Tap("nav-compensation").See("correction-2");
        Press(seat, "correction-2", isFinger, () => Texts.Current.Language = Language.TraditionalChinese);
        seat.WaitFor(() => seat.TextOf("detail-title") == "#2 · 0002", "The second part is not shown.");
    });

    [Fact]
    public Task A_second_quick_tap_does_not_fall_on_what_the_first_brought_there() => At(seat =>
    {
        // The other step opens with the button that leads back at the same place.
        Point place = default;
        var (took, tries) = (TimeSpan.Zero, 0);
        do
        {
            // On a busy machine the second tap may come too late to be a quick one: then both are made again.
            place = new Rect(seat.Tap("nav-points").See("setup-step").Bounds.Size).Center;
            place = seat.See("setup-step").TranslatePoint(place, seat.Window)!.Value;
            var began = Stopwatch.GetTimestamp();
            seat.User.Click(seat.Window, place).Click(seat.Window, place);
            took = Stopwatch.GetElapsedTime(began);
        }
        while (took > TimeSpan.FromMilliseconds(450) && ++tries < 50);
        Assert.Equal(ScreenKeys.System, seat.Shell.Chosen!.Screen.Key);

        // After a moment it is meant.
        seat.User.Wait(TimeSpan.FromMilliseconds(600)).Click(seat.Window, place);
        Assert.Equal(ScreenKeys.Points, seat.Shell.Chosen!.Screen.Key);

        // The same control may be tapped as quickly as one can.
        seat.Tap("add-line").Tap("add-line");
        Assert.Equal(5, ((PointsViewModel)seat.Shell.Current!).Features.Count);
    });

    [Fact]
    public Task A_tile_that_is_left_while_it_changes_does_not_open() => At(seat =>
    {
        seat.User.Hold(seat.See("waiting-1"), () => Texts.Current.Language = Language.TraditionalChinese, new Vector(40, 0));
        Assert.Equal(ScreenKeys.Overview, seat.Shell.Chosen!.Screen.Key);
    });

    [Fact]
    public Task Tiles_beside_one_that_comes_or_goes_stay_as_they_are() => At(seat =>
    {
        seat.Cell.Deliver(2, 0.02);

        // Until it is computed, its own tile changes, too.
        seat.WaitFor(2, CorrectionState.Proposed);
        seat.WaitFor(
            () => Waiting(seat) is [var one, var other] && other.State == one.State && other.HasLargest,
            "The second part does not appear.");
        var second = seat.See("waiting-2");
        new CorrectionDecisions(seat.Station.Store).Reject(1, DemoCell.Setter, "no");
        seat.WaitFor(() => Waiting(seat) is [{ Id: 2 }], "The first part does not leave.");
        Assert.Same(second, seat.See("waiting-2"));
    });

    private static RowList<WaitingTile> Waiting(Seat seat) => ((OverviewViewModel)seat.Shell.Current!).Waiting;

    private static RowList<SlotTile> Slots(Seat seat) => ((OverviewViewModel)seat.Shell.Current!).Slots;

    private static void Press(Seat seat, string id, bool isFinger, Action meanwhile)
    {
        Control pressed = seat.See(id);
        seat.User.Settle();
        seat.Clock.Advance(AimKeeper.OnItsWay);
        _ = isFinger ? seat.User.Tap(pressed, meanwhile) : seat.User.Hold(pressed, meanwhile);
    }

    private static Task At(Action<Seat> test) => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.SignIn(DemoCell.Setter);
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.See("waiting-1");

        // Nobody taps where another tile stood a moment ago.
        seat.Clock.Advance(AimKeeper.OnItsWay);
        test(seat);
    });
}
