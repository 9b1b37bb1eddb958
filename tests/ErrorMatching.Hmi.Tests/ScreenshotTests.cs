using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Every screen in both themes, both languages and two sizes:
/// looked at by measure here, and by people in artifacts/screenshots.</summary>
[Trait("Length", "Long")]
public sealed class ScreenshotTests
{
    private static readonly string[] Sides = ["points", "counterpart", "features", "program", "gap", "decisions", "course"];

    [Fact]
    public Task No_text_is_cut_off_and_nothing_lies_over_anything_else() => Seat.AtAsync(seat =>
    {
        var pictures = new Pictures(seat);
        seat.Cell.Run();
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(1, CorrectionState.Proposed);
        new CorrectionDecisions(seat.Station.Store).Approve(1, DemoCell.Setter, null);
        seat.WaitFor(1, CorrectionState.Verified);
        seat.Cell.Deliver(2, 0.02);
        seat.WaitFor(2, CorrectionState.Proposed);
        seat.WaitFor(() => seat.Shell.Banner is null && seat.Station.State.Status?.Proposed.Count == 1, "The cell is not seen to run.");
        pictures.Take("login");
        seat.User.Tap(seat.See("login-password"));
        seat.See("key-a");
        pictures.Take("keyboard", isMeasured: false);
        seat.Tap("key-close");
        seat.SignIn(DemoCell.Setter);
        pictures.Take("overview");

        seat.Shell.Go(ScreenKeys.Compensation);
        seat.See("pair");
        pictures.Take("compensation");
        foreach (var side in Sides)
        {
            seat.Tap("tab-" + side);
            pictures.Take("compensation-" + side, isPictured: side == "program");
        }

        seat.Tap("approve");
        pictures.Take("signing");
        seat.Tap("signing-leave");

        seat.Shell.Look(1);
        seat.WaitFor(() => seat.TextOf("detail-state") == "At the machine", "What is at the machine is not shown.");
        pictures.Take("compensation-at-machine", isPictured: false);
        seat.Shell.Go(ScreenKeys.History);
        seat.See("found-1");
        pictures.Take("history");
        seat.Tap("found-1").See("detail-title");
        pictures.Take("history-opened", isPictured: false);
        seat.Shell.Go(ScreenKeys.Messages);
        seat.WaitFor(() => ((MessagesViewModel)seat.Shell.Current!).Entries.Count > 0, "The trail stays empty.");
        pictures.Take("messages");
        seat.Tap("tab-trail").Tap("audit-verify");
        seat.WaitFor(() => seat.Find("audit-finding") is { IsEffectivelyVisible: true }, "The trail is not verified.");
        pictures.Take("messages-trail");

        new CorrectionDecisions(seat.Station.Store).Reject(2, DemoCell.Setter, "A chip lay under the stylus.");
        seat.Shell.Go(ScreenKeys.Overview);
        seat.WaitFor(() => seat.TextOf("overview-summary") == "All is well", "Something still waits.");
        pictures.Take("overview-quiet", isPictured: false);
        pictures.MustBeClean();
    });
}
