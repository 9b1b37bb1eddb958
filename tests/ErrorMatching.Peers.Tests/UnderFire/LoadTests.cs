using System.Diagnostics;
using System.Globalization;
using ErrorMatching.Cell;
using ErrorMatching.EndToEnd.Tests;

namespace ErrorMatching.Peers.Tests;

/// <summary>Ten pieces a second through a real FTP server. What it took is printed, not judged: <c>tests/fire load 60</c> gives the figures of the README.</summary>
public sealed class LoadTests
{
    private const int PiecesPerSecond = 10;
    private static readonly int Seconds = int.Parse(Environment.GetEnvironmentVariable("ERRORMATCH_LOAD") ?? "5", CultureInfo.InvariantCulture);

    [Fact]
    public async Task Ten_pieces_a_second_reach_an_FTP_server()
    {
        FtpPeer.IsNeeded();
        var token = TestContext.Current.CancellationToken;
        using var ftp = new FtpPeer(FtpTls.None);
        using var cell = await FtpCell.Of(ftp, slots: 30);
        var files = new FireFiles();
        var pieces = Enumerable.Range(0, Seconds * PiecesPerSecond).Select(i => files.Next(cell.Slots[i % cell.Slots.Count], i)).ToArray();
        await using var machine = new FireMachine(cell, () => files.FileByProgram);
        var process = cell.Start();
        await Task.Delay(3000, token);
        var (dropped, memory) = (new Dictionary<string, DateTimeOffset>(StringComparer.Ordinal), new List<long>());
        var (clock, before) = (Stopwatch.StartNew(), process.TotalProcessorTime);
        for (var i = 0; i < pieces.Length; i++)
        {
            var ahead = TimeSpan.FromSeconds((double)i / PiecesPerSecond) - clock.Elapsed;
            if (ahead > TimeSpan.Zero)
            {
                await Task.Delay(ahead, token);
            }

            cell.Drop(pieces[i].Name, pieces[i].Bytes);
            dropped[pieces[i].Name] = TimeProvider.System.GetUtcNow();
            if (i % PiecesPerSecond == 0)
            {
                process.Refresh();
                memory.Add(process.WorkingSet64);
            }
        }

        await cell.Until(() => Task.FromResult(machine.Cut.Count >= pieces.Length), TimeSpan.FromSeconds(60), "all cut");
        var took = clock.Elapsed;
        process.Refresh();
        var processor = process.TotalProcessorTime - before;
        await Task.Delay(1500, token);
        await cell.Stop();

        Assert.Empty(machine.Wrong);
        Assert.Equal(pieces.Select(p => p.Name).Order(StringComparer.Ordinal), machine.Cut.Select(c => c.File).Order(StringComparer.Ordinal));
        using var store = CellStore.Open(new SqliteSettings(cell["store", "cell.db"]), TimeProvider.System);
        var latencies = store.InState(Enum.GetValues<CorrectionState>())
            .Select(c => (store.StepsOf(c.Id).First(s => s.To == CorrectionState.Verified).At - dropped[c.FileName]).TotalMilliseconds).Order().ToArray();
        Assert.Equal(pieces.Length, latencies.Length);
        Assert.Null(store.VerifyAudit());
        TestContext.Current.TestOutputHelper!.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"{pieces.Length} pieces in {took.TotalSeconds:0.0} s, file to verified: median {latencies[latencies.Length / 2]:0} ms, 99 % {latencies[latencies.Length * 99 / 100]:0} ms, worst {latencies[^1]:0} ms; processor time {processor.TotalSeconds / took.TotalSeconds:0.00} s a second; memory {string.Join(" ", memory.Where((_, i) => i % Math.Max(1, memory.Count / 10) == 0).Select(m => m >> 20))} MiB"));
    }
}
