using Avalonia.Controls;
using Avalonia.VisualTree;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

/// <summary>Nobody overtakes in the line for a slot: whoever approves a part sees behind whom it waits,
/// wherever they look for it.</summary>
[Trait("Length", "Long")]
public sealed class WaitingInLineTests
{
    private const string Behind = "Waits in line behind #1, #2: decide on these first.";

    [Fact]
    public Task What_waits_behind_others_says_so_before_and_after_it_is_approved_and_leads_to_the_first_of_them() => Seat.AtAsync(seat =>
    {
        Arrive(seat, 3);
        seat.SignIn(DemoCell.Setter).Tap("nav-compensation").See("pair");
        Assert.Null(seat.Find("compensation-waits"));
        seat.Tap("correction-3").WaitFor(() => seat.TextOf("detail-title") == "#3 · 0003", "It is not shown.").See("compensation-waits");
        Assert.Equal(Behind, ((CompensationViewModel)seat.Shell.Current!).Waits);
        seat.Tap("approve").See("signing-facts");
        Assert.Equal(new Fact(Behind, Severity.Attention), seat.Shell.Signing!.Facts[0]);
        Assert.Equal("It is sent when those ahead of it are decided and the slot is free.", seat.TextOf("signing-consequence"));
        seat.Type("signing-password", DemoCell.Password).Tap("signing-confirm");
        seat.WaitFor(() => seat.TextOf("detail-title") == "#1 · 0001", "The next one does not open.").Tap("correction-3");
        seat.WaitFor(() => seat.TextOf("detail-state") == "Approved", "It is not approved.").See("compensation-waits");
        BothLanguages.Take(seat, "compensation-waits");
        Assert.Equal(Severity.Attention, ((CompensationViewModel)seat.Shell.Current!).Chosen!.Severity);
        seat.Tap("compensation-waits").WaitFor(() => seat.TextOf("detail-title") == "#1 · 0001", "The tap does not lead to the first.");
        Assert.Null(seat.Find("compensation-waits"));

        // What is the first goes as soon as it can.
        seat.Tap("approve").See("signing-facts");
        Assert.Equal("The program goes to its machine as soon as the slot is free.", seat.TextOf("signing-consequence"));
        seat.Tap("signing-leave");

        // What stands before it is decided about at a console, while it is looked at.
        seat.Tap("correction-3").WaitFor(() => seat.TextOf("detail-title") == "#3 · 0003", "It is not shown.");
        new CorrectionDecisions(seat.Station.Store).Reject(1, DemoCell.Operator, "chip under the probe");
        seat.WaitFor(
            () => ((CompensationViewModel)seat.Shell.Current!).Waits == "Waits in line behind #2: decide on it first.",
            "The line is not followed.");
        new CorrectionDecisions(seat.Station.Store).Approve(2, DemoCell.Setter, null);
        seat.WaitFor(
            () => (
                (CompensationViewModel)seat.Shell.Current!)
                is { Waits: "Waits for its slot, now used by #2.", WaitsSeverity: Severity.Quiet },
            "It is not said who has the slot.");
    });

    [Fact]
    public Task The_overview_and_the_messages_say_what_holds_a_machine_up_and_lead_there() => Seat.AtAsync(seat =>
    {
        Arrive(seat, 3);
        new CorrectionDecisions(seat.Station.Store).Approve(3, DemoCell.Setter, null);
        seat.SignIn(DemoCell.Setter).See("waiting-3");
        var overview = (OverviewViewModel)seat.Shell.Current!;
        seat.WaitFor(() => overview.Slots[0].State == "Held up", "The machine is not said to be held up.");
        Assert.Equal(
            (Severity.Attention, "#3 · 0003 is approved but waits for a decision on #1 · 0001. Tap to go there."),
            (overview.Slots[0].Severity, overview.Slots[0].Detail));
        var tile = overview.Waiting.Single(t => t.Id == 3);
        Assert.Equal((Severity.Attention, "Approved · " + Behind), (tile.Severity, tile.State));
        BothLanguages.Take(seat, "overview-held-up");
        seat.Tap("slot-vmc1/A").WaitFor(
            () => seat.Find("detail-title") is not null && seat.TextOf("detail-title") == "#1 · 0001",
            "The machine does not lead to what holds it up.");
        seat.Tap("nav-messages").See("message-held-up-3");
        Assert.Contains(
            "#3 · 0003 is approved but not sent: it waits in line for vmc1/A behind #1, #2.",
            seat.See("message-held-up-3").GetVisualDescendants().OfType<TextBlock>().Select(t => t.Text));
        BothLanguages.Take(seat, "messages-held-up");
        seat.Tap("message-held-up-3").WaitFor(
            () => seat.Find("detail-title") is not null && seat.TextOf("detail-title") == "#1 · 0001",
            "The message does not lead to what holds it up.");
    });

    [Fact]
    public Task What_is_approved_behind_a_piece_at_the_machine_waits_for_its_slot_and_for_nobody() => Seat.AtAsync(seat =>
    {
        Arrive(seat, 2);
        foreach (var id in new[] { 1, 2 })
        {
            new CorrectionDecisions(seat.Station.Store).Approve(id, DemoCell.Setter, null);
        }

        seat.WaitFor(1, CorrectionState.Verified);
        seat.SignIn(DemoCell.Operator).See("waiting-2");
        var overview = (OverviewViewModel)seat.Shell.Current!;
        seat.WaitFor(
            () => overview.Waiting is [{ Id: 2, Severity: Severity.Quiet, State: "Approved · Waits for its slot, now used by #1." }],
            "It is not said what it waits for.");
        seat.WaitFor(() => overview.Slots[0] is { State: "At the machine", Severity: Severity.Quiet }, "Its slot is not told.");
        seat.Cell.FinishPiece();
        seat.WaitFor(
            () => overview.IsNothingWaiting && overview.Slots[0].Detail.StartsWith("Complex mating · #2", StringComparison.Ordinal),
            "It stays in the list when it is sent.");
    });

    [Fact]
    public Task A_slot_whose_program_was_taken_back_says_what_it_holds_and_what_to_do() => Seat.AtAsync(async seat =>
    {
        Arrive(seat, 2);
        var decisions = new CorrectionDecisions(seat.Station.Store);
        decisions.Approve(1, DemoCell.Setter, null);
        seat.WaitFor(1, CorrectionState.Verified);
        decisions.Release(1, DemoCell.Setter, null);
        decisions.Approve(2, DemoCell.Setter, null);
        seat.WaitFor(2, CorrectionState.Verified);
        await new SlotReversal(
            seat.Station.Settings,
            seat.Station.Store,
            seat.Station.Open,
            TimeProvider.System).RevertAsync(2, DemoCell.Setter, "chatter", TestContext.Current.CancellationToken);
        seat.SignIn(DemoCell.Operator);
        var overview = (OverviewViewModel)seat.Shell.Current!;
        seat.WaitFor(() => overview.Slots is [{ State: "Reverted" }, ..], "The machine does not say that the program was taken back.");
        Assert.Equal(
            (Severity.Attention, "The program before #2 · 0002 is back at the machine. Release the slot when it can be used again."),
            (overview.Slots[0].Severity, overview.Slots[0].Detail));
        Assert.Equal("Machines waiting for someone: 1", overview.Summary);
        BothLanguages.Take(seat, "overview-taken-back");
        seat.Tap("slot-vmc1/A").See("release");
        Assert.Equal(Severity.Attention, ((CompensationViewModel)seat.Shell.Current!).Rows.Single(r => r.Id == 2).Severity);
        seat.Tap("nav-messages").See("message-2");
        Assert.Equal(
            (
                "vmc1/A is occupied by #2 · 0002, whose program was withdrawn: the previous one is at the machine.",
                "Release the slot when it can be used again."),
            ((MessagesViewModel)seat.Shell.Current!).Messages.Select(m => (m.What, m.Next)).Single());
        decisions.Release(2, DemoCell.Operator, null);
        seat.Tap("nav-overview").WaitFor(
            () => ((OverviewViewModel)seat.Shell.Current!).Slots[0] is { State: "Free", Detail: "The slot is free for the next program." },
            "The slot is not free.");
    });

    private static void Arrive(Seat seat, int parts)
    {
        seat.RunCell();
        for (var serial = 1; serial <= parts; serial++)
        {
            seat.Cell.Deliver(serial, 0.003);
            seat.WaitFor(serial, CorrectionState.Proposed);
        }

        seat.WaitFor(() => seat.Station.State.Status?.Proposed.Count == parts, "What arrived is not seen.");
    }
}
