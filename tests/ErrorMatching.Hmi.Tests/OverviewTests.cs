using ErrorMatching.Cell;

namespace ErrorMatching.Hmi.Tests;

public sealed class OverviewTests
{
    [Fact]
    public Task A_cell_that_does_not_run_is_said_with_what_still_works() => Seat.AtAsync(seat =>
    {
        seat.SignIn(DemoCell.Operator);
        Assert.StartsWith("The cell is not running: no file is taken", seat.TextOf("banner"), StringComparison.Ordinal);
        Assert.Equal("The cell is not running", seat.TextOf("overview-summary"));
    });

    [Fact]
    public Task A_cell_with_nothing_to_do_is_quiet() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.SignIn(DemoCell.Operator).WaitFor(() => seat.TextOf("overview-summary") == "All is well", "All is not well.");
        Assert.Null(seat.Find("banner"));
        Assert.NotNull(seat.Find("slot-vmc1/A"));
        Assert.NotNull(seat.Find("gauge-cmm"));
    });

    [Fact]
    public Task A_measured_part_appears_by_itself() => Seat.AtAsync(seat =>
    {
        seat.Cell.Run();
        seat.SignIn(DemoCell.Operator);
        seat.Cell.Deliver(1, 0);
        seat.WaitFor(() => seat.TextOf("overview-summary") == "Waiting for an approval: 1", "Nothing waits for an approval.");
        var tile = ((OverviewViewModel)seat.Shell.Current!).Waiting.Single();
        var kept = seat.Station.Store.Find(1)!;
        Assert.Equal(CorrectionState.Proposed, kept.State);
        Assert.Equal("#1 · 0001", tile.Title);
        Assert.Equal(Shown.Mm(kept.LargestMm) + " mm", tile.Largest);
        Assert.Equal(Severity.Attention, tile.Severity);
    });
}
