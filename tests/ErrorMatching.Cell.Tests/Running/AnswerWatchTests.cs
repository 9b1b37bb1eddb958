namespace ErrorMatching.Cell.Tests;

/// <summary>A machine or a gauge that is gone is noticed although nothing is to be sent or taken.</summary>
public sealed class AnswerWatchTests
{
    private static readonly TimeSpan Often = TimeSpan.FromMilliseconds(50);

    [Theory]
    [InlineData(TransportError.Away, "machine-away")]
    [InlineData(TransportError.Login, "machine-login")]
    public async Task A_machine_that_is_gone_is_told_and_recorded_once_and_so_is_its_return(TransportError error, string code)
    {
        await using var cell = new RunningCell();
        cell.Pace = cell.Pace with { Answer = Often, Held = Often };
        cell.Machine["m2"].Fails = error;
        cell.Start();
        await UntilTrouble(cell, "machine m2", code);
        await cell.UntilLookedAgain("watch of m2", "watch of m2");
        Assert.Equal(["no-answer"], Recorded(cell, "m2"));
        Assert.False(CellStatus.Of(cell.Settings, cell.Store, TimeProvider.System).IsHealthy);

        cell.Machine["m2"].Fails = null;
        await RunningCell.Until(() => CellStatus.Of(cell.Settings, cell.Store, TimeProvider.System).IsHealthy);
        Assert.Equal(["no-answer", "answers-again"], Recorded(cell, "m2"));
        Assert.Empty(Recorded(cell, "m1"));
    }

    [Fact]
    public async Task A_gauge_that_is_gone_or_in_whose_place_a_link_lies_is_recorded_once_and_so_is_its_return()
    {
        await using var cell = new RunningCell();
        cell.Pace = cell.Pace with { Answer = Often };
        cell.Start();
        await cell.UntilLookedAgain("watch of gauge cmm");
        Directory.Move(cell.PathOf("incoming"), cell.PathOf("elsewhere"));
        await UntilTrouble(cell, "gauge cmm", "gauge-away");
        await RunningCell.Until(() => Recorded(cell, "cmm").Count == 1);
        Directory.Move(cell.PathOf("elsewhere"), cell.PathOf("incoming"));
        await RunningCell.Until(() => CellStatus.Of(cell.Settings, cell.Store, TimeProvider.System).IsHealthy
            && Recorded(cell, "cmm").Count == 2);
        Directory.CreateDirectory(cell.PathOf("elsewhere"));
        Directory.CreateSymbolicLink(cell.PathOf("incoming/.errormatch"), cell.PathOf("elsewhere"));
        await RunningCell.Until(() => Recorded(cell, "cmm").Count == 3);
        Assert.Equal(["no-answer", "answers-again", "no-answer"], Recorded(cell, "cmm"));
        await RunningCell.Until(() => !CellStatus.Of(cell.Settings, cell.Store, TimeProvider.System).IsHealthy);
    }

    private static Task UntilTrouble(RunningCell cell, string where, string code) => RunningCell.Until(() =>
        CellStatus.Of(cell.Settings, cell.Store, TimeProvider.System).Heartbeat?.Troubles.Any(t => t.Where == where
            && t.Code == code) == true);

    private static IReadOnlyList<string> Recorded(RunningCell cell, string subject) =>
        [.. cell.Store.AuditEntries(0, 1000).Where(e => e.Subject == subject).Select(e => e.What)];
}
