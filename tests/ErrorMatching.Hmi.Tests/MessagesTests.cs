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
            ((MessagesViewModel)seat.Shell.Current!).Messages.Where(m => m.Severity == Severity.Attention)
                .Select(m => (m.What, m.Next))
                .Single());
        seat.Tap("message-1");
        seat.WaitFor(() => seat.Find("detail-title") is not null, "The tap does not lead there.");
        Assert.Equal("#1 · 0001", seat.TextOf("detail-title"));
    });

    [Fact]
    public Task The_trail_is_shown_latest_first_and_verified() => Seat.AtAsync(seat =>
    {
        seat.SignIn(DemoCell.Setter).Tap("nav-messages");
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
        seat.SignIn(DemoCell.Setter).Tap("nav-messages");
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
    public Task What_there_is_to_know_has_the_same_room_however_much_it_is_and_the_trail_the_rest() => Seat.AtAsync(seat =>
    {
        seat.RunCell().SignIn(DemoCell.Setter).Tap("nav-messages").See("messages-quiet");
        var (now, trail) = (seat.Window.GetVisualDescendants().OfType<Border>().Single(b => b.Name == "Now"), seat.See("audit"));
        seat.WaitFor(() => now.Bounds.Height > 0 && trail.Bounds.Height > now.Bounds.Height, "The trail has no room.");
        var (room, verify) = (now.Bounds.Height, Layout.In(seat.See("audit-verify"), seat.Window));

        // However much there is to know, the trail is read as well.
        seat.Cell.Deliver(1, 0);
        seat.Cell.Deliver(2, 0.02);
        seat.WaitFor(2, CorrectionState.Proposed);
        seat.WaitFor(() => seat.Find("messages-quiet") is null, "Nothing is said.");
        Assert.Equal((room, verify), (now.Bounds.Height, Layout.In(seat.See("audit-verify"), seat.Window)));
        (seat.Window.Width, seat.Window.Height) = (960, 540);
        seat.WaitFor(
            () => seat.Find("messages-quiet") is null && now.Bounds.Height > 0 && trail.Bounds.Height > now.Bounds.Height / 2,
            "The trail has no room.");
    });

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

        seat.SignIn(DemoCell.Setter).Tap("nav-messages").Tap("audit-verify").See("audit-finding");
        Assert.Equal("Entry 2: it was changed.", seat.TextOf("audit-finding"));
        Assert.Equal(Severity.Alarm, ((MessagesViewModel)seat.Shell.Current!).FindingSeverity);
    });

    [Fact]
    public Task Verifying_the_trail_is_cancelled_and_finds_nothing_then() => Seat.AtAsync(seat =>
    {
        seat.SignIn(DemoCell.Setter).Tap("nav-messages").See("audit-verify");
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

            seat.Tap("nav-overview").Tap("nav-messages").See("audit-verify");
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
