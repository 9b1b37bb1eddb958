using Avalonia.Controls;
using Avalonia.VisualTree;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

/// <summary>A counterpart that was measured outside of its limits is told until somebody has looked at it, each of them;
/// and the history tells it for good.</summary>
[Trait("Length", "Long")]
public sealed class MeasuredOutsideTests
{
    [Fact]
    public Task It_is_told_in_overview_and_messages_leads_to_the_verification_and_is_over_when_it_was_looked_at() => Seat.AtAsync(seat =>
    {
        seat.RunCell();
        CutAndMeasure(seat, 1);
        seat.SignIn(DemoCell.Operator).See("measured-2");
        var overview = (OverviewViewModel)seat.Shell.Current!;
        var piece = seat.Station.Outside.Single();
        var (verdict, detailed) = (PieceDetail.VerdictOf(piece), VerifyVerdictText.Of(piece.Verdict!));
        Assert.Matches("^[0-9]+ points outside their limits: .*4.*\\.$", verdict);
        Assert.Equal(("Counterparts measured outside their limits: 1", Severity.Attention), (overview.Summary, overview.Severity));
        Assert.Equal(
            ("Complex mating · #2 · 0001", "Measured: " + verdict, Severity.Attention),
            overview.Waiting.Select(t => (t.Name, t.State, t.Severity)).Single());
        BothLanguages.Take(seat, "overview-measured-outside");
        seat.Tap("nav-messages").See("message-2");
        Assert.Contains(
            "#2 · 0001 was measured: " + verdict, seat.See("message-2").GetVisualDescendants().OfType<TextBlock>().Select(t => t.Text));
        seat.Tap("message-2").See("piece-title");
        Assert.Equal(
            (ScreenKeys.Verification, "#1 · 0001", detailed),
            (seat.Shell.Chosen!.Screen.Key, seat.TextOf("piece-title"), seat.TextOf("piece-verdict")));
        BothLanguages.Take(seat, "verification-measured-outside");
        seat.Tap("nav-overview").See("overview-summary");
        Assert.Equal("All is well", seat.TextOf("overview-summary"));
        seat.Tap("nav-messages").See("messages-quiet");
    });

    [Fact]
    public Task Of_several_the_newest_is_told_with_how_many_more_until_each_was_looked_at_and_the_history_tells_of_all() =>
        Seat.AtAsync(seat =>
    {
        seat.RunCell();
        CutAndMeasure(seat, 1);
        seat.Cell.FinishPiece();
        seat.WaitFor(1, CorrectionState.Released);
        CutAndMeasure(seat, 2);
        seat.SignIn(DemoCell.Setter).See("measured-4");
        Assert.Null(seat.Find("measured-2"));
        var overview = (OverviewViewModel)seat.Shell.Current!;
        seat.WaitFor(() => overview.Waiting.Count == 1, "Something else waits, too.");
        Assert.Equal(("Counterparts measured outside their limits: 2", ""), (overview.Summary, overview.Counts));
        Assert.EndsWith(
            "\n1 more is outside its limits: it is marked in the list under Verification.",
            overview.Waiting.Single().State,
            StringComparison.Ordinal);

        // A station that is started now tells of the last one alone: it is not begun with old ones.
        var later = new MeasuredOutside(seat.Cell.Settings);
        Assert.Equal([4L], later.Now(seat.Station.Store).Select(p => p.LastId));
        Assert.Equal([4L], later.Now(seat.Station.Store).Select(p => p.LastId));
        seat.Cell.Deliver(3, 0.003);
        seat.WaitFor(
            () => seat.TextOf("overview-counts") == "1 approval · 2 measured counterparts outside their limits",
            "It is not said how many wait.");
        BothLanguages.Take(seat, "overview-measured-outside-several");
        seat.Tap("nav-messages").See("message-4");
        Assert.Null(seat.Find("message-2"));
        Assert.Contains(
            "\n1 more is outside",
            ((MessagesViewModel)seat.Shell.Current!).Messages.Single(m => m.IsMeasured).What,
            StringComparison.Ordinal);

        // What was cut says how it was measured, and so does the measurement itself.
        seat.Tap("nav-history").Tap("found-1").See("history-measured");
        var history = (HistoryViewModel)seat.Shell.Current!;
        Assert.StartsWith("The counterpart was measured as #2 · 0001. ", history.Measured, StringComparison.Ordinal);
        var outside = history.Measured![
            "The counterpart was measured as #2 · 0001. ".Length..history.Measured!.IndexOf(" points", StringComparison.Ordinal)];
        Assert.Equal((Severity.Attention, $"Measured: {outside} outside"), (history.MeasuredSeverity, history.MeasuredInShort));
        BothLanguages.Take(seat, "history-measured");
        seat.Tap("history-back")
            .Tap("found-2")
            .WaitFor(() => seat.Find("detail-title") is not null && seat.TextOf("detail-title") == "#2 · 0001", "It is not opened.");
        Assert.StartsWith("The counterpart was measured as #2 · 0001. ", history.Measured, StringComparison.Ordinal);
        seat.Tap("history-measured").See("piece-title");
        Assert.Equal("#1 · 0001", seat.TextOf("piece-title"));

        // Only the older one was looked at. Both are marked in the list.
        seat.Tap("nav-overview").See("measured-4");
        Assert.Equal("1 approval · 1 measured counterpart outside its limits", seat.TextOf("overview-counts"));
        seat.Tap("measured-4").See("piece-title");
        Assert.Equal("#3 · 0002", seat.TextOf("piece-title"));
        Assert.Equal(
            [("#3 · 0002", Severity.Alarm), ("#1 · 0001", Severity.Alarm)],
            ((VerificationViewModel)seat.Shell.Current!).Rows.Where(r => r.Kind == "Measured").Select(r => (r.Title, r.Severity)));
        seat.Tap("nav-overview").WaitFor(
            () => (OverviewViewModel)seat.Shell.Current! is { Counts: "", Summary: "Waiting for approval: 1" },
            "What was looked at is still counted.");
    });

    [Fact]
    public Task The_older_one_is_told_when_the_newest_was_looked_at_first_and_a_piece_that_was_measured_again_once() => Seat.AtAsync(seat =>
    {
        seat.RunCell();
        CutAndMeasure(seat, 1);
        seat.Cell.FinishPiece();
        seat.WaitFor(1, CorrectionState.Released);
        CutAndMeasure(seat, 2);
        seat.Cell.DeliverCounterpart(1, 0.004);
        seat.WaitFor(5, CorrectionState.Recorded);
        seat.WaitFor(() => seat.Station.State.Outside is [{ LastId: 5 }, ..], "The second measurement is not seen.");
        Assert.Equal([5L, 4L], seat.Station.State.Outside.Select(p => p.LastId));
        seat.SignIn(DemoCell.Setter).Tap("measured-5").See("piece-title");
        Assert.Equal("#1 · 0001", seat.TextOf("piece-title"));
        seat.Tap("nav-overview").Tap("measured-4").See("piece-title");
        Assert.Equal("#3 · 0002", seat.TextOf("piece-title"));
        seat.Tap("nav-overview").WaitFor(() => seat.TextOf("overview-summary") == "All is well", "What was looked at is told.");
    });

    [Fact]
    public Task The_verification_opens_on_the_piece_that_was_looked_at_before() => Seat.AtAsync(seat =>
    {
        seat.RunCell();
        CutAndMeasure(seat, 1);
        for (var serial = 2; serial <= 3; serial++)
        {
            seat.Cell.Deliver(serial, 0.003);
            seat.WaitFor(serial + 1, CorrectionState.Proposed);
        }

        seat.SignIn(DemoCell.Setter).Tap("nav-verification").See("piece-title");
        Assert.Equal("#1 · 0001", seat.TextOf("piece-title"));
        seat.Tap("nav-overview").Tap("waiting-3").See("detail-title");
        seat.Tap("nav-verification").See("piece-title");
        Assert.Equal("#3 · 0002", seat.TextOf("piece-title"));
        seat.Tap("nav-compensation").Tap("correction-4").WaitFor(() => seat.TextOf("detail-title") == "#4 · 0003", "It is not shown.");
        seat.Tap("nav-verification").See("piece-title");
        Assert.Equal("#4 · 0003", seat.TextOf("piece-title"));
    });

    // A part is measured, its counterpart is cut and measured: corrections 2 n - 1 and 2 n.
    private static void CutAndMeasure(Seat seat, int serial)
    {
        var spread = serial == 1 ? 0 : 0.003;
        seat.Cell.Deliver(serial, spread);
        seat.WaitFor((2 * serial) - 1, CorrectionState.Proposed);
        new CorrectionDecisions(seat.Station.Store).Approve((2 * serial) - 1, DemoCell.Setter, null);
        seat.WaitFor((2 * serial) - 1, CorrectionState.Verified);
        seat.Cell.DeliverCounterpart(serial, spread);
        seat.WaitFor(2 * serial, CorrectionState.Recorded);
        seat.WaitFor(() => seat.Station.State.Outside is [{ LastId: var id }, ..] && id == 2 * serial, "The measured piece is not seen.");
    }
}
