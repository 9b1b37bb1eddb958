using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

public sealed class HistoryTests
{
    [Fact]
    public Task A_piece_is_found_by_its_serial_number_and_reopened_as_it_was() => Seat.AtAsync(async seat =>
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.Cell.Deliver(2, 0.02);
        seat.WaitFor(2, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Operator).Tap("nav-history").See("found-2");
        Assert.NotNull(seat.Find("found-1"));

        // What a barcode scanner does: it types into what has the focus, and ends with Enter.
        seat.User.Type("0002").Press(Avalonia.Input.Key.Enter);
        seat.WaitFor(() => seat.Find("found-1") is null, "The search does not find less.");
        seat.Tap("found-2");
        seat.WaitFor(() => seat.Find("detail-title") is not null, "It is not opened.");
        Assert.Equal("#2 · 0002", seat.TextOf("detail-title"));

        var folder = Path.Combine(Path.GetDirectoryName(seat.Cell.Settings.File)!, "handed out");
        seat.Type("history-folder", folder).Tap("history-export").See("history-exported");
        await ((HistoryViewModel)seat.Shell.Current!).Export.Running;
        var correction = seat.Station.Store.Find(2)!;
        Assert.Equal(seat.Station.Store.Content(correction.ReportSha256!), await File.ReadAllBytesAsync(Path.Combine(folder, "2-report.json"), CancellationToken.None));
        Assert.Equal(seat.Station.Store.Content(correction.ProgramSha256!), await File.ReadAllBytesAsync(Path.Combine(folder, "2-counterpart.nc"), CancellationToken.None));
        seat.Tap("history-back");
        Assert.NotNull(seat.Find("found-2"));
    });

    [Fact]
    public Task A_day_that_is_none_is_said() => Seat.AtAsync(seat =>
    {
        seat.SignIn(DemoCell.Operator).Tap("nav-history").Type("history-from", "yesterday").Tap("history-search");
        Assert.StartsWith("A day is written as year-month-day", seat.TextOf("history-message"), StringComparison.Ordinal);
    });

    [Fact]
    public Task What_is_chosen_stays_chosen_in_the_other_language() => Seat.AtAsync(seat =>
    {
        seat.SignIn(DemoCell.Setter).Tap("nav-history");
        var states = (Avalonia.Controls.ComboBox)seat.See("history-state");
        Assert.Equal("Any state", (states.SelectedItem as StateChoice)?.Name);
        seat.Tap("language");
        seat.User.Settle();
        Assert.Equal("任何狀態", (states.SelectedItem as StateChoice)?.Name);
    });
}
