using ErrorMatching.Cell;
using ErrorMatching.Hmi.Testing;

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
    public void A_code_is_as_fast_as_no_hand_is()
    {
        Assert.Equal("1234", Typed("1\u001b2 34 ", ScannedCode.Fast)?.Replace(" ", "", StringComparison.Ordinal));
        Assert.Null(Typed("1234", ScannedCode.Fast + 1));
        Assert.Null(Typed("demonstration", ScreenUser.ByHandMs));
        Assert.Null(Typed("12", 1));
        Assert.Equal("123", Typed("123", 1));
    }

    [Fact]
    public void One_slow_key_makes_all_of_it_typed_by_hand()
    {
        var code = new ScannedCode();
        foreach (var (text, at) in new (string, ulong)[] { ("p", 5000), ("a", 5200), ("s", 5210), ("s", 5220), ("1", 5230), ("2", 5240) })
        {
            code.Add(text, at);
        }

        Assert.Null(code.End(5250));

        // The next one is judged by itself, at once after Enter or after a pause.
        Assert.Equal("0001", Typed("0001", 10, code, 5300));
        code.Add("x", 6000);
        Assert.Equal("0002", Typed("0002", 10, code, 6000 + ScannedCode.Pause + 1));
    }

    [Fact]
    public void A_slow_scanner_sends_a_prefix()
    {
        var code = new ScannedCode();
        code.Announce(1000);
        Assert.Equal("7", Typed("7", ScannedCode.Pause, code, 1000));
        Assert.Null(Typed("demonstration", ScreenUser.ByHandMs, code, 9000));
        code.Announce(50_000);
        Assert.Null(Typed("demonstration", ScreenUser.ByHandMs, code, 50_000 + ScannedCode.Pause + 1));
    }

    [Fact]
    public void A_code_that_is_too_long_is_none()
    {
        Assert.Equal(ScannedCode.Most, Typed(new string('7', ScannedCode.Most), 10)!.Length);
        Assert.Null(Typed(new string('7', ScannedCode.Most + 4), 10));
        Assert.Equal("888", Typed("888", 10));
    }

    private static string? Typed(string text, ulong betweenMs, ScannedCode? code = null, ulong at = 1_000_000)
    {
        code ??= new();
        foreach (var c in text)
        {
            code.Add(c.ToString(), at += betweenMs);
        }

        return code.End(at + betweenMs);
    }

    private static HistoryViewModel History(Seat seat) => (HistoryViewModel)seat.Shell.Current!;

    private static void Scan(Seat seat, string code) => seat.User.Scan(code);

    private static void Found(Seat seat, string id, string not) =>
        seat.WaitFor(
            () => !History(seat).Search.IsRunning && seat.Find(id) is not null && seat.Find(not) is null, $"{id} is not found alone.");
}
