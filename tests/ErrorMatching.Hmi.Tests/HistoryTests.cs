using ErrorMatching.Cell;
using ErrorMatching.Testing;

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
        Assert.Equal(
            seat.Station.Store.Content(correction.ReportSha256!),
            await File.ReadAllBytesAsync(Path.Combine(folder, "2-report.json"), CancellationToken.None));
        Assert.Equal(
            seat.Station.Store.Content(correction.ProgramSha256!),
            await File.ReadAllBytesAsync(Path.Combine(folder, "2-counterpart.nc"), CancellationToken.None));
        seat.Tap("history-back");
        Assert.NotNull(seat.Find("found-2"));
    });

    [Fact]
    public Task What_was_found_says_who_had_a_part_in_it_and_is_exported_as_a_table() => Seat.AtAsync(async seat =>
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.Cell.Deliver(2, 0.02);
        seat.WaitFor(2, CorrectionState.Proposed);
        new CorrectionDecisions(seat.Station.Store).Reject(2, DemoCell.Operator, "=chip");
        seat.SignIn(DemoCell.Setter).Tap("nav-history").See("found-2");
        var screen = (HistoryViewModel)seat.Shell.Current!;
        Assert.Equal([DemoCell.Operator, Shown.Nothing], screen.Rows.Select(r => r.People));

        seat.Type("history-serial", "0002").Tap("history-search");
        seat.WaitFor(() => screen.Rows.Count == 1, "The search does not find less.");
        var folder = Path.Combine(Path.GetDirectoryName(seat.Cell.Settings.File)!, "handed out");
        Directory.CreateDirectory(folder);
        screen.Folder = folder;
        seat.Tap("history-export-found").Tap("chooser-confirm").See("history-found-exported");
        await screen.ExportFound.Running;
        var lines = await File.ReadAllLinesAsync(Assert.Single(Directory.GetFiles(folder, "history-*.csv")), CancellationToken.None);
        Assert.Equal(2, lines.Length);
        Assert.StartsWith("\"id\",\"arrived\",\"file\"", lines[0], StringComparison.Ordinal);
        Assert.StartsWith("\"2\",", lines[1], StringComparison.Ordinal);
        Assert.Contains($"\"rejected\",", lines[1], StringComparison.Ordinal);
        Assert.EndsWith($"\"{DemoCell.Operator}\",\"rejected: =chip\"", lines[1], StringComparison.Ordinal);

        seat.Tap("history-clear");
        seat.WaitFor(() => screen.Rows.Count == 2 && screen.Serial.Length == 0, "The fields are not emptied.");
    });

    // The slot is free again, so the piece is in no list of the screen for compensation any more; its program is still at the machine.
    [Fact]
    public Task A_piece_that_is_cut_is_reverted_from_the_history_as_long_as_its_program_is_there() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        for (var i = 1; i <= 2; i++)
        {
            seat.Cell.Deliver(i, 0.003);
            seat.WaitFor(i, CorrectionState.Proposed);
            new CorrectionDecisions(seat.Station.Store).Approve(i, DemoCell.Setter, null);
            seat.WaitFor(i, CorrectionState.Verified);
            new CorrectionDecisions(seat.Station.Store).Release(i, DemoCell.Operator, null);
        }

        seat.SignIn(DemoCell.Setter).Tap("nav-history").See("found-1");
        seat.Tap("found-1").See("history-back");
        Assert.False(seat.Find("history-revert") is { IsEffectivelyVisible: true });
        seat.Tap("history-back").Tap("found-2").See("history-revert");
        seat.Tap("history-revert");
        Assert.Contains(
            "The previous program is that of #1 · 0001", ((SigningViewModel)seat.Shell.Signing!).Consequence, StringComparison.Ordinal);
        seat.Type("signing-reason", "chatter").Type("signing-password", DemoCell.Password).Tap("signing-confirm");
        seat.WaitFor(2, CorrectionState.Reverted);
        Assert.Equal(
            seat.Station.Store.Content(seat.Station.Store.Find(1)!.ProgramSha256!),
            File.ReadAllBytes(Path.Combine(seat.Cell.MachineFolder, "counterpart.nc")));
        seat.WaitFor(() => seat.Find("history-revert") is not { IsEffectivelyVisible: true }, "It is offered again.");
    });

    [Fact]
    public Task A_work_order_of_the_job_finds_its_pieces_by_a_part_of_it() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0.003);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Operator).Tap("nav-history").Type("history-work-order", "wo-2021").Tap("history-search").See("found-1");
        Assert.Equal("WO-2021-02", ((HistoryViewModel)seat.Shell.Current!).Rows[0].WorkOrder);
    });

    // A screen of 1920 x 1080 at 200 %.
    [Theory]
    [InlineData(Language.English)]
    [InlineData(Language.TraditionalChinese)]
    public Task On_a_small_screen_what_was_found_is_seen_below_the_fields(Language language) => Seat.AtAsync(
        seat =>
        {
            seat.RunCell();
            for (var i = 1; i <= 2; i++)
            {
                seat.Cell.Deliver(i, 0.003);
                seat.WaitFor(i, CorrectionState.Proposed);
            }

            seat.SignIn(DemoCell.Setter);
            seat.Shell.Preferences.TouchSize = TouchSize.Largest;
            seat.Shell.Go(ScreenKeys.History);
            seat.See("found-2");
            Texts.Current.Language = language;
            seat.User.Settle();
            seat.User.Screenshot(Repository.PathTo("artifacts", "screenshots", $"history-small-{language}.png"));
            foreach (var id in new[] { "found-1", "found-2" })
            {
                var row = seat.See(id);
                Assert.Equal(row.Bounds.Height, Layout.Seen(row, seat.Window).Height, 1.0);
            }

            // The other fields come when they are asked for, and go again.
            Assert.Null(seat.Find("history-state"));
            seat.Tap("history-more")
                .Type("history-user", "nobody")
                .Tap("history-search")
                .WaitFor(() => seat.Find("found-1") is null, "The field does not count.");
            Assert.NotNull(seat.Find("history-state"));
            seat.Tap("history-fewer").See("history-more");
            Assert.Contains("accent", seat.See("history-more").Classes);
            Assert.Null(seat.Find("history-state"));
        },
        new(960, 540));

    [Fact]
    public Task A_day_that_is_none_is_said() => Seat.AtAsync(seat =>
    {
        seat.SignIn(DemoCell.Operator).Tap("nav-history").Type("history-from", "yesterday").Tap("history-search");
        Assert.StartsWith("Write a day as year-month-day", seat.TextOf("history-message"), StringComparison.Ordinal);
    });

    // On the screen the custom of the language; what is typed may follow either.
    [Theory]
    [InlineData(Language.English, "2026-11-22", "Write a day as year-month-day, such as 2026-11-22 or")]
    [InlineData(Language.TraditionalChinese, "2026/11/22", "日期請寫成 年/月/日，例如 2026/11/22；")]
    public Task A_day_is_shown_by_the_custom_of_the_language_and_taken_in_either(Language language, string example, string rule) =>
        Seat.AtAsync(seat =>
    {
        seat.SignIn(DemoCell.Operator).Tap("nav-history");
        Texts.Current.Language = language;
        seat.User.Settle();
        Assert.Equal(
            [example, example],
            new[] { "history-from", "history-to" }.Select(f => ((Avalonia.Controls.TextBox)seat.See(f)).PlaceholderText));
        seat.Type("history-from", "22.11.2026").Tap("history-search");
        Assert.StartsWith(rule, seat.TextOf("history-message"), StringComparison.Ordinal);
        foreach (var day in new[] { "2026-11-22", "2026/11/22" })
        {
            seat.Type("history-from", day).Tap("history-search");
            seat.WaitFor(() => ((HistoryViewModel)seat.Shell.Current!).Message is null, $"{day} is taken for no day.");
        }

        Texts.Current.Language = Language.English;
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

    [Fact]
    public Task Each_field_finds_its_own_and_what_was_stays_as_it_was() => Seat.AtAsync(
        seat =>
        {
            seat.Cell.Run();
            seat.Cell.Deliver(1, 0);
            seat.WaitFor(1, CorrectionState.Proposed);
            new CorrectionDecisions(seat.Station.Store).Approve(1, DemoCell.Setter, null);
            var sent = seat.WaitFor(1, CorrectionState.Verified);

            // The next piece is of a work order that its file names, and of a job that was changed.
            seat.SignIn(DemoCell.Setter).Tap("nav-points");
            new SetupSeat(seat).Settle();
            seat.Shell.Editing.Change("", d => d.With("$.compensation.gain", "0.5"));
            new SetupSeat(seat).Settle();
            seat.Save().WaitFor(() => seat.Shell.Editing.Notice is not null, "It is not saved.");
            var (outside, incoming) = (
                Path.Combine(Path.GetDirectoryName(seat.Cell.Settings.File)!, "WO-4711_0002.csv"), seat.Cell.Settings.Gauges[0].Incoming!);
            File.WriteAllText(
                outside,
                DemoPart.Near(File.ReadAllText(Path.Combine(AppContext.BaseDirectory, "samples", "complex-mating", "part.csv")), 2, 0.02));
            File.Move(outside, Path.Combine(incoming, Path.GetFileName(outside)));
            seat.WaitFor(2, CorrectionState.Proposed);
            seat.Tap("nav-history").See("found-2");
            var today = seat.Clock.GetLocalNow();
            Finds("history-serial", "0001", 1);
            Finds("history-work-order", "WO-4711", 2);
            Finds("history-program", sent.ProgramSha256![..10], 1);
            Finds("history-program", "counterpart.nc", 1, 2);
            Finds("history-user", DemoCell.Setter, 1);
            Finds("history-user", "nobody");
            Finds("history-from", today.AddDays(2).ToString("yyyy-MM-dd", System.Globalization.CultureInfo.InvariantCulture));
            Finds("history-to", today.AddDays(2).ToString("yyyy-MM-dd", System.Globalization.CultureInfo.InvariantCulture), 1, 2);
            Finds("history-to", today.AddDays(-2).ToString("yyyy-MM-dd", System.Globalization.CultureInfo.InvariantCulture));

            // Reopened as it was: figures and program of then, though the job is another one now.
            seat.Type("history-serial", "0001")
                .Tap("history-search")
                .WaitFor(() => seat.Find("found-2") is null && seat.Find("found-1") is not null, "It is not found.");
            seat.Tap("found-1").See("detail-title");
            var (history, kept) = (
                (HistoryViewModel)seat.Shell.Current!, StoredReport.Read(seat.Station.Store.Content(sent.ReportSha256!)).Match!);
            Assert.Equal(kept.KeyPoints.Select(p => p.Correction), history.Detail!.Stored.Report!.KeyPoints.Select(p => p.Correction));
            Assert.Contains(history.Detail.Stored.Report.KeyPoints, p => p.Correction.Length > 0.1);
            Assert.Equal(
                System.Text.Encoding.Latin1.GetString(seat.Station.Store.Content(sent.ProgramSha256!))
                    .TrimEnd('\n')
                    .Split('\n')
                    .Select(l => l.TrimEnd('\r')),
                history.Detail.Lines!.Select(l => l.Modified));
            Assert.Null(seat.Find("approve"));

            void Finds(string field, string text, params int[] found)
            {
                seat.Type(field, text).Tap("history-search");
                seat.WaitFor(
                    () => !((HistoryViewModel)seat.Shell.Current!).Search.IsRunning
                        && new[] { 1, 2 }.All(i => seat.Find("found-" + Shown.Id(i)) is not null == found.Contains(i)),
                    $"{field} {text} does not find {string.Join(", ", found)}.");
                seat.Type(field, "");
            }
        },
        prepare: folder =>
        {
            var file = Path.Combine(folder, "cell", "cell.json");
            File.WriteAllText(
                file,
                File.ReadAllText(file).Replace(
                    "^part-(?<serial>", "^(part-|(?<workOrder>WO-[0-9]+)_)(?<serial>", StringComparison.Ordinal));
        });
}
