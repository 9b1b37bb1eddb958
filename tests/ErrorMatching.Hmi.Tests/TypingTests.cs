using Avalonia.Controls;
using Avalonia.Controls.Presenters;
using Avalonia.Input;
using Avalonia.VisualTree;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

/// <summary>A password that is typed too early or too late reaches the field for passwords or nothing. It is shown nowhere, it is no scan,
/// and it decides nothing.</summary>
public sealed class TypingTests
{
    private const string Secret = DemoCell.Password;

    [Fact]
    public Task What_is_typed_ahead_of_a_late_dialog_reaches_it() => Seat.AtAsync(seat =>
    {
        Propose(seat);
        seat.SignIn(DemoCell.Setter).Tap("nav-compensation").See("points");
        seat.WaitFor(() => seat.See("approve").IsEffectivelyEnabled, "It cannot be approved.");
        seat.User.ClickAndTypeAhead(seat.See("approve"), Secret);

        // Nobody signs what was not on the screen: the password is there, and Enter is pressed again.
        Assert.Equal(CorrectionState.Proposed, seat.Station.Store.Find(1)!.State);
        Assert.Equal(Secret, seat.Shell.Signing!.Password);
        seat.User.Press(Key.Enter);
        seat.WaitFor(() => seat.Station.Store.Find(1)!.State != CorrectionState.Proposed, "It is not approved.");
        Assert.Equal(ScreenKeys.Compensation, seat.Shell.Chosen!.Screen.Key);
        NothingIsShown(seat);
    });

    [Fact]
    public Task What_is_typed_by_hand_is_no_scan_and_is_shown_nowhere() => Seat.AtAsync(seat =>
    {
        Propose(seat);
        seat.SignIn(DemoCell.Setter);
        foreach (var item in seat.Shell.Items)
        {
            // A button that is off opens no dialog; the password comes all the same.
            seat.Tap(item.Screen.AutomationId).WaitFor(() => seat.Shell.Chosen == item, "The screen does not open.").User.Settle();
            (seat.Find(item.Screen.AutomationId) as ListBoxItem)?.Focus();
            seat.User.TypeByHand(Secret);
            Assert.Equal(item, seat.Shell.Chosen);
            NothingIsShown(seat);
        }
    });

    [Fact]
    public Task What_is_typed_on_after_the_lock_closed_the_dialog_is_shown_nowhere() => Seat.AtAsync(seat =>
    {
        Propose(seat);
        seat.SignIn(DemoCell.Setter).Tap("nav-compensation").Tap("approve").See("signing-password");
        seat.User.Type(Secret[..5]);
        seat.Clock.Advance(Station.DefaultIdle + TimeSpan.FromMinutes(1));
        seat.WaitFor(
            () =>
            {
                // In the very moment, before anything is drawn.
                if (seat.Shell.IsLocked)
                {
                    seat.User.TypeByHand(Secret[5..]);
                }

                return seat.Shell.IsLocked;
            },
            "The station does not lock.");
        Assert.True(seat.Shell.IsLocked);
        Assert.Equal(DemoCell.Setter, ((TextBox)seat.See("login-name")).Text);
        NothingIsShown(seat);
        Assert.Equal(CorrectionState.Proposed, seat.Station.Store.Find(1)!.State);
    });

    [Fact]
    public Task What_is_typed_on_after_signing_in_does_not_get_into_a_field() => Seat.AtAsync(seat =>
    {
        seat.SignIn(DemoCell.Setter).Tap("nav-history").See("history-serial");
        seat.WaitFor(() => seat.See("history-serial").IsFocused, "The field for the serial number is not ready.");
        seat.Tap("sign-out").WaitFor(() => seat.Shell.IsLocked, "It does not lock.");
        seat.Tap("login-user-anna");
        seat.Type("login-password", Secret).User.Press(Key.Enter);
        seat.WaitFor(
            () =>
            {
                if (!seat.Shell.IsLocked)
                {
                    seat.User.TypeByHand(Secret);
                }

                return !seat.Shell.IsLocked;
            },
            "The station stays locked.");
        Assert.Equal("", ((HistoryViewModel)seat.Shell.Current!).Serial);
        NothingIsShown(seat);

        // Who points at a field means it.
        seat.User.Click(seat.See("history-serial")).Type("0001");
        Assert.Equal("0001", ((HistoryViewModel)seat.Shell.Current!).Serial);
    });

    [Fact]
    public Task While_a_signature_is_being_prepared_nothing_is_scanned() => Seat.AtAsync(seat =>
    {
        seat.SignIn(DemoCell.Setter).Tap("nav-points");
        new SetupSeat(seat).Settle();
        seat.Type("edit-name", "Other");
        new SetupSeat(seat).Settle();
        seat.Shell.Editing.Save.Execute(null);
        Assert.True(seat.Shell.Editing.Save.IsRunning);
        Assert.Null(seat.Shell.Signing);
        seat.See("nav-points").Focus();
        seat.User.Scan(Secret);
        Assert.Equal(ScreenKeys.Points, seat.Shell.Chosen!.Screen.Key);
        NothingIsShown(seat);
    });

    private static void Propose(Seat seat)
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.WaitFor(() => seat.Station.State.Status?.Proposed.Count == 1, "The cell is not seen to propose.");
    }

    private static void NothingIsShown(Seat seat)
    {
        seat.User.Settle();
        var shown = seat.Window.GetVisualDescendants().Select(v => v switch
        {
            TextBlock text => text.Text,
            TextPresenter { PasswordChar: '\0' } typed => typed.Text,
            _ => null,
        }).OfType<string>();
        Assert.DoesNotContain(shown, t => t.Contains(Secret[5..], StringComparison.Ordinal));
    }
}
