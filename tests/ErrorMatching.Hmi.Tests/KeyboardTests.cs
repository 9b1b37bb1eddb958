using Avalonia.Controls;
using Avalonia.Input;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Everything goes by the keyboard: whatever a finger can do is reached by Tab, in the order in which it is read,
/// and seen to have the focus.</summary>
[Trait("Length", "Long")]
public sealed class KeyboardTests
{
    private static readonly string[] Setup = ["coordinates", "blocks", "tolerances", "machine", "gauge"];

    [Fact]
    public Task Enter_in_the_reason_goes_on_to_what_is_missing_and_confirms_once_nothing_is() => Seat.AtAsync(seat =>
    {
        seat.RunCell();
        for (var id = 1; id <= 3; id++)
        {
            seat.Cell.Deliver(id, 0.003);
            seat.WaitFor(id, CorrectionState.Proposed);
        }

        var decisions = new CorrectionDecisions(seat.Station.Store);
        seat.SignIn(DemoCell.Setter).Tap("nav-compensation").See("pair");
        seat.Tap("reject").See("signing-reason");
        seat.User.Press(Key.Enter);
        Assert.NotNull(seat.Find("signing-reason"));
        seat.User.Type("chip under the probe").Press(Key.Enter);
        Assert.Equal("chip under the probe", seat.WaitFor(1, CorrectionState.Rejected).Reason);

        decisions.Approve(2, DemoCell.Setter, null);
        seat.WaitFor(2, CorrectionState.Verified);
        decisions.Release(2, DemoCell.Setter, null);
        decisions.Approve(3, DemoCell.Setter, null);
        seat.WaitFor(3, CorrectionState.Verified);
        seat.Shell.Look(3);
        seat.Tap("revert").See("signing-reason");
        seat.User.Type("chatter").Press(Key.Enter);
        seat.WaitFor(() => seat.See("signing-password").IsFocused, "Enter leads nowhere.");
        seat.User.Type(DemoCell.Password).Press(Key.Enter);
        Assert.Equal("chatter", seat.WaitFor(3, CorrectionState.Reverted).Reason);
    });

    [Fact]
    public Task Tab_gets_everywhere_in_the_order_of_reading_and_is_seen() => Seat.AtAsync(seat =>
    {
        var walk = new TabWalk(seat);
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.WaitFor(() => seat.Shell.Banner is null && seat.Station.State.Status?.Proposed.Count == 1, "The cell is not seen to run.");
        walk.Around("login");
        seat.SignIn(DemoCell.Administrator);
        walk.Around("overview");

        Go(ScreenKeys.Points, "points-drawing");
        new SetupSeat(seat).Settle();
        walk.Around("points");
        Go(ScreenKeys.System, "coordinates");
        new SetupSeat(seat).Settle();
        foreach (var side in Setup)
        {
            seat.Tap("side-" + side);
            walk.Around("system " + side);
        }

        seat.Shell.Look(1);
        seat.See("pair");
        walk.Around("compensation");
        seat.Tap("tab-program").See("program");
        walk.Around("compensation program");
        seat.Tap("tab-gap").See("gap-after");
        walk.Around("compensation gap");
        seat.Tap("tab-decisions").See("decisions");
        walk.Around("compensation decisions");
        seat.Tap("approve").Type("signing-password", "x");
        walk.Around("signing", first: "signing-password");
        seat.User.Press(Key.Escape);

        Go(ScreenKeys.Verification, "pair");
        walk.Around("verification");
        Go(ScreenKeys.Freeform, "plan");
        walk.Around("freeform");
        Go(ScreenKeys.History, "found-1");
        walk.Around("history");
        seat.Tap("found-1").See("detail-title");
        walk.Around("history opened");
        seat.Tap("history-choose-folder").See("chooser-confirm");
        walk.Around("file chooser", first: "chooser-up");
        seat.User.Press(Key.Escape);
        Go(ScreenKeys.Messages, "message-1");
        walk.Around("messages");
        Go(ScreenKeys.Settings, "user-row-anna");
        seat.Tap("user-row-anna");
        walk.Around("settings users");
        seat.Tap("tab-connections");
        walk.Around("settings connections");
        seat.Tap("tab-look");
        walk.Around("settings look");
        seat.Tap("tab-about");
        walk.Around("settings about");
        Assert.True(walk.Problems.Count == 0, string.Join('\n', walk.Problems));
        Assert.True(walk.Stops > 500, "Tab goes nowhere any more.");

        void Go(string screen, string id)
        {
            seat.Shell.Go(screen);
            seat.See(id);
        }
    });

    [Fact]
    public Task Arrows_go_on_within_a_list_a_row_of_tabs_and_a_program() => Seat.AtAsync(seat =>
    {
        seat.SignIn(DemoCell.Setter);
        seat.See("nav-overview").Focus(NavigationMethod.Tab);
        foreach (var item in seat.Shell.Items.Skip(1))
        {
            seat.User.Press(Key.Down);
            seat.WaitFor(() => seat.Shell.Chosen == item, $"Down does not open {item.Screen.Key}.");
            Assert.True(seat.See(item.Screen.AutomationId).IsFocused, item.Screen.Key);
        }

        seat.Shell.Go(ScreenKeys.System);
        var here = new SetupSeat(seat).Settle();
        seat.See("side-coordinates").Focus(NavigationMethod.Tab);
        foreach (var side in Setup.Skip(1))
        {
            seat.User.Press(Key.Right);
            Assert.True(seat.See("side-" + side) is TabItem { IsSelected: true, IsFocused: true }, side);
        }

        // The blocks of a feature, from the path to the text and back by Tab, taken by Enter.
        seat.Tap("side-blocks").WaitFor(() => here.System.Picture?.Marks.Count == 3, "The program is not opened.");
        var (picture, path) = (here.System.Picture!, (PathPlot)seat.See("program-path"));
        seat.See("program-text").Focus(NavigationMethod.Tab);
        seat.User.Press(Key.Home).Press(Key.Down).Press(Key.Down);
        Assert.Equal(2, picture.Cursor);
        seat.User.Press(Key.Tab);
        Assert.True(path.IsFocused);
        seat.User.Press(Key.PageDown);
        Assert.StartsWith("N", picture.Chosen, StringComparison.Ordinal);
        var (chosen, scale) = (picture.Chosen, path.View.ScaleX);
        seat.User.Press(Key.Add).Press(Key.Right);
        Assert.True(path.View.ScaleX > scale);
        seat.User.Press(Key.Tab, RawInputModifiers.Shift).Press(Key.Enter);
        seat.WaitFor(() => here.Draft.Features[0].Blocks == chosen, "Enter does not take what is lit.");

        // What is only read is scrolled.
        seat.Shell.Go(ScreenKeys.Settings);
        seat.Tap("tab-about").See("about-parts-scroll").Focus(NavigationMethod.Tab);
        seat.User.Press(Key.PageDown);
        Assert.True(((ScrollViewer)seat.See("about-parts-scroll")).Offset.Y > 0);
    });

    [Fact]
    public Task A_correction_is_approved_without_a_pointer() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.See("login-name");
        seat.User.Type(DemoCell.Setter).Press(Key.Tab).Type(DemoCell.Password).Press(Key.Enter);
        seat.WaitFor(() => !seat.Shell.IsLocked, "Enter does not sign in.");
        TabTo(seat, "waiting-1").Press(Key.Enter);
        seat.See("approve");
        seat.WaitFor(() => seat.See("approve").IsEffectivelyEnabled, "It cannot be approved.");
        TabTo(seat, "approve").Press(Key.Space);
        seat.See("signing-confirm");
        seat.User.Press(Key.Escape);
        seat.WaitFor(
            () => seat.Shell.Signing is null && seat.See("approve").IsFocused, "Escape does not lead back to where the focus was.");
        seat.User.Press(Key.Enter);
        seat.See("signing-password");
        seat.User.Type(DemoCell.Password).Press(Key.Enter);
        seat.WaitFor(1, CorrectionState.Verified);
        seat.WaitFor(() => seat.Shell.Signing is null, "The signature stays open.");
    });

    [Fact]
    public Task Enter_and_Escape_are_the_dialogs_and_not_those_of_the_screen_behind_it() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Setter).Tap("nav-history").See("found-1");

        // The search behind it takes Enter, the way back takes Escape.
        seat.Tap("found-1").See("detail-title");
        var history = (HistoryViewModel)seat.Shell.Current!;
        var folder = Path.GetDirectoryName(seat.Cell.Settings.File)!;
        seat.Tap("history-choose-folder").Type("chooser-path", folder).User.Press(Key.Enter);
        seat.WaitFor(() => seat.Shell.Choosing is null && history.Folder == folder, "Enter does not choose the folder.");
        seat.Tap("history-choose-folder").See("chooser-confirm");
        seat.User.Press(Key.Escape);
        Assert.Null(seat.Shell.Choosing);
        Assert.NotNull(history.Detail);
        seat.User.Press(Key.Escape);
        Assert.Null(history.Detail);
    });

    private static Hmi.Testing.ScreenUser TabTo(Seat seat, string id)
    {
        // What comes once the cell was looked at is not there at the first Tab.
        seat.See(id);
        for (var i = 0; i < 60 && seat.Find(id) is not { IsFocused: true }; i++)
        {
            seat.User.Press(Key.Tab);
        }

        Assert.True(seat.See(id).IsFocused, $"Tab does not get to {id}.");
        return seat.User;
    }
}
