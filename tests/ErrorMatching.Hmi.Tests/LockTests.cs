using Avalonia;
using Avalonia.Input;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

/// <summary>At a locked station everybody sees how the cell is, and nobody decides anything by pointer, finger or keyboard.</summary>
public sealed class LockTests
{
    [Fact]
    public Task Nothing_is_decided_at_a_locked_station_whatever_is_pressed() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Setter).Tap("nav-points");
        new SetupSeat(seat).Settle();
        seat.Type("edit-name", "Unsaved");
        var draft = seat.Shell.Editing.Draft;
        seat.Tap("nav-compensation").See("approve");
        var place = Middle(seat, "approve");

        // It locks while somebody signs: the password is typed, and only Enter is missing.
        seat.Tap("approve").Type("signing-password", DemoCell.Password);
        var confirm = Middle(seat, "signing-confirm");
        seat.Clock.Advance(Station.DefaultIdle + TimeSpan.FromMinutes(1));
        seat.WaitFor(() => seat.Shell.IsLocked, "The station does not lock.");
        Assert.Null(seat.Shell.Signing);
        Assert.Null(seat.Find("signing-password"));
        var entries = Entries(seat);
        seat.User.Press(Key.Enter).Click(seat.Window, confirm).Click(seat.Window, place);

        // What arrives is seen.
        seat.Cell.Deliver(2, 0.02);
        seat.WaitFor(2, CorrectionState.Proposed);
        seat.See("waiting-2");
        foreach (var id in new[] { "waiting-1", "waiting-2", "slot-vmc1/A", "login-user-ada" })
        {
            // By their places: what is shown may be made anew between the two.
            seat.User.Click(seat.Window, Middle(seat, id)).Tap(seat.Window, Middle(seat, id));
        }

        // Every stop of the keyboard is pressed; language and theme are everybody's.
        seat.See("language").Focus(NavigationMethod.Tab);
        for (var i = 0; i < 30; i++)
        {
            seat.User.Press(Key.Tab);
            if (seat.Find("language") is { IsFocused: false } && seat.Find("theme") is { IsFocused: false })
            {
                seat.User.Press(Key.Space).Press(Key.Enter).Press(Key.Z, RawInputModifiers.Control).Press(Key.Escape);
            }
        }

        Assert.True(seat.Shell.IsLocked);
        Assert.Null(seat.Find("detail-title"));
        Assert.Null(seat.Find("navigation"));
        Assert.Same(draft, seat.Shell.Editing.Draft);
        Assert.All([1L, 2L], id => Assert.Equal(CorrectionState.Proposed, seat.Station.Store.Find(id)!.State));
        Assert.Equal(entries, Entries(seat));

        // Whoever left finds the screen as it was, and what was typed is forgotten.
        seat.Type("login-name", DemoCell.Setter).Type("login-password", DemoCell.Password).Tap("login-sign-in");
        seat.See("approve");
        Assert.Null(seat.Find("signing-password"));
    });

    [Fact]
    public Task The_language_is_chosen_before_anybody_signs_in() => Seat.AtAsync(seat =>
    {
        seat.Tap("language");
        Assert.Equal("登入", seat.TextOf("login-title"));
        seat.Tap("language");
        Assert.Equal("Sign in", seat.TextOf("login-title"));
        Assert.True(seat.Shell.IsLocked);
    });

    [Fact]
    public Task Whoever_signs_in_while_the_empty_seat_is_noticed_stays_signed_in() => Seat.AtAsync(seat =>
    {
        var (screen, left, before) = (new HeldContext(), 0, SynchronizationContext.Current);
        SynchronizationContext.SetSynchronizationContext(screen);
        using var guard = new SeatGuard(seat.Station, () => left++);
        SynchronizationContext.SetSynchronizationContext(before);

        // The empty seat has been seen, and the screen hears of it after the sign-in.
        seat.WaitFor(() => screen.Holds, "Nobody looks.");
        seat.SignIn(DemoCell.Setter);
        guard.Arrive();
        screen.Catch();
        Assert.Equal(0, left);

        seat.Station.Session.SignOut();
        seat.WaitFor(() => screen.Holds, "Nobody looks.");
        screen.Catch();
        Assert.NotEqual(0, left);
    });

    // What people did: the cell itself goes on and writes down what it does.
    private static int Entries(Seat seat) =>
        seat.Station.Store.AuditEntries(0, 1000).Count(e => e.Who != "cell" && e.What is not ("signed-out" or "sign-in-refused"));

    private static Point Middle(Seat seat, string id) =>
        seat.See(id) is var control ? control.TranslatePoint(new Rect(control.Bounds.Size).Center, seat.Window)!.Value : default;

    // A screen that is busy: what is posted to it waits.
    private sealed class HeldContext : SynchronizationContext
    {
        private readonly System.Collections.Concurrent.ConcurrentQueue<Action> _held = new();

        public bool Holds => !_held.IsEmpty;

        public override void Post(SendOrPostCallback d, object? state) => _held.Enqueue(() => d(state));

        public void Catch()
        {
            while (_held.TryDequeue(out var work))
            {
                work();
            }
        }
    }
}
