using Avalonia.Controls;
using Avalonia.Controls.Presenters;
using Avalonia.Input;
using Avalonia.Threading;
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
        seat.SignIn(DemoCell.Setter).Tap("nav-compensation").See("pair");
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

    // The chooser of files takes no password, and its button for Enter must not take one for an answer.
    [Fact]
    public Task What_is_typed_behind_a_chooser_goes_nowhere() => Seat.AtAsync(seat =>
    {
        seat.SignIn(DemoCell.Setter).Tap("nav-history");
        var (field, chooser) = (FieldBehindAChooser(seat), seat.Shell.Choosing!);
        seat.WaitFor(() => chooser.Confirm.CanExecute(null), "No folder can be chosen.");
        seat.Window.FocusManager!.Focus(null);
        Assert.False(field.Focus());
        seat.User.TypeByHand(Secret);
        Assert.Equal(chooser, seat.Shell.Choosing);
        Assert.Equal(ScreenKeys.History, seat.Shell.Chosen!.Screen.Key);
        Assert.Equal("", field.Text ?? "");
        NothingIsShown(seat);
        seat.Tap("chooser-leave");
        Assert.True(seat.Shell.IsFree);
    });

    // Enter is for "Stay" there, once it can be seen.
    [Fact]
    public Task What_is_typed_ahead_of_the_question_before_closing_goes_nowhere() => SetupSeat.AtAsync("points", here =>
    {
        var (seat, closed) = (here.Seat, false);
        seat.Window.Closed += (_, _) => closed = true;
        here.Shell.Editing.Change("", d => d with { Name = "Other" });
        here.Settle();
        seat.See("edit-name").Focus();
        Assert.True(seat.User.StaysOpen());
        seat.User.TypeByHand(Secret);
        Assert.NotNull(here.Shell.Leaving);
        Assert.Equal("Other", here.Draft.Name);
        NothingIsShown(seat);
        seat.Tap("leaving-stay");
        Assert.Equal((false, true), (closed, here.Shell.IsFree));
    });

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public Task What_is_typed_on_after_a_chooser_has_closed_is_shown_nowhere_for_a_moment(bool isChosen) => Seat.AtAsync(seat =>
    {
        seat.SignIn(DemoCell.Setter).Tap("nav-history");
        var (field, history) = (FieldBehindAChooser(seat), (HistoryViewModel)seat.Shell.Current!);
        if (isChosen)
        {
            seat.WaitFor(() => seat.Shell.Choosing!.Confirm.CanExecute(null), "No folder can be chosen.");
            seat.Shell.Choosing!.Confirm.Execute(null);
            seat.WaitFor(
                () =>
                {
                    if (seat.Shell.IsFree)
                    {
                        TypeOn(seat);
                    }

                    return seat.Shell.IsFree;
                },
                "The folder is not chosen.");
        }
        else
        {
            seat.Shell.Choosing!.Leave.Execute(null);
            TypeOn(seat);
        }

        Assert.True(field.IsFocused);
        Assert.Equal(("", ScreenKeys.History), (history.Serial, seat.Shell.Chosen!.Screen.Key));
        NothingIsShown(seat);

        // The moment ends by itself.
        seat.WaitFor(
            () =>
            {
                seat.User.Type("7");
                return history.Serial == "7";
            },
            "The field stays closed to keys.");
    });

    [Fact]
    public Task Enter_and_space_after_a_dialog_has_closed_press_nothing_for_a_moment() => Seat.AtAsync(seat =>
    {
        Propose(seat);
        seat.SignIn(DemoCell.Setter).Tap("nav-history").Tap("found-1").See("history-choose-folder").Focus();
        foreach (var key in new[] { Key.Enter, Key.Space })
        {
            var chosen = seat.Shell.ChooseAsync(new(FileChoiceKind.Folder, "History.Folder", []));
            seat.See("chooser-leave");
            seat.Shell.Choosing!.Leave.Execute(null);
            Assert.True(chosen.IsCompleted);
            FocusReturns();
            Assert.True(seat.See("history-choose-folder").IsFocused);
            seat.User.Press(key);
            Assert.True(seat.Shell.IsFree);
        }

        // Who moves on by keys means the next one.
        seat.User.Press(Key.Tab).Press(Key.Tab, RawInputModifiers.Shift).Press(Key.Enter);
        Assert.NotNull(seat.Shell.Choosing);
    });

    // Escape is no part of a password, and Tab or an arrow moves the focus on purpose.
    [Theory]
    [InlineData(Key.Escape)]
    [InlineData(Key.Tab)]
    [InlineData(Key.Down)]
    public Task Keys_that_end_the_moment_let_the_next_ones_through(Key key) => Seat.AtAsync(seat =>
    {
        seat.SignIn(DemoCell.Setter).Tap("nav-history");
        var (field, history) = (FieldBehindAChooser(seat), (HistoryViewModel)seat.Shell.Current!);
        if (key == Key.Escape)
        {
            seat.User.Press(key);
        }
        else
        {
            seat.Shell.Choosing!.Leave.Execute(null);
            FocusReturns();
            seat.User.Press(key);
        }

        Assert.True(seat.Shell.IsFree);
        FocusReturns();
        field.Focus();
        seat.User.Type("0001");
        Assert.Equal("0001", history.Serial);
    });

    private static TextBox FieldBehindAChooser(Seat seat)
    {
        var field = (TextBox)seat.See("history-serial");
        seat.WaitFor(() => field.IsFocused, "The field for the serial number is not ready.");
        _ = seat.Shell.ChooseAsync(new(FileChoiceKind.Folder, "History.Folder", []) { Start = seat.Station.Settings.LogFolder });
        seat.See("chooser-leave");
        return field;
    }

    // In the very moment, but with the focus back.
    private static void TypeOn(Seat seat)
    {
        FocusReturns();
        seat.User.TypeByHand(Secret);
    }

    private static void FocusReturns() => Dispatcher.UIThread.RunJobs(DispatcherPriority.Loaded);

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
