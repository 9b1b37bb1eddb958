using System.Text.Json;
using System.Text.RegularExpressions;
using ErrorMatching.Cell;
using ErrorMatching.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Screen 10: users, connections, appearance, about.</summary>
public sealed class SettingsTests
{
    private const string Fresh = "seven lamps beside the lathe";

    [Fact]
    public Task An_administrator_adds_a_user_who_may_then_sign_in() => At(DemoCell.Administrator, seat =>
    {
        seat.Tap("users-new").Type("users-name", "olga").Type("users-password", Fresh).Type("users-again", "another one");
        Assert.Equal("The passwords do not match.", seat.TextOf("users-problem"));
        Assert.False(seat.See("users-add").IsEffectivelyEnabled);
        seat.Type("users-again", Fresh).Tap("users-add");
        Sign(seat);
        seat.See("user-row-olga");
        Assert.Equal("olga", seat.TextOf("users-title"));
        Assert.Equal(Role.Operator, seat.Station.Users.List().Single(u => u.Name == "olga").Role);
        Assert.Equal("olga", seat.Station.Users.SignIn("olga", Fresh).Name);
        Assert.Contains(
            seat.Station.Store.AuditEntries(0, 1000),
            e => e is { Who: DemoCell.Administrator, What: "user-added", Subject.Sentence: "olga" });
    });

    [Fact]
    public Task An_administrator_gives_a_role_disables_and_enables() => At(DemoCell.Administrator, seat =>
    {
        var users = ((SettingsViewModel)seat.Shell.Current!).Users;
        seat.Tap("user-row-otto");
        Assert.False(seat.See("users-set-role").IsEffectivelyEnabled);
        users.Role = users.Roles.Single(r => r.Role == Role.Setter);
        seat.Tap("users-set-role");
        Sign(seat);
        Assert.Equal(Role.Setter, Of(seat, DemoCell.Operator).Role);
        seat.Tap("users-disable");
        Sign(seat);
        Assert.True(Of(seat, DemoCell.Operator).IsDisabled);
        seat.WaitFor(() => users.Chosen is { IsDisabled: true, Standing: "disabled" }, "The row does not say so.");
        seat.Tap("users-enable");
        Sign(seat);
        Assert.False(Of(seat, DemoCell.Operator).IsDisabled);
    });

    [Fact]
    public Task The_last_administrator_stays_one() => At(DemoCell.Administrator, seat =>
    {
        seat.Tap("user-row-ada").Tap("users-disable").Type("signing-password", DemoCell.Password).Tap("signing-confirm");
        Assert.Equal("This is the last administrator. Add another administrator first.", seat.TextOf("signing-message"));
        Assert.False(Of(seat, DemoCell.Administrator).IsDisabled);
    });

    [Fact]
    public Task A_wrong_password_changes_nobody() => At(DemoCell.Administrator, seat =>
    {
        seat.Tap("user-row-otto").Tap("users-disable").Type("signing-password", "not the password").Tap("signing-confirm");
        Assert.Equal("Wrong password for ada. Type it again.", seat.TextOf("signing-message"));
        seat.Tap("signing-leave");
        Assert.False(Of(seat, DemoCell.Operator).IsDisabled);
    });

    [Fact]
    public Task An_operator_sees_users_and_changes_the_own_password_alone() => At(DemoCell.Operator, seat =>
    {
        seat.See("users-forbidden");
        Assert.Null(seat.Find("users-new"));
        seat.Tap("user-row-anna");
        seat.WaitFor(() => seat.TextOf("users-title") == DemoCell.Setter, "The other user is not shown.");
        Assert.Null(seat.Find("users-password"));
        Assert.Null(seat.Find("users-disable"));
        seat.Tap("user-row-otto")
            .Type("users-password", "short")
            .Type("users-again", "short")
            .Tap("users-set-password")
            .Type("signing-password", DemoCell.Password)
            .Tap("signing-confirm");
        Assert.StartsWith("A password needs at least 12 characters", seat.TextOf("signing-message"), StringComparison.Ordinal);
        seat.Tap("signing-leave").Type("users-password", Fresh).Type("users-again", Fresh).Tap("users-set-password");
        Sign(seat);
        Assert.Equal(DemoCell.Operator, seat.Station.Users.SignIn(DemoCell.Operator, Fresh).Name);
    });

    [Fact]
    public Task Connections_are_tested_and_what_is_away_is_named() => At(DemoCell.Operator, seat =>
    {
        Directory.Move(seat.Cell.MachineFolder, seat.Cell.MachineFolder + "-away");
        seat.Tap("tab-connections").See("connection-machine-vmc1");
        var page = ((SettingsViewModel)seat.Shell.Current!).Connections;
        Assert.All(page.Rows, r => Assert.Equal("not tested yet", r.Outcome));
        seat.Tap("connections-test");
        seat.WaitFor(() => !page.Test.IsRunning && page.Rows.All(r => r.Found is not null), "The test does not end.");
        Assert.Equal(1, page.Progress);
        Assert.Equal(["machine"], page.Rows.Where(r => r.IsAlarm).Select(r => r.Kind));
        Assert.StartsWith("The machine does not answer.", page.Rows.Single(r => r.IsAlarm).Outcome, StringComparison.Ordinal);
        Directory.Move(seat.Cell.MachineFolder + "-away", seat.Cell.MachineFolder);
        seat.Tap("connections-test");
        seat.WaitFor(() => !page.Test.IsRunning && page.Rows.All(r => r.Found is Severity.Quiet), "The machine stays away.");
        Assert.All(page.Rows.Where(r => r.Kind == "machine"), r => Assert.StartsWith("Responding.", r.Outcome, StringComparison.Ordinal));
    });

    [Fact]
    public Task A_gauge_whose_folder_is_away_is_named() => At(DemoCell.Operator, seat =>
    {
        var folder = seat.Cell.Settings.Gauges[0].Incoming!;
        Directory.Move(folder, folder + "-away");
        seat.Tap("tab-connections").See("connection-machine-vmc1");
        var page = ((SettingsViewModel)seat.Shell.Current!).Connections;
        seat.Tap("connections-test");
        seat.WaitFor(() => !page.Test.IsRunning && page.Rows.All(r => r.Found is not null), "The test does not end.");
        var alarm = page.Rows.Single(r => r.IsAlarm);
        Assert.Equal(("gauge", seat.Cell.Settings.Gauges[0].Name), (alarm.Kind, alarm.Name));
        Assert.StartsWith("The gauge's folder cannot be read.", alarm.Outcome, StringComparison.Ordinal);
        Directory.Move(folder + "-away", folder);
    });

    [Fact]
    public Task A_test_is_cancelled() => At(DemoCell.Operator, seat =>
    {
        seat.Tap("tab-connections");
        var page = ((SettingsViewModel)seat.Shell.Current!).Connections;
        page.Test.Execute(null);
        page.Test.Cancel.Execute(null);
        seat.WaitFor(() => !page.Test.IsRunning, "The test is not cancelled.");
        Assert.Equal("The test was canceled.", seat.TextOf("connections-message"));
        Assert.All(page.Rows, r => Assert.Null(r.Found));
    });

    [Fact]
    public Task A_machine_without_a_password_takes_none() => At(DemoCell.Administrator, seat =>
    {
        seat.Tap("tab-connections").Tap("connection-machine-vmc1");
        Assert.False(((SettingsViewModel)seat.Shell.Current!).Connections.TakesPassword);
        Assert.Null(seat.Find("connections-password"));
    });

    [Fact]
    public Task Language_theme_and_size_are_one_tap_away_and_hold_at_once() => At(DemoCell.Operator, seat =>
    {
        seat.Tap("tab-look").Tap("look-dark").Tap("look-Largest");
        Assert.True(seat.Shell.IsDark);
        Assert.Equal(76, seat.See("sign-out").Bounds.Height, 0.5);
        Assert.Equal(76, seat.See("nav-overview").Bounds.Height, 0.5);
        seat.Tap("look-TraditionalChinese");
        Assert.Equal(Language.TraditionalChinese, Texts.Current.Language);
        seat.Tap("look-English").Tap("look-Standard");
        Assert.Equal(57, seat.See("sign-out").Bounds.Height, 0.5);
    });

    [Fact]
    public Task It_says_what_it_is_and_where_everything_lies() => At(DemoCell.Operator, seat =>
    {
        seat.Tap("tab-about").See("about-places");
        var about = ((SettingsViewModel)seat.Shell.Current!).About;
        Assert.Contains(about.Places, r => r.Value == Path.GetFullPath(seat.Cell.Settings.File));
        Assert.Contains(about.Places, r => r.Value == ((SqliteSettings)seat.Cell.Settings.Store).File);
        Assert.Contains(
            about.Places, r => Regex.IsMatch(r.Value, @"^ErrorMatching \d+\.\d+\.\d+", RegexOptions.None, TimeSpan.FromSeconds(1)));
    });

    [Fact]
    public void Every_package_that_the_station_brings_along_is_named_with_its_license()
    {
        using var document = JsonDocument.Parse(File.ReadAllText(Repository.PathTo(
            "src", "ErrorMatching.Hmi.Desktop", "packages.lock.json")));
        var packages = document.RootElement.GetProperty("dependencies").EnumerateObject().SelectMany(f => f.Value.EnumerateObject())
            .Where(
                p => p.Value.GetProperty("type").GetString() != "Project"
                    && !p.Name.Contains("Analyzer", StringComparison.Ordinal)

                    // Referenced to keep its files out; and what takes out what is never called, which does not come along.
                    && p.Name is not ("Avalonia.BuildServices" or "Microsoft.NET.ILLink.Tasks"))
                .Select(p => p.Name).ToArray();
        Assert.True(packages.Length > 10);
        Assert.All(
            packages,
            p => Assert.Contains(
                Licenses.Packages,
                l => l.Package.TrimEnd('*') is var stem
                    && (l.Package.EndsWith('*') ? p.StartsWith(stem, StringComparison.Ordinal) : p == stem)));
    }

    [Fact]
    public Task Nothing_of_it_is_cut_off() => At(DemoCell.Administrator, seat =>
    {
        var pictures = new Pictures(seat.RunCell());
        seat.Tap("user-row-anna");
        pictures.Take("settings-users");
        seat.Tap("users-new");
        pictures.Take("settings-users-new", isPictured: false);
        seat.Tap("tab-connections");
        var page = ((SettingsViewModel)seat.Shell.Current!).Connections;
        seat.Tap("connections-test");
        seat.WaitFor(() => !page.Test.IsRunning && page.Rows.All(r => r.Found is not null), "The test does not end.");
        pictures.Take("settings-connections");
        seat.Tap("tab-look");
        pictures.Take("settings-look", isPictured: false);
        seat.Tap("tab-about");
        pictures.Take("settings-about", isPictured: false);
        pictures.MustBeClean();
    });

    private static User Of(Seat seat, string name) => seat.Station.Users.List().Single(u => u.Name == name);

    private static void Sign(Seat seat)
    {
        seat.Type("signing-password", DemoCell.Password).Tap("signing-confirm");
        seat.WaitFor(() => seat.Shell.Signing is null, "It is not signed.");
        seat.WaitFor(() => ((SettingsViewModel)seat.Shell.Current!).Users.Loading.IsCompleted, "The users are not listed.");
    }

    private static Task At(string user, Action<Seat> test) => Seat.AtAsync(seat =>
    {
        seat.SignIn(user).Tap("nav-settings").See("user-row-" + user);
        test(seat);
    });
}
