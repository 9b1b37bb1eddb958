using System.Diagnostics;
using System.Globalization;
using ErrorMatching.Cell;
using ErrorMatching.EndToEnd.Tests;

namespace ErrorMatching.Peers.Tests;

/// <summary>Ten pieces a second through a real FTP server: all of them arrive, each once.</summary>
/// <remarks>How fast they do, and in how much memory, is judged by <c>tests/fire load 60</c> alone, where the computer is the test's own;
/// it gives the figures of the README.</remarks>
public sealed class LoadTests
{
    private const int PiecesPerSecond = 10;
    private const double MedianMs = 300;
    private const double NinetyNineOfAHundredMs = 1000;

    // A second half that needs more than this much of the first keeps something of every piece.
    private const double FlatMemory = 1.15;

    private static readonly bool IsJudged = Environment.GetEnvironmentVariable("ERRORMATCH_LOAD") is not null;
    private static readonly int Seconds = int.Parse(
        Environment.GetEnvironmentVariable("ERRORMATCH_LOAD") ?? "2", CultureInfo.InvariantCulture);

    [Fact(Explicit = true)]
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
        await cell.HasBegun();
        await Task.Delay(IsJudged ? 3000 : 0, token);
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

        await cell.Until(() => Task.FromResult(machine.Cut.Count >= pieces.Length), TimeSpan.FromMinutes(5), "all cut");
        var took = clock.Elapsed;
        process.Refresh();
        var processor = process.TotalProcessorTime - before;
        await cell.Until(
            async () => (await cell.History()).Count(c => c.GetProperty("state").GetString() == "released") == pieces.Length,
            TimeSpan.FromMinutes(5),
            "all released");
        await cell.Stop();

        Assert.Empty(machine.Wrong);
        Assert.Equal(
            pieces.Select(p => p.Name).Order(StringComparer.Ordinal), machine.Cut.Select(c => c.File).Order(StringComparer.Ordinal));
        using var store = CellStore.Open(new SqliteSettings(cell["store", "cell.db"]), TimeProvider.System);
        var latencies = store.Corrections.InState(Enum.GetValues<CorrectionState>())
            .Select(
                c => (store.Corrections.StepsOf(c.Id).First(s => s.To == CorrectionState.Verified).At - dropped[c.FileName])
                    .TotalMilliseconds)
                .Order().ToArray();
        Assert.Equal(pieces.Length, latencies.Length);
        Assert.Null(store.VerifyAudit());
        var (median, most) = (latencies[latencies.Length / 2], latencies[latencies.Length * 99 / 100]);
        TestContext.Current.TestOutputHelper!.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"{pieces.Length} pieces in {took.TotalSeconds:0.0} s, file to verified: median {median:0} ms, 99 % {most:0} ms, worst "
                + $"{latencies[^1]:0} ms; processor time {processor.TotalSeconds / took.TotalSeconds:0.00} s a second; memory "
                + $"{string.Join(" ", memory.Where((_, i) => i % Math.Max(1, memory.Count / 10) == 0).Select(m => m >> 20))} MiB"));
        if (IsJudged)
        {
            // The first seconds load and compile what is needed.
            var settled = memory[(memory.Count / 6)..];
            var (early, late) = (settled.Take(settled.Count / 2).Average(), settled.Skip(settled.Count / 2).Average());
            Assert.True(median <= MedianMs, $"Half of the pieces took more than {median:0} ms.");
            Assert.True(most <= NinetyNineOfAHundredMs, $"One of 100 pieces took more than {most:0} ms.");
            Assert.True(late <= early * FlatMemory, $"Memory grows from {early / (1 << 20):0} to {late / (1 << 20):0} MiB.");
        }
    }
}
