using ErrorMatching.Cell;

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
        Assert.Equal($"All {screen.Entries.Count} entries are as they were written.", seat.TextOf("audit-finding"));
    });
}
