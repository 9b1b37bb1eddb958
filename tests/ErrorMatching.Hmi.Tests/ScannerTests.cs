using Avalonia.Input;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

/// <summary>A barcode scanner is a keyboard that ends with Enter.</summary>
public sealed class ScannerTests
{
    [Fact]
    public Task A_piece_is_found_by_scanning_wherever_one_is() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.Cell.Deliver(2, 0.02);
        seat.WaitFor(2, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Operator).Tap("nav-overview");
        Scan(seat, "0002");
        Found(seat, "found-2", "found-1");
        Assert.Equal(("0002", ""), (History(seat).Serial, History(seat).WorkOrder));

        // With the focus in the field for the serial number each code takes the place of the one before.
        seat.User.Click(seat.See("history-serial"));
        Scan(seat, "0001");
        Scan(seat, "0002");
        Found(seat, "found-2", "found-1");
        Scan(seat, "0001");
        Found(seat, "found-1", "found-2");

        // Also when a correction is open, and elsewhere the focus is.
        seat.Tap("found-1").See("detail-title");
        seat.See("nav-history").Focus();
        Scan(seat, "0002");
        Found(seat, "found-2", "found-1");

        // A code that is no serial number is a work order.
        seat.See("nav-history").Focus();
        Scan(seat, "WO-4711");
        seat.WaitFor(() => History(seat).Scanning.IsCompleted && History(seat).WorkOrder == "WO-4711", "It is not taken for a work order.");
        Assert.Equal("", History(seat).Serial);
        Assert.Equal("Found: 0", seat.TextOf("history-found"));
    });

    [Fact]
    public Task A_code_that_comes_while_another_is_looked_for_is_not_lost() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Operator).Tap("nav-history").See("found-1");
        var history = History(seat);
        seat.WaitFor(() => !history.Search.IsRunning, "The first search does not end.");

        // A search may be over before it is waited for: then it is begun again.
        seat.WaitFor(
            () =>
            {
                history.Serial = "00020001";
                history.Search.Execute(null);
                return history.Search.IsRunning;
            },
            "No search is seen to run.");
        history.Serial = "0001";
        history.Search.Execute(null);
        seat.WaitFor(() => !history.Search.IsRunning, "The second search does not end.");
        Assert.Equal("Found: 1", seat.TextOf("history-found"));
    });

    [Fact]
    public Task Behind_a_dialog_and_a_lock_nothing_is_scanned() => Seat.AtAsync(seat =>
    {
        seat.User.Click(seat.See("login-user-anna"));
        seat.See("theme").Focus();
        Scan(seat, "0001");
        Assert.True(seat.Shell.IsLocked);
        seat.SignIn(DemoCell.Operator);
        var chosen = seat.Shell.ChooseAsync(new(FileChoiceKind.Folder, "History.Folder", []));
        seat.See("chooser-up").Focus();
        Scan(seat, "0001");
        Assert.Equal(ScreenKeys.Overview, seat.Shell.Chosen!.Screen.Key);
        seat.Shell.Choosing?.Leave.Execute(null);
        Assert.True(chosen.IsCompleted);
    });

    [Fact]
    public void Characters_with_pauses_between_them_are_no_code()
    {
        var clock = new SeatClock();
        var code = new ScannedCode(clock);
        code.Add("x");
        clock.Advance(TimeSpan.FromSeconds(2));
        code.Add("12");
        code.Add("\u001b34 ");
        Assert.Equal("1234", code.End());
        Assert.Null(code.End());
        code.Add("5");
        clock.Advance(TimeSpan.FromSeconds(2));
        Assert.Null(code.End());
    }

    [Fact]
    public void A_code_that_is_too_long_is_none()
    {
        var code = new ScannedCode(new SeatClock());
        code.Add(new string('7', ScannedCode.Most));
        Assert.Equal(ScannedCode.Most, code.End()!.Length);
        code.Add(new string('7', ScannedCode.Most));
        code.Add("7777");
        Assert.Null(code.End());
        code.Add("8");
        Assert.Equal("8", code.End());
    }

    private static HistoryViewModel History(Seat seat) => (HistoryViewModel)seat.Shell.Current!;

    private static void Scan(Seat seat, string code) => seat.User.Type(code).Press(Key.Enter);

    private static void Found(Seat seat, string id, string not) =>
        seat.WaitFor(
            () => !History(seat).Search.IsRunning && seat.Find(id) is not null && seat.Find(not) is null, $"{id} is not found alone.");
}
