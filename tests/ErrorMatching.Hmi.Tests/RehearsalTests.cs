using System.Collections.Specialized;
using Avalonia.Automation.Peers;
using Avalonia.Controls;
using Avalonia.VisualTree;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Screens are rehearsed behind the login: every one is opened, nobody sees it, and nothing comes of it.</summary>
public sealed class RehearsalTests
{
    [Fact]
    public Task Every_screen_and_view_is_opened_once_and_nothing_is_left() => Seat.AtAsync(async seat =>
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.Tap("login-user-anna").See("login-password").Focus();
        var (opened, shown) = (new List<object>(), new HashSet<Type>());
        seat.Window.Stage.Children.CollectionChanged += (_, e) => Note(e, opened, shown);
        var entries = seat.Station.Store.AuditEntries(0, 1000).Count;
        var rehearsal = new Rehearsal(seat.Window, seat.Shell).RunAsync(CancellationToken.None);
        seat.WaitFor(() => rehearsal.IsCompleted, "The rehearsal does not end.");
        await rehearsal;
        Assert.Equal(Screens.All.Count, opened.OfType<ScreenViewModel>().Select(o => o.GetType()).Distinct().Count());
        Assert.Equal(Views.Makers.Count(), shown.Count(t => t != typeof(ContentControl)));
        Assert.Empty(seat.Window.Stage.Children);

        // Whoever types a password goes on; nobody is signed in, and nothing is on record.
        Assert.True(seat.See("login-password").IsFocused);
        Assert.True(seat.Shell.IsLocked);
        Assert.Null(seat.Shell.Chosen);
        Assert.Null(seat.Shell.Notice);
        Assert.Equal(entries, seat.Station.Store.AuditEntries(0, 1000).Count);
        Assert.Equal(CorrectionState.Proposed, seat.Station.Store.Find(1)!.State);
    });

    // All of a screen in one step would keep keys waiting.
    [Fact]
    public Task A_screen_comes_part_by_part() => Seat.AtAsync(async seat =>
    {
        var grown = new List<int>();
        var stage = seat.Window.Stage;
        stage.LayoutUpdated += (_, _) =>
        {
            if (stage.Children is [PointsView { DataContext: not null } view])
            {
                grown.Add(view.GetVisualDescendants().Count(v => v.IsEffectivelyVisible));
            }
        };
        var rehearsal = new Rehearsal(seat.Window, seat.Shell).RunAsync(CancellationToken.None);
        seat.WaitFor(() => rehearsal.IsCompleted, "The rehearsal does not end.");
        await rehearsal;
        var steps = grown.Zip(grown.Skip(1), (before, after) => after - before).ToArray();
        Assert.True(grown.Max() > 150, $"Only {grown.Max()} of it are seen by {string.Join(" ", grown)}.");
        Assert.True(steps.Max() < grown.Max() * 2 / 3, $"{steps.Max()} of {grown.Max()} come at once.");
    });

    [Fact]
    public Task Somebody_signs_in_and_works_meanwhile() => Seat.AtAsync(async seat =>
    {
        var rehearsal = new Rehearsal(seat.Window, seat.Shell).RunAsync(CancellationToken.None);
        seat.SignIn(DemoCell.Setter).Tap("nav-points").Tap("add-line");
        Assert.True(seat.Shell.Editing.CanEdit);
        seat.WaitFor(() => rehearsal.IsCompleted, "The rehearsal does not end.");
        await rehearsal;
        Assert.Equal(ScreenKeys.Points, seat.Shell.Chosen!.Screen.Key);
        seat.WaitFor(() => seat.Shell.Editing.Undo.CanExecute(null), "What was done during the rehearsal is gone.");
    });

    [Fact]
    public Task A_window_that_closes_ends_it() => Seat.AtAsync(async seat =>
    {
        using var end = new CancellationTokenSource();
        var rehearsal = new Rehearsal(seat.Window, seat.Shell).RunAsync(end.Token);
        seat.WaitFor(() => seat.Window.Stage.Children.Count > 0, "It does not begin.");
        await end.CancelAsync();
        await Assert.ThrowsAnyAsync<OperationCanceledException>(() => rehearsal);
        Assert.Empty(seat.Window.Stage.Children);
    });

    [Fact]
    public Task A_screen_that_is_read_for_while_its_station_closes_is_no_defect() => Seat.AtAsync(seat =>
    {
        var station = new Station(seat.Cell.Settings, seat.Clock, Station.DefaultIdle);
        var shell = Screens.ShellOf(station);
        var history = new HistoryViewModel(shell);
        seat.WaitFor(() => history.Search.Running.IsCompleted, "The first search does not end.");
        history.Dispose();
        shell.Dispose();
        station.Dispose();
        history.Search.Execute(null);
        seat.WaitFor(() => history.Search.Running.IsCompleted, "The second search does not end.");
        Assert.True(history.Search.Running.IsCompletedSuccessfully);

        // Nobody sees it.
        Assert.Equal(Texts.Current.Word(StoreError.Away), history.Message);
    });

    // Nobody has signed in yet: what is not to be seen is not to be heard either.
    [Fact]
    public Task Screen_readers_find_nothing_of_it() => Seat.AtAsync(async seat =>
    {
        var rehearsal = new Rehearsal(seat.Window, seat.Shell).RunAsync(CancellationToken.None);
        var (found, heard) = (0, new List<Control>());
        seat.WaitFor(
            () =>
            {
                found += seat.Window.Stage.GetVisualDescendants().Count();
                heard.AddRange(
                    Heard(ControlAutomationPeer.CreatePeerForElement(seat.Window)).Where(c => seat.Window.Stage.IsVisualAncestorOf(c)));
                return rehearsal.IsCompleted;
            },
            "The rehearsal does not end.");
        await rehearsal;
        Assert.True(found > 0, "Nothing was rehearsed while it was listened to.");
        Assert.Empty(heard.Select(c => c.GetType().Name).Distinct());
    });

    private static IEnumerable<Control> Heard(AutomationPeer peer) =>
        peer.GetChildren().SelectMany(Heard).Concat(peer is ControlAutomationPeer { Owner: var owner } ? [owner] : []);

    private static void Note(NotifyCollectionChangedEventArgs e, List<object> opened, HashSet<Type> shown)
    {
        foreach (var control in e.NewItems?.OfType<Control>() ?? [])
        {
            shown.Add(control.GetType());
            if (control.DataContext is ScreenViewModel screen)
            {
                opened.Add(screen);
            }
        }
    }
}
