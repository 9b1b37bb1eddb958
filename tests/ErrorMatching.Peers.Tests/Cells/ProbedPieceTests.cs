using ErrorMatching.Cell;
using ErrorMatching.Cell.Tests;

namespace ErrorMatching.Peers.Tests;

/// <summary>A running cell and a free-form job: from the probing log to the finishing program of the piece that waits on the machine. What
/// the console makes of the same log is what the machine must have, byte by byte.</summary>
public sealed class ProbedPieceTests
{
    [Fact]
    public async Task A_log_that_is_dropped_becomes_the_finishing_program()
    {
        await using var cell = await ProbedCell.OfFolderAsync(keeps: true);
        cell.Start();
        cell.Drop(ProbedCell.Log, await ProbedPiece.LogAsync());
        await ProbedCell.FinishedAsync(cell, cell.PathOf("machine"));
        Assert.Equal("dropped", cell.Store.Find(1)!.Gauge);
        Assert.Empty(Directory.EnumerateFiles(cell.PathOf("incoming")));

        // The same log again, by another way.
        File.WriteAllText(Path.Combine(cell.PathOf("machine"), ProbedCell.Log), await ProbedPiece.LogAsync());
        Assert.Equal("already-known", (await cell.Until(2, CorrectionState.Refused)).Code);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public async Task A_log_on_a_share_becomes_the_finishing_program_there(bool keeps)
    {
        await using var cell = await ProbedCell.OfFolderAsync(keeps);
        await WholeWayAsync(cell, cell.PathOf("machine"), keeps);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public async Task A_log_behind_an_FTP_server_becomes_the_finishing_program_there(bool keeps)
    {
        FtpPeer.IsNeeded();
        using var peer = new FtpPeer(FtpTls.None);
        await using var cell = await ProbedCell.OfAsync(peer, keeps);
        await WholeWayAsync(cell, peer.Folder, keeps);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public async Task A_log_behind_an_SSH_server_becomes_the_finishing_program_there(bool keeps)
    {
        SshPeer.IsNeeded();
        using var peer = new SshPeer();
        await using var cell = await ProbedCell.OfAsync(peer, keeps);
        await WholeWayAsync(cell, peer.Folder, keeps);
    }

    [Fact]
    public async Task A_log_that_grows_while_it_is_fetched_is_taken_when_it_is_whole()
    {
        await using var cell = await ProbedCell.OfFolderAsync(keeps: false);
        var (watched, opens) = (new List<WatchedFolder>(), cell.Opens);
        cell.Opens = m => Watch(watched, new(opens(m)));

        // The program's marker names the measurement by its bytes.
        var lines = (await ProbedPiece.LogAsync()).Split('\n').Select((l, i) => i == 0 ? l : "\n" + l).ToArray();
        var log = Path.Combine(cell.PathOf("machine"), ProbedCell.Log);
        cell.Start();
        foreach (var part in lines.Chunk(20))
        {
            Assert.Null(cell.Store.Find(1));
            await File.AppendAllTextAsync(log, string.Concat(part), TestContext.Current.CancellationToken);
            if (!part.Contains("\nEND"))
            {
                await LookedAsync(watched, 3);
            }
        }

        await ProbedCell.FinishedAsync(cell, cell.PathOf("machine"));
        Assert.Null(cell.Store.Find(2));
        Assert.False(File.Exists(log));
    }

    [Fact]
    public async Task The_log_of_another_piece_makes_no_program()
    {
        await using var cell = await ProbedCell.OfFolderAsync(keeps: true);
        cell.Configuration = cell.Configuration.Replace("\"jobs\": [{", """
            "jobs": [{ "name": "any", "job": "job/job.json", "gauges": ["dropped"], "machine": "mill", "slot": "A", "recognize": { "fileName": "^ANY" } }, {
            """, StringComparison.Ordinal);
        cell.Start();
        var other = await ProbedPiece.LogAsync(plan: "0123456789ABCDEF");
        File.WriteAllText(Path.Combine(cell.PathOf("machine"), ProbedCell.Log), other);
        Assert.Equal("unknown-piece", (await cell.Until(1, CorrectionState.Refused)).Code);

        // Where only the name says whose it is, the plan still does not fit.
        cell.Drop("ANY.LOG", other);
        Assert.Equal("other-plan", (await cell.Until(2, CorrectionState.Refused)).Code);
        Assert.Equal([ProbedCell.Log], Directory.EnumerateFiles(cell.PathOf("machine")).Select(f => Path.GetFileName(f)));
    }

    [Fact]
    public async Task A_log_cut_on_its_way_by_FTP_is_fetched_again()
    {
        FtpPeer.IsNeeded();
        using var peer = new FtpPeer(FtpTls.None);
        using var proxy = new FtpProxy(peer.Port);
        await using var cell = await ProbedCell.OfAsync(peer, keeps: false, proxy.Port);
        proxy.Arm(new() { CutReading = 1000 });
        await CutAsync(cell, peer.Folder, () => proxy.IsArmed);
    }

    [Fact]
    public async Task A_log_cut_on_its_way_by_SFTP_is_fetched_again()
    {
        SshPeer.IsNeeded();
        using var peer = new SshPeer();
        using var proxy = new CutProxy(peer.Port);
        await using var cell = await ProbedCell.OfAsync(peer, keeps: false, proxy.Port);

        // Connections that list pass less; the cell asks now and then whether the machine answers, so that no number says which one reads.
        proxy.Arm(new(CutKind.Cut, CutProxy.Any, IsUp: false, After: 6000));
        await CutAsync(cell, peer.Folder, () => proxy.IsArmed);
    }

    private static async Task CutAsync(ConfiguredCell cell, string machine, Func<bool> isArmed)
    {
        File.WriteAllText(Path.Combine(machine, ProbedCell.Log), await ProbedPiece.LogAsync());
        cell.Start();
        await ProbedCell.FinishedAsync(cell, machine);
        Assert.False(isArmed());
        Assert.Null(cell.Store.Find(2));
        await ConfiguredCell.Until(() => !File.Exists(Path.Combine(machine, ProbedCell.Log)));
    }

    private static async Task WholeWayAsync(ConfiguredCell cell, string machine, bool keeps)
    {
        var (watched, opens) = (new List<WatchedFolder>(), cell.Opens);
        cell.Opens = m => Watch(watched, new(opens(m)));
        var log = Path.Combine(machine, ProbedCell.Log);
        File.WriteAllText(log, await ProbedPiece.LogAsync());
        cell.Start();
        await ProbedCell.FinishedAsync(cell, machine);
        if (!keeps)
        {
            await ConfiguredCell.Until(() => !File.Exists(log));

            // The control writes the same again, which no probe ever does: somebody copied it back.
            File.WriteAllText(log, await ProbedPiece.LogAsync());
            await ConfiguredCell.Until(() => !File.Exists(log));
        }

        // What is known is not taken again, neither by this process nor by the next one.
        await LookedAsync(watched, 2);
        await cell.StopAsync();
        watched.Clear();
        cell.Start();
        await LookedAsync(watched, 2);
        Assert.Null(cell.Store.Find(2));
        Assert.Equal(keeps, File.Exists(log));
        Assert.Equal(
            keeps ? [ProbedCell.Program, ProbedCell.Log] : [ProbedCell.Program],
            Directory.EnumerateFiles(machine).Select(f => Path.GetFileName(f)).Order(StringComparer.Ordinal));

        // Another run of the probe makes another program, when the slot is free.
        var next = await ProbedPiece.LogAsync(zMm: 0.002);
        new CorrectionDecisions(cell.Store).Release(1, "olga", null);
        File.WriteAllText(log, next);
        await cell.Until(2, CorrectionState.Verified);
        Assert.Equal(await ProbedPiece.FinishAsync(next), File.ReadAllBytes(Path.Combine(machine, ProbedCell.Program)));
    }

    private static WatchedFolder Watch(List<WatchedFolder> all, WatchedFolder folder)
    {
        lock (all)
        {
            all.Add(folder);
        }

        return folder;
    }

    // Waits until the machine was listed so many times more to its end.
    private static async Task LookedAsync(List<WatchedFolder> all, int times)
    {
        int Lists()
        {
            lock (all)
            {
                return all.Sum(w => w.Done.Count(d => d == "list"));
            }
        }

        var before = Lists();
        await ConfiguredCell.Until(() => Lists() > before + times);
    }
}
