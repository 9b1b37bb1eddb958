using Avalonia.Controls;
using Avalonia.Input;

namespace ErrorMatching.Hmi.Tests;

public sealed class LoginTests
{
    [Fact]
    public Task Somebody_signs_in_by_tapping_the_name() => Seat.AtAsync(seat =>
    {
        Assert.True(seat.Shell.IsLocked);
        Assert.Null(seat.Find("nav-overview"));
        seat.SignIn(DemoCell.Setter);
        Assert.Equal("anna", seat.TextOf("user-name"));
        Assert.Equal("Setter", seat.TextOf("user-role"));
        Assert.NotNull(seat.Find("nav-overview"));
    });

    [Fact]
    public Task Somebody_signs_in_by_keyboard_alone() => Seat.AtAsync(seat =>
    {
        seat.See("login-name");
        seat.User.Type(DemoCell.Operator).Press(Key.Tab).Type(DemoCell.Password).Press(Key.Enter);
        seat.WaitFor(() => !seat.Shell.IsLocked, "The station stays locked.");
        Assert.Equal("Operator", seat.TextOf("user-role"));
    });

    [Fact]
    public Task A_wrong_password_is_said_and_forgotten() => Seat.AtAsync(seat =>
    {
        seat.Tap("login-user-anna").Type("login-password", "not the password").Tap("login-sign-in");
        Assert.Equal("Wrong name or password.", seat.TextOf("login-message"));
        Assert.Equal("", ((TextBox)seat.See("login-password")).Text ?? "");
        Assert.True(seat.Shell.IsLocked);
    });

    [Fact]
    public Task A_demonstration_tells_everybody_how_to_get_in() => Seat.AtAsync(seat =>
    {
        using var demonstration = new Station(seat.Station.Settings, seat.Station.Clock, Station.DefaultIdle) { IsDemonstration = true };
        using var login = new LoginViewModel(demonstration, "", _ => { });
        Assert.Equal("Demonstration: every password is “demonstration”. anna can set up and approve.", login.Hint);
        Assert.Null(seat.Find("login-hint") is { IsEffectivelyVisible: true } ? "shown" : null);
    });

    [Fact]
    public Task A_password_is_never_on_the_screen() => Seat.AtAsync(seat =>
    {
        seat.Tap("login-user-anna").Type("login-password", DemoCell.Password);
        Assert.NotEqual(default, ((TextBox)seat.See("login-password")).PasswordChar);
    });

    [Fact]
    public Task An_idle_station_locks_and_still_shows_how_the_cell_is() => Seat.AtAsync(
        seat =>
        {
            seat.SignIn(DemoCell.Setter);
            seat.Clock.Advance(TimeSpan.FromMinutes(11));
            seat.WaitFor(() => seat.Shell.IsLocked, "The station does not lock.");
            Assert.Equal("anna", ((TextBox)seat.See("login-name")).Text);
            Assert.Equal("The cell is not running", seat.TextOf("overview-summary"));
            Assert.Null(seat.Find("nav-overview"));
            Assert.Contains(
                seat.Station.Store.AuditEntries(0, 1000), e => e is { Who: "anna", What: "signed-out", Basis.Sentence: "idle" });
        },
        idle: TimeSpan.FromMinutes(10));

    [Fact]
    public Task A_tap_on_ones_own_name_after_a_lock_asks_for_the_password() => Seat.AtAsync(seat =>
    {
        seat.SignIn(DemoCell.Setter).Tap("sign-out");
        seat.WaitFor(() => seat.Shell.IsLocked && seat.Find("login-user-anna") is not null, "The station does not lock.");
        for (var taps = 0; taps < 3; taps++)
        {
            seat.Tap("login-user-anna").WaitFor(() => seat.See("login-password").IsFocused, "The password is not asked for.");
        }

        seat.User.Tap(seat.See("login-user-anna"));
        seat.WaitFor(() => seat.See("login-password").IsFocused, "A finger's tap does not ask for the password.");
        seat.User.Type(DemoCell.Password).Press(Key.Enter);
        seat.WaitFor(() => !seat.Shell.IsLocked, "The station stays locked.");
        Assert.Equal("anna", seat.TextOf("user-name"));
    });

    [Fact]
    public Task A_tap_on_another_name_asks_for_that_ones_password() => Seat.AtAsync(seat =>
    {
        seat.SignIn(DemoCell.Setter).Tap("sign-out");
        seat.WaitFor(() => seat.Shell.IsLocked && seat.Find("login-user-otto") is not null, "The station does not lock.");
        seat.User.Type("anna's");
        seat.Tap("login-user-otto").WaitFor(() => seat.See("login-password").IsFocused, "The password is not asked for.");
        Assert.Equal("", ((TextBox)seat.See("login-password")).Text ?? "");
        seat.User.Type(DemoCell.Password).Press(Key.Enter);
        seat.WaitFor(() => !seat.Shell.IsLocked, "The station stays locked.");
        Assert.Equal("otto", seat.TextOf("user-name"));
    });

    [Fact]
    public Task Signing_out_is_written_down() => Seat.AtAsync(seat =>
    {
        seat.SignIn(DemoCell.Operator).Tap("sign-out");
        seat.WaitFor(() => seat.Shell.IsLocked, "The station does not lock.");
        Assert.Null(seat.Station.Session.Who);
        Assert.Contains(seat.Station.Store.AuditEntries(0, 1000), e => e is { Who: "otto", What: "signed-out" });
    });

    [Fact]
    public Task Another_language_is_one_tap_away() => Seat.AtAsync(seat =>
    {
        seat.Tap("language");
        Assert.Equal(Language.TraditionalChinese, Texts.Current.Language);
        seat.SignIn(DemoCell.Setter);
        Assert.Equal("調機員", seat.TextOf("user-role"));
        seat.Tap("language");
        Assert.Equal("Setter", seat.TextOf("user-role"));
    });
}
