using Avalonia.Input;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Everything that a station can show: each screen, each of its sides, and what is opened over them,
/// with whatever a cell delivers to be seen there.</summary>
internal sealed class Tour(Seat seat)
{
    // Each side, and something that stands on it.
    private static readonly (string Side, string Shows)[] Setup = [
        ("coordinates", "coordinates"),
        ("blocks", "program-text"),
        ("tolerances", "chain-add"),
        ("machine", "edit-compensation.gain"),
        ("gauge", "contribution-add")];
    private static readonly (string Side, string Shows)[] Mating = [
        ("points", "points"), ("counterpart", "counterparts"), ("features", "quantities"), ("program", "program"), ("gap", "gap-after"),
        ("decisions", "decisions"), ("course", "steps")];
    private static readonly (string Side, string Shows)[] Piece = [
        ("errors", "plot-errors"),
        ("assembly", "assembly-after"),
        ("improvement", "improvements"),
        ("trend", "plot-trend"),
        ("error-points", "error-points"),
        ("piece-details", "piece-summary")];
    private static readonly (string Side, string Shows)[] Surface =
        [
            ("map", "map"),
            ("solid", "solid"),
            ("compare", "map-radius"),
            ("surface-errors", "plot-surface-errors"),
            ("statistics", "statistics"),
            ("plan", "measured-plan"),
            ("finishing", "finishing-program"),
            ("surface-details", "surface-summary")];

    /// <summary>Lets the cell make what is shown: a piece that was cut and measured,
    /// a mating and a surface that wait for somebody.</summary>
    public Tour Deliver()
    {
        seat.RunCell();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        new CorrectionDecisions(seat.Station.Store).Approve(1, DemoCell.Setter, null);
        seat.WaitFor(1, CorrectionState.Verified);
        seat.Cell.DeliverCounterpart(1, 0);
        seat.WaitFor(2, CorrectionState.Recorded);
        seat.Cell.Deliver(2, 0.02);
        seat.WaitFor(3, CorrectionState.Proposed);
        seat.Cell.DeliverSurface(1, 0);
        seat.WaitFor(4, CorrectionState.Proposed);
        seat.WaitFor(() => seat.Station.State.Status?.Proposed.Count == 2, "The cell is not seen to propose.");
        return this;
    }

    /// <summary>Goes around, and has a look at each stop.</summary>
    /// <param name="look">Is told what is shown.</param>
    public void Around(Action<string> look)
    {
        look("login");
        seat.SignIn(DemoCell.Administrator);
        look("overview");
        SetUp(look);
        Correct(look);
        Open(ScreenKeys.Verification, "pair");
        Sides(look, "verification", "tab-", Piece);
        Open(ScreenKeys.Freeform, "surface-title");
        Sides(look, "freeform", "tab-", Surface);
        LookBack(look);
        Settings(look);
    }

    private void SetUp(Action<string> look)
    {
        Open(ScreenKeys.Points, "points-drawing");
        new SetupSeat(seat).Settle();
        look("points");
        Open(ScreenKeys.System, "coordinates");
        new SetupSeat(seat).Settle();
        Sides(look, "system", "side-", Setup);
        seat.Tap("dry-run").See("dry-run-back");
        look("dry run");
        seat.Tap("dry-run-back");
    }

    private void Correct(Action<string> look)
    {
        seat.Shell.Look(1);
        seat.See("pair");
        look("compensation of what is at a machine");
        seat.Shell.Look(3);
        seat.WaitFor(() => seat.TextOf("detail-title") == "#3 · 0002", "The proposed one is not shown.");
        look("compensation");
        Sides(look, "compensation", "tab-", Mating);
        seat.Tap("approve").See("signing-password");
        look("signing");
        seat.User.Press(Key.Escape);
        seat.Shell.Look(4);
        seat.See("detail-map");
        look("compensation of a surface");
        Sides(look, "compensation of a surface", "tab-", [("course", "steps")]);
    }

    private void LookBack(Action<string> look)
    {
        Open(ScreenKeys.History, "found-1");
        look("history");
        seat.Tap("found-1").See("detail-title");
        look("history opened");
        Sides(look, "history opened", "tab-", Mating);
        seat.Tap("history-choose-folder").See("chooser-confirm");
        look("chooser");
        seat.User.Press(Key.Escape);
        Open(ScreenKeys.Messages, "alarms-filter");
        seat.WaitFor(() => ((MessagesViewModel)seat.Shell.Current!).Entries.Count > 0, "The trail stays empty.");
        look("messages");
        seat.Tap("tab-trail").See("audit");
        look("messages, trail");
    }

    private void Settings(Action<string> look)
    {
        Open(ScreenKeys.Settings, "user-row-anna");
        seat.Tap("user-row-anna");
        look("settings, user");
        seat.Tap("users-new");
        look("settings, new user");
        seat.Tap("tab-connections");
        var page = ((SettingsViewModel)seat.Shell.Current!).Connections;
        seat.Tap("connections-test").WaitFor(
            () => !page.Test.IsRunning && page.Rows.All(r => r.Found is not null), "The test does not end.");
        Sides(look, "settings", "tab-", [("connections", "connections"), ("look", "look-sizes"), ("about", "about-parts")]);
    }

    private void Open(string screen, string id)
    {
        seat.Shell.Go(screen);
        seat.See(id);
    }

    private void Sides(Action<string> look, string screen, string prefix, (string Side, string Shows)[] sides)
    {
        foreach (var (side, shows) in sides)
        {
            seat.Tap(prefix + side).See(shows);
            look($"{screen}, {side}");
        }
    }
}
