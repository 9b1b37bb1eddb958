using System.Text;
using ErrorMatching.Testing;
using Serilog.Core;

namespace ErrorMatching.Cell.Tests;

public sealed class HeartbeatTests : IDisposable
{
    private static readonly DateTimeOffset Now = new(2026, 11, 21, 22, 0, 0, TimeSpan.Zero);
    private readonly TemporaryFolder _folder = new();

    [Fact]
    public void What_one_process_leaves_another_one_reads()
    {
        var sign = new Heartbeat(17, Now.AddHours(-1), Now, [new("slot vmc/A", "machine-away", "no answer \u202E", Now.AddMinutes(-5))]);
        sign.Write(_folder.Path);
        var read = Heartbeat.Read(_folder.Path)!;
        Assert.Equal((17, sign.Since, sign.At, sign.Troubles[0]), (read.ProcessId, read.Since, read.At, Assert.Single(read.Troubles)));
        Assert.Equal([_folder["running.json"]], Directory.EnumerateFiles(_folder.Path));
    }

    [Theory]
    [InlineData(14.9, true)]
    [InlineData(15.1, false)]
    [InlineData(-14.9, true)]
    [InlineData(-15.1, false)]
    public void It_is_fresh_for_15_seconds_and_one_from_the_future_is_not(double age, bool isFresh) =>
        Assert.Equal(isFresh, new Heartbeat(17, Now, Now, []).IsFresh(Now.AddSeconds(age)));

    [Theory]
    [InlineData("")]
    [InlineData("{")]
    [InlineData("null")]
    [InlineData("[]")]
    [InlineData("{\"ProcessId\":1,\"Since\":\"yesterday\"}")]
    [InlineData("{\"ProcessId\":1,\"Since\":\"2026-11-21T22:00:00Z\",\"At\":\"2026-11-21T22:00:00Z\"}")]
    [InlineData("{\"ProcessId\":1,\"Since\":\"2026-11-21T22:00:00Z\",\"At\":\"2026-11-21T22:00:00Z\",\"Troubles\":null}")]
    public void What_is_no_sign_of_life_is_none(string text)
    {
        File.WriteAllBytes(_folder["running.json"], Encoding.UTF8.GetBytes(text));
        Assert.Null(Heartbeat.Read(_folder.Path));
    }

    [Fact]
    public async Task What_cannot_be_kept_is_a_trouble_until_it_can_and_the_heart_beats_on()
    {
        await using var cell = new RunningCell();
        File.WriteAllText(cell.PathOf("logs"), "A file in the folder's place.");
        var clock = new ManualClock();
        var beats = 0;
        var flow = new CellFlow(cell.Settings, cell.Store, clock, Logger.None, new FlowPace(), CancellationToken.None);
        var worker = new HeartbeatWorker(flow, () => beats++);
        Assert.Equal(flow.Pace.Heartbeat, await worker.WorkAsync(TestContext.Current.CancellationToken));
        Assert.Equal([("signs of life", "not-kept")], flow.Troubles.Open.Select(t => (t.Where, t.Code)));

        File.Delete(cell.PathOf("logs"));
        await worker.WorkAsync(TestContext.Current.CancellationToken);
        Assert.Empty(flow.Troubles.Open);
        Assert.Equal(2, beats);
        Assert.Equal(clock.GetUtcNow(), Heartbeat.Read(cell.PathOf("logs"))!.At);
    }

    public void Dispose() => _folder.Dispose();
}
