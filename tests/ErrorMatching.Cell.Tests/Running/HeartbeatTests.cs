using System.Text;
using ErrorMatching.Testing;

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

    public void Dispose() => _folder.Dispose();
}
