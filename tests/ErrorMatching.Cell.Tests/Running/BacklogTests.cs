using Serilog.Core;

namespace ErrorMatching.Cell.Tests;

/// <summary>What waits at a gauge is counted and shown, and too much of it is a trouble.</summary>
public sealed class BacklogTests
{
    private static readonly TimeSpan Third = TimeSpan.FromSeconds(20);
    private readonly ManualClock _clock = new();

    [Theory]
    [InlineData(true, 10, 20, 30, 40)]
    [InlineData(true, 0, 4, 7, 10)]
    [InlineData(false, 0, 4, 7, 9)]
    [InlineData(false, 0, 0, 1000, 990)]
    [InlineData(false, 0, 1000, 995, 990)]
    [InlineData(false, 1000, 995, 990, 985)]
    [InlineData(false, 100, 100, 100, 100)]
    [InlineData(false, 10, 20, 20, 40)]
    public void A_number_grows_if_it_does_so_for_a_whole_minute(bool isGrowing, params int[] counts)
    {
        var growth = new Growth(Third);

        var said = counts.Select((c, i) => growth.Add(i * Third, c)).ToArray();

        Assert.Equal([false, false, false, isGrowing], said);
    }

    [Fact]
    public void A_growth_is_noticed_until_the_number_is_smaller_than_then()
    {
        var growth = new Growth(Third);
        foreach (var i in Enumerable.Range(1, 3)) Assert.False(growth.Add(i * Third, 10 * i));

        // What comes within the same third is one sample.
        Assert.False(growth.Add((3 * Third) + TimeSpan.FromSeconds(19), 100));
        Assert.True(growth.Add(4 * Third, 40));
        Assert.True(growth.Add(5 * Third, 60));
        Assert.True(growth.Add(6 * Third, 40));
        Assert.False(growth.Add(7 * Third, 39));
    }

    [Fact]
    public async Task Files_of_the_gauge_count_and_wait_from_when_they_were_seen()
    {
        await using var cell = new RunningCell();
        var files = new WaitingFiles(cell.Settings.Gauges[0], _clock);
        Old("a_1.csv", -30);
        Assert.Equal((1, _clock.GetUtcNow().AddMinutes(-30)), files.Count());
        _clock.Advance(TimeSpan.FromMinutes(1));

        // A copy bears the time of its original, and some programs write hidden files.
        Old("a_2.csv", -500);
        Old("other.txt", -500);
        Old(".a_3.csv", -500);
        Assert.Equal((2, _clock.GetUtcNow().AddMinutes(-31)), files.Count());
        File.Delete(cell.PathOf("incoming/a_1.csv"));
        Assert.Equal((1, _clock.GetUtcNow()), files.Count());
        Directory.CreateDirectory(cell.PathOf("incoming/.errormatch"));
        File.Move(cell.PathOf("incoming/a_2.csv"), cell.PathOf("incoming/.errormatch/a_2.csv"));
        _clock.Advance(TimeSpan.FromMinutes(1));
        Assert.Equal((1, _clock.GetUtcNow().AddMinutes(-1)), files.Count());
        File.Delete(cell.PathOf("incoming/.errormatch/a_2.csv"));
        Assert.Equal((0, null), files.Count());

        void Old(string name, int minutes)
        {
            cell.DropText("../" + name, "");
            File.SetLastWriteTimeUtc(cell.PathOf(name), _clock.GetUtcNow().AddMinutes(minutes).UtcDateTime);
            File.Move(cell.PathOf(name), cell.PathOf("incoming/" + name));
        }
    }

    [Fact]
    public async Task A_piece_that_waits_too_long_is_a_trouble_and_the_status_has_number_and_age()
    {
        await using var cell = new RunningCell();
        var (flow, worker) = Begin(cell);
        cell.Drop("a_1.csv", 1);
        await worker.WorkAsync(CancellationToken.None);
        Assert.Empty(flow.Troubles.Open);
        _clock.Advance(TimeSpan.FromMinutes(9.9));
        await worker.WorkAsync(CancellationToken.None);
        Assert.Empty(flow.Troubles.Open);

        _clock.Advance(TimeSpan.FromMinutes(0.2));
        await worker.WorkAsync(CancellationToken.None);

        var trouble = Assert.Single(flow.Troubles.Open);
        Assert.Equal(("backlog cmm", "piece-waits"), (trouble.Where, trouble.Code));
        Assert.Contains(", 10, cmm, 1, ", Stated.As(trouble.Statement), StringComparison.Ordinal);
        await new HeartbeatWorker(flow, null).WorkAsync(CancellationToken.None);
        var status = CellStatus.Of(cell.Settings, cell.Store, _clock);
        Assert.False(status.IsHealthy);
        var backlog = Assert.Single(status.Backlog);
        Assert.Equal(("cmm", 1, 0L), (backlog.Gauge, backlog.Files, backlog.Pieces));
        Assert.Equal(TimeSpan.FromMinutes(10.1), _clock.GetUtcNow() - backlog.Since!.Value);

        File.Delete(cell.PathOf("incoming/a_1.csv"));
        await worker.WorkAsync(CancellationToken.None);
        Assert.Empty(flow.Troubles.Open);
    }

    [Fact]
    public async Task What_is_stored_and_not_computed_waits_too()
    {
        await using var cell = new RunningCell();
        var (flow, worker) = Begin(cell);
        cell.Store.Archive(new("cmm", "a_1.csv", "key", "1"u8.ToArray()));
        cell.Store.Archive(new("of another cell", "a_1.csv", "another key", "1"u8.ToArray()));
        _clock.Set(DateTimeOffset.UtcNow.AddMinutes(11));

        await worker.WorkAsync(CancellationToken.None);

        var backlog = Assert.Single(flow.Backlogs.All);
        Assert.Equal(("cmm", 0, 1L), (backlog.Gauge, backlog.Files, backlog.Pieces));
        Assert.Equal("piece-waits", Assert.Single(flow.Troubles.Open).Code);
        Assert.Equal(backlog, Assert.Single(GaugeBacklog.Of(cell.Settings, cell.Store, _clock)));
    }

    [Fact]
    public async Task A_backlog_that_grows_for_a_minute_is_a_trouble()
    {
        await using var cell = new RunningCell();
        var (flow, worker) = Begin(cell);
        for (var third = 0; third < 4; third++)
        {
            Assert.Empty(flow.Troubles.Open);
            for (var i = 0; i < 4; i++) cell.DropText(FormattableString.Invariant($"a_{third}{i}.csv"), "");
            await worker.WorkAsync(CancellationToken.None);
            _clock.Advance(Third);
        }

        var trouble = Assert.Single(flow.Troubles.Open);
        Assert.Equal(("backlog cmm", "backlog-grows"), (trouble.Where, trouble.Code));
        Assert.True(Assert.Single(flow.Backlogs.All).IsGrowing);
    }

    private (CellFlow Flow, BacklogWorker Worker) Begin(RunningCell cell)
    {
        _clock.Set(DateTimeOffset.UtcNow);
        var flow = new CellFlow(cell.Settings, cell.Store, _clock, Logger.None, new(), CancellationToken.None);
        return (flow, new(flow, cell.Settings.Gauges[0]));
    }
}
