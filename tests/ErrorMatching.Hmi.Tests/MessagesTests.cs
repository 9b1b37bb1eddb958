using Avalonia.Controls;
using Avalonia.VisualTree;
using ErrorMatching.Cell;
using Microsoft.Data.Sqlite;

namespace ErrorMatching.Hmi.Tests;

public sealed class MessagesTests
{
    [Fact]
    public Task What_waits_is_said_with_what_to_do_and_leads_there() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Setter).Tap("nav-messages").See("message-1");
        Assert.Equal(
            (
                $"#1 · 0001 needs approval: largest displacement {Shown.Mm(seat.Station.Store.Find(1)!.LargestMm)}\u00a0mm.",
                "Tap to see what will change, then approve or reject it."),
            ((MessagesViewModel)seat.Shell.Current!).Messages.Where(m => m.Alarm is null)
                .Select(m => (m.What, m.Next))
                .Single());
        seat.Tap("message-1");
        seat.WaitFor(() => seat.Find("detail-title") is not null, "The tap does not lead there.");
        Assert.Equal("#1 · 0001", seat.TextOf("detail-title"));
    });

    [Fact]
    public Task The_trail_is_shown_latest_first_and_verified() => Seat.AtAsync(seat =>
    {
        seat.SignIn(DemoCell.Setter).Tap("nav-messages").Tap("tab-trail");
        var screen = (MessagesViewModel)seat.Shell.Current!;
        seat.WaitFor(() => screen.Entries.Count > 0, "The trail stays empty.");
        Assert.Equal((DemoCell.Setter, "signed in"), (screen.Entries[0].Who, screen.Entries[0].What));
        Assert.Equal(seat.Station.Store.AuditEntries(0, 1000).Count, screen.Entries.Count);
        seat.Tap("audit-verify").See("audit-finding");
        Assert.Equal($"All {screen.Entries.Count} entries are unchanged.", seat.TextOf("audit-finding"));
    });

    [Fact]
    public Task Of_a_long_basis_the_first_sentence_is_read_and_all_of_it_after_a_tap() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        seat.SignIn(DemoCell.Setter).Tap("nav-messages").Tap("tab-trail");
        var screen = (MessagesViewModel)seat.Shell.Current!;
        seat.WaitFor(() => screen.Entries.Any(e => e.What == "calculated"), "Nothing was computed.");
        var entry = screen.Entries.Single(e => e.What == "calculated");
        Assert.Contains("Point 4 is on a rounded corner", entry.Basis, StringComparison.Ordinal);
        Assert.Equal($"displaced by at most {Shown.Mm(seat.Station.Store.Find(1)!.LargestMm)}\u00a0mm at block N150. …", entry.Short);
        Assert.All(screen.Entries.Where(e => e.What != "calculated"), e => Assert.Equal(e.Basis, e.Short));

        ListBoxItem Row() =>
            ((ListBox)seat.See("audit")).GetVisualDescendants().OfType<ListBoxItem>().Single(i => Equals(i.DataContext, entry));
        string? Said() => Row().GetVisualDescendants().OfType<TextBlock>().Last().Text;
        seat.WaitFor(() => Said() == entry.Short, "The row is as long as ever.");
        seat.User.Click(Row());
        seat.WaitFor(() => Said() == entry.Basis, "A tap does not show the rest.");
    });

    [Theory]
    [InlineData("One. Two.", "One.")]
    [InlineData("一。二。", "一。")]
    [InlineData("一。Two. 三。", "一。")]
    [InlineData("0.5 mm", "0.5 mm")]
    [InlineData("", "")]
    public void The_first_sentence_ends_with_its_stop(string text, string first) => Assert.Equal(first, Sentence.First(text));

    [Fact]
    public Task What_is_acknowledged_says_by_whom_and_what_is_shelved_comes_back() => Seat.AtAsync(
        seat =>
        {
            // The cell does not run, and the first correction failed.
            seat.SignIn(DemoCell.Setter).Tap("nav-messages").See("message-1");
            var screen = (MessagesViewModel)seat.Shell.Current!;
            Assert.Equal(
                [AlarmKind.NotRunning, AlarmKind.Failed], screen.Messages.Select(m => m.Alarm!.Kind));
            Assert.Equal((true, false), (screen.Messages[0].CanAcknowledge, screen.Messages[0].CanShelve));
            Assert.Equal((true, true), (screen.Messages[1].CanAcknowledge, screen.Messages[1].CanShelve));
            Assert.Equal("High priority · not acknowledged", screen.Messages[0].Marked);

            seat.Tap("message-1-acknowledge");
            seat.WaitFor(() => screen.Messages[1].IsKnown, "It is not acknowledged.");
            Assert.Matches(
                $"^Medium priority · since .* · acknowledged by {DemoCell.Setter}, ", screen.Messages[1].Marked!);
            Assert.Null(seat.Find("message-1-acknowledge"));

            seat.Tap("message-1-shelve").Tap("shelve-not").See("message-1-shelve");
            seat.Tap("message-1-shelve").Tap("shelve-two-hours");
            seat.WaitFor(() => screen.Messages.Count == 1, "It is not shelved.");
            Choose(seat, AlarmFilter.Shelved);
            seat.WaitFor(() => screen.Messages is [{ CanBringBack: true }], "What is shelved is not listed.");
            Assert.Matches($" · shelved by {DemoCell.Setter} until ", screen.Messages[0].Marked!);
            seat.Tap("message-1-back");
            seat.WaitFor(() => seat.TextOf("messages-quiet") == "There are no such alarms.", "It is not brought back.");
            Choose(seat, AlarmFilter.New);
            seat.WaitFor(() => screen.Messages is [{ Alarm.Kind: AlarmKind.NotRunning }], "What somebody acknowledged is listed.");

            // All of that is in the trail, where what concerns alarms is found.
            seat.Tap("tab-trail").Tap("audit-alarms");
            string[] words = ["alarm brought back", "alarm shelved", "alarm acknowledged", "failed"];
            seat.WaitFor(() => screen.Entries.Select(e => e.What).Distinct().SequenceEqual(words), "The trail does not have it.");
            seat.Tap("audit-alarms").Type("audit-who", DemoCell.Setter).Tap("audit-search");
            seat.WaitFor(
                () => screen.Entries.Count > 0 && screen.Entries.All(e => e.Who == DemoCell.Setter), "It is not found by person.");
            seat.Type("audit-who", "").Type("audit-about", "0001").Tap("audit-search");
            seat.WaitFor(
                () => screen.Entries.Count > 0 && screen.Entries.All(e => e.Subject.Contains('1', StringComparison.Ordinal))
                    && screen.Entries.Any(e => e.What == "arrived"),
                "It is not found by serial number.");
            seat.Type("audit-about", "").Type("audit-from", "tomorrow").Tap("audit-search");
            seat.See("audit-wrong-day");
            Assert.NotEmpty(screen.Entries);

            // What is only typed is not searched for.
            seat.Type("audit-from", "2199-01-01");
            seat.User.Wait(TimeSpan.FromSeconds(3));
            Assert.NotEmpty(screen.Entries);
            Assert.NotNull(seat.Find("audit-wrong-day"));
            seat.Tap("audit-search");
            seat.WaitFor(() => screen.Entries.Count == 0, "Another day is listed.");
            Assert.Null(seat.Find("audit-wrong-day"));

            static void Choose(Seat seat, AlarmFilter filter)
            {
                var box = (ComboBox)seat.See("alarms-filter");
                box.SelectedIndex = (int)filter;
            }
        },
        prepare: Fail);

    [Fact]
    public Task An_operator_acknowledges_and_does_not_shelve() => Seat.AtAsync(
        seat =>
        {
            seat.SignIn(DemoCell.Operator).Tap("nav-messages").See("message-1-acknowledge");
            Assert.Null(seat.Find("message-1-shelve"));
            var screen = (MessagesViewModel)seat.Shell.Current!;

            // Not behind the button either.
            screen.Shelve(screen.Messages[1], TimeSpan.FromHours(2));
            seat.WaitFor(() => seat.Find("alarms-message") is not null, "Nobody refuses it.");
            Assert.Empty(new AlarmBook(seat.Station.Store, seat.Station.Clock).Read());
            seat.Tap("message-1-acknowledge");
            seat.WaitFor(() => screen.Messages[1].IsKnown, "It is not acknowledged.");
        },
        prepare: Fail);

    private static void Fail(string folder)
    {
        var settings = CellSettingsReader.Read(Path.Combine(folder, "cell", "cell.json"));
        using var store = CellStore.Open(settings.Store, TimeProvider.System, AuditKey.Open(settings.KeysFolder));
        var arrived = store.Archive(new(settings.Gauges[0].Name, "part-0001.csv", "0001", "0001"u8.ToArray(), "trace")).Correction;
        store.Step(
            arrived, CorrectionState.Recognized, "cell", "by name", c => c with { Job = settings.Jobs[0].Name, Serial = "0001" });
        store.Step(store.Find(arrived.Id)!, CorrectionState.Failed, "cell", "the machine is away", c => c with { Reason = "away" });
    }

    [Fact]
    public Task A_trail_that_somebody_changed_is_an_alarm_that_names_the_entry() => Seat.AtAsync(seat =>
    {
        using (var connection = new SqliteConnection($"Data Source={((SqliteSettings)seat.Cell.Settings.Store).File};Pooling=False"))
        {
            connection.Open();
            using var command = connection.CreateCommand();
            command.CommandText = "DROP TRIGGER audit_update; UPDATE audit SET basis = 'nothing to see' WHERE seq = 2";
            Assert.Equal(1, command.ExecuteNonQuery());
        }

        seat.SignIn(DemoCell.Setter).Tap("nav-messages").Tap("tab-trail").Tap("audit-verify").See("audit-finding");
        Assert.Equal("Entry 2: it was changed.", seat.TextOf("audit-finding"));
        Assert.Equal(Severity.Alarm, ((MessagesViewModel)seat.Shell.Current!).FindingSeverity);
    });

    [Fact]
    public Task Verifying_the_trail_is_cancelled_and_finds_nothing_then() => Seat.AtAsync(seat =>
    {
        seat.SignIn(DemoCell.Setter).Tap("nav-messages").Tap("tab-trail").See("audit-verify");
        var screen = (MessagesViewModel)seat.Shell.Current!;

        // A trail may be read before anybody can cancel that: then once more.
        for (var i = 0; i < 100; i++)
        {
            screen.Verify.Execute(null);
            screen.Verify.Cancel.Execute(null);
            seat.WaitFor(() => !screen.Verify.IsRunning, "It does not end.");
            if (screen.Finding is null)
            {
                break;
            }

            seat.Tap("nav-overview").Tap("nav-messages").Tap("tab-trail").See("audit-verify");
            screen = (MessagesViewModel)seat.Shell.Current!;
        }

        Assert.Null(seat.Find("audit-finding"));
        Assert.Null(seat.Find("messages-message"));
        seat.Tap("audit-verify").See("audit-finding");
    });

    [Fact]
    public Task A_cell_that_stands_is_said_with_what_to_do_until_it_runs() => Seat.AtAsync(seat =>
    {
        seat.SignIn(DemoCell.Operator).Tap("nav-messages");
        var screen = (MessagesViewModel)seat.Shell.Current!;
        seat.WaitFor(() => screen.Messages.Count == 1, "Nothing is said.");
        Assert.Equal((Severity.Alarm, "Nothing is lost: start it again."), (screen.Messages[0].Severity, screen.Messages[0].Next));
        Assert.Null(seat.Find("messages-quiet"));
        seat.Cell.Run();
        seat.See("messages-quiet");
    });
}
