using Serilog.Core;

namespace ErrorMatching.Cell.Tests;

public sealed class HeartbeatTests
{
    [Theory]
    [InlineData(0, true)]
    [InlineData(14, true)]
    [InlineData(15, false)]
    [InlineData(-14, true)]
    [InlineData(-15, false)]
    [InlineData(-3600, false)]
    public void A_sign_of_life_is_fresh_for_15_s_and_one_from_the_future_is_none(int secondsAgo, bool isFresh)
    {
        var now = new DateTimeOffset(2026, 1, 2, 3, 4, 5, TimeSpan.Zero);
        Assert.Equal(isFresh, new Heartbeat(1, now.AddDays(-1), now.AddSeconds(-secondsAgo), []).IsFresh(now));
    }

    [Fact]
    public async Task What_cannot_be_kept_is_a_trouble_until_it_can_and_the_heart_beats_on()
    {
        await using var cell = new RunningCell();
        AuditKey.Open(cell.PathOf("keys"));
        File.WriteAllText(cell.PathOf("logs"), "A file in the folder's place.");
        File.WriteAllText(cell.PathOf("keys/audit.seen"), "nothing that the cell wrote");
        var clock = new ManualClock();
        var beats = 0;
        var flow = new CellFlow(cell.Settings, cell.Store, clock, Logger.None, new FlowPace(), CancellationToken.None);
        var worker = new HeartbeatWorker(flow, () => beats++);
        clock.Advance(TimeSpan.FromSeconds(31));
        Assert.Equal(flow.Pace.Heartbeat, await worker.WorkAsync(TestContext.Current.CancellationToken));
        Assert.Equal([("end of the audit trail", "not-kept"), ("signs of life", "not-kept")], flow.Troubles.Open.Select(t => (t.Where, t.Code)));

        File.Delete(cell.PathOf("logs"));
        File.Delete(cell.PathOf("keys/audit.seen"));
        clock.Advance(TimeSpan.FromSeconds(31));
        await worker.WorkAsync(TestContext.Current.CancellationToken);
        Assert.Empty(flow.Troubles.Open);
        Assert.Equal(2, beats);
        Assert.Equal(clock.GetUtcNow(), Heartbeat.Read(cell.PathOf("logs"))!.At);
    }
}
