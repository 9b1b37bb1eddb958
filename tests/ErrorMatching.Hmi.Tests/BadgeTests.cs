using Avalonia.Controls;
using Avalonia.Input;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Who wears gloves signs in and signs by badge or PIN, where the cell accepts that.</summary>
public sealed class BadgeTests
{
    private const string Badge = "0004728193", OtherBadge = "0004728194", Pin = "502817";

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public Task A_badge_signs_in_and_leaves_nothing_in_a_field(bool isAnnounced) => At("badge", seat =>
    {
        Scan(seat, Badge, isAnnounced);
        seat.WaitFor(() => !seat.Shell.IsLocked, "The station stays locked.");
        Assert.Equal(DemoCell.Setter, seat.Shell.UserName);
        seat.Tap("sign-out").See("login-users");
        Scan(seat, "nobody's", isAnnounced);
        seat.WaitFor(() => seat.TextOf("login-message") is { Length: > 0 }, "A badge of nobody is not refused.");
        Assert.Equal("", ((TextBox)seat.See("login-password")).Text ?? "");
        Assert.True(seat.Shell.IsLocked);
    });

    [Fact]
    public Task A_badge_and_a_PIN_by_fingers_sign_in_and_the_badge_alone_does_not() => At("badge-with-pin", seat =>
    {
        Scan(seat, Badge, isAnnounced: false);
        seat.WaitFor(
            () => seat.TextOf("login-message")?.Contains(DemoCell.Setter, StringComparison.Ordinal) == true, "Nothing asks for a PIN.");
        Assert.True(seat.Shell.IsLocked);
        seat.User.Tap(seat.See("login-password")).Settle();
        foreach (var digit in Pin)
        {
            seat.User.Tap(seat.See("key-" + digit)).Settle();
        }

        seat.User.Tap(seat.See("key-enter")).Settle();
        seat.WaitFor(() => !seat.Shell.IsLocked, "The station stays locked.");
        Assert.Equal(DemoCell.Setter, seat.Shell.UserName);

        // By name, this cell takes no PIN.
        seat.Tap("sign-out").See("login-users");
        seat.Tap("login-user-" + DemoCell.Setter).Type("login-password", Pin).Tap("login-sign-in");
        seat.WaitFor(() => seat.TextOf("login-message") is { Length: > 0 }, "The PIN alone is not refused.");
        Assert.True(seat.Shell.IsLocked);
    });

    [Fact]
    public Task An_approval_takes_one_tap_and_a_badge() => At("badge", seat =>
    {
        Propose(seat);
        Scan(seat, Badge, isAnnounced: false);
        seat.WaitFor(() => !seat.Shell.IsLocked, "The station stays locked.");
        seat.Shell.Look(1);
        seat.See("pair");

        seat.User.Tap(seat.See("approve")).Settle();
        seat.See("signing-password");
        Scan(seat, OtherBadge, isAnnounced: false);
        seat.WaitFor(() => seat.TextOf("signing-message") is { Length: > 0 }, "Somebody else's badge is not refused.");
        Assert.Equal(CorrectionState.Proposed, seat.Station.Store.Find(1)!.State);
        Scan(seat, Badge, isAnnounced: false);
        Assert.Equal(
            DemoCell.Setter,
            seat.Station.Store.Find(seat.WaitFor(1, CorrectionState.Verified).Id) is { } approved
                ? seat.Station.Store.Corrections.StepsOf(approved.Id).Single(s => s.To == CorrectionState.Approved).By : null);
    });

    [Fact]
    public Task An_approval_takes_three_taps_and_a_PIN() => At("pin", seat =>
    {
        Propose(seat);
        seat.Tap("login-user-" + DemoCell.Setter).Type("login-password", Pin).Tap("login-sign-in");
        seat.WaitFor(() => !seat.Shell.IsLocked, "The station stays locked.");
        seat.Shell.Look(1);
        seat.See("pair");

        // Approve, the PIN in the digits that the field has opened, Enter.
        seat.User.Tap(seat.See("approve")).Settle();
        seat.See("key-5");
        foreach (var digit in Pin)
        {
            seat.User.Tap(seat.See("key-" + digit)).Settle();
        }

        seat.User.Tap(seat.See("key-enter")).Settle();
        seat.WaitFor(1, CorrectionState.Verified);
    });

    [Fact]
    public Task A_badge_is_never_recorded_as_a_reason() => At("badge", seat =>
    {
        Propose(seat);
        seat.SignIn(DemoCell.Setter);
        seat.Shell.Look(1);
        seat.See("pair");
        seat.Tap("approve").See("signing-password");
        Scan(seat, Badge, isAnnounced: false);
        seat.WaitFor(1, CorrectionState.Verified);
        seat.Cell.Deliver(2, 0.02);
        seat.WaitFor(2, CorrectionState.Proposed);
        new CorrectionDecisions(seat.Station.Store).Release(1, DemoCell.Setter, null);
        new CorrectionDecisions(seat.Station.Store).Approve(2, DemoCell.Setter, null);
        seat.WaitFor(2, CorrectionState.Verified);
        seat.Shell.Look(2);
        seat.WaitFor(() => seat.TextOf("detail-title") == "#2 · 0002", "The second one is not shown.");
        seat.Tap("revert").Type("signing-reason", "chatter ");

        // A person needs longer from one key to the next.
        seat.User.Wait(TimeSpan.FromMilliseconds(200));
        Scan(seat, Badge, isAnnounced: false);
        Assert.Equal("chatter", seat.WaitFor(2, CorrectionState.Reverted).Reason);
        Assert.DoesNotContain(
            seat.Station.Store.AuditEntries(0, 1000), e => e.Basis.Text.Contains(Badge, StringComparison.Ordinal));
    });

    [Fact]
    public Task A_rejection_takes_a_reason_of_the_shop() => At("pin", seat =>
    {
        Propose(seat);
        seat.SignIn(DemoCell.Operator);
        seat.Shell.Look(1);
        seat.See("pair");
        seat.User.Tap(seat.See("reject")).Settle();
        seat.See("signing-reason-1");
        seat.User.Tap(seat.See("signing-reason-1")).Settle();
        seat.User.Tap(seat.See("signing-confirm")).Settle();
        Assert.Equal("Wrong part", seat.WaitFor(1, CorrectionState.Rejected).Reason);
    });

    [Fact]
    public Task An_administrator_binds_a_badge_and_sets_a_PIN() => At("badge-with-pin", seat =>
    {
        seat.SignIn(DemoCell.Administrator);
        seat.Shell.Go(ScreenKeys.Settings);
        seat.Tap("user-row-" + DemoCell.Operator).See("users-set-pin");
        Scan(seat, "0009990001", isAnnounced: false);
        seat.Type("signing-password", DemoCell.Password).Tap("signing-confirm");
        seat.See("users-remove-badge");
        seat.Type("users-password", "618273").Type("users-again", "618273").Tap("users-set-pin");
        seat.Type("signing-password", DemoCell.Password).Tap("signing-confirm");
        seat.See("users-remove-pin");
        seat.Tap("sign-out").See("login-users");
        Scan(seat, "0009990001", isAnnounced: false);
        seat.WaitFor(() => seat.TextOf("login-message") is { Length: > 0 }, "Nothing asks for a PIN.");
        seat.Type("login-password", "618273").Tap("login-sign-in");
        seat.WaitFor(() => !seat.Shell.IsLocked, "The station stays locked.");
        Assert.Equal(DemoCell.Operator, seat.Shell.UserName);
    });

    [Fact]
    public Task A_badge_that_comes_too_late_is_shown_nowhere() => At("badge", seat =>
    {
        seat.SignIn(DemoCell.Administrator).Tap("nav-overview");
        Scan(seat, Badge, isAnnounced: true);
        seat.WaitFor(() => seat.Shell.Scanning.IsCompleted, "The badge is not taken.");
        Assert.Equal(ScreenKeys.Overview, seat.Shell.Chosen!.Screen.Key);
        Scan(seat, "0001", isAnnounced: true);
        seat.WaitFor(() => seat.Shell.Current is HistoryViewModel { WorkOrder: "0001" }, "A code of a piece is not searched for.");
        Scan(seat, Badge, isAnnounced: true);
        seat.WaitFor(() => seat.Shell.Scanning.IsCompleted, "The badge is not taken.");
        Assert.Equal(
            ("", "0001"),
            seat.Shell.Current is HistoryViewModel history ? (history.Serial, history.WorkOrder) : default);
    });

    [Fact]
    public Task A_cell_that_takes_no_badges_takes_a_fast_password() => Seat.AtAsync(seat =>
    {
        seat.Tap("login-user-" + DemoCell.Setter);
        seat.User.Click(seat.See("login-password")).Scan(DemoCell.Password);
        seat.WaitFor(() => !seat.Shell.IsLocked, "The station stays locked.");
    });

    private static void Propose(Seat seat)
    {
        seat.RunCell();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.WaitFor(() => seat.Station.State.Status?.Proposed.Count == 1, "The cell is not seen to propose.");
    }

    private static void Scan(Seat seat, string code, bool isAnnounced)
    {
        if (isAnnounced)
        {
            seat.User.Press(Key.F12);
        }

        seat.User.Scan(code).Settle();
    }

    private static Task At(string way, Action<Seat> test) => Seat.AtAsync(
        seat =>
        {
            var users = seat.Station.Users;
            users.SetBadge(Sign(), DemoCell.Setter, Badge);
            users.SetBadge(Sign(), DemoCell.Administrator, OtherBadge);
            users.SetPin(Sign(), DemoCell.Setter, Pin);
            seat.See("login-users");
            seat.User.Settle();
            test(seat);

            SignedIn Sign() => users.SignIn(DemoCell.Administrator, DemoCell.Password);
        },
        prepare: folder =>
        {
            var file = Path.Combine(folder, "cell", "cell.json");
            var text = File.ReadAllText(file);
            File.WriteAllText(
                file,
                text.Insert(
                    text.IndexOf("\"store\"", StringComparison.Ordinal),
                    $"\"signIn\": [\"{way}\"], \"rejectionReasons\": [\"Chip under the probe\", \"Wrong part\"], "));
        });
}
