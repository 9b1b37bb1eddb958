using ErrorMatching.Cell;
using ErrorMatching.Cell.Tests;

namespace ErrorMatching.Peers.Tests;

/// <summary>The process ends on the way from the log on the control to the finishing program there. The next one goes on, and the end is
/// the same: one correction, one program, the log removed.</summary>
public sealed class ProbedPieceRestartTests
{
    [Theory]
    [InlineData("read PROBE.LOG", true)]
    [InlineData("Archived", false)]
    [InlineData("Archived", true)]
    [InlineData("rename PROBE.LOG.taken", true)]
    [InlineData("delete PROBE.LOG.taken", false)]
    [InlineData("Recognized", true)]
    [InlineData("Computed", true)]
    [InlineData("Approved", true)]
    [InlineData("Uploading", true)]
    [InlineData("write", true)]
    [InlineData("replace FINISH.MPF", true)]
    public async Task Wherever_the_process_ends_the_next_one_comes_to_the_same_end(string at, bool isDone)
    {
        await using var cell = await ProbedCell.OfFolderAsync(keeps: false);
        await EndAndGoOnAsync(cell, cell.PathOf("machine"), at, isDone);
    }

    [Theory]
    [InlineData("read PROBE.LOG", true)]
    [InlineData("rename PROBE.LOG.taken", true)]
    [InlineData("write", true)]
    public async Task So_it_is_behind_an_FTP_server(string at, bool isDone)
    {
        FtpPeer.IsNeeded();
        using var peer = new FtpPeer(FtpTls.None);
        await using var cell = await ProbedCell.OfAsync(peer, keeps: false);
        await EndAndGoOnAsync(cell, peer.Folder, at, isDone);
    }

    [Theory]
    [InlineData("read PROBE.LOG", true)]
    [InlineData("rename PROBE.LOG.taken", true)]
    [InlineData("write", true)]
    public async Task So_it_is_behind_an_SSH_server(string at, bool isDone)
    {
        SshPeer.IsNeeded();
        using var peer = new SshPeer();
        await using var cell = await ProbedCell.OfAsync(peer, keeps: false);
        await EndAndGoOnAsync(cell, peer.Folder, at, isDone);
    }

    private static async Task EndAndGoOnAsync(ConfiguredCell cell, string machine, string at, bool isDone)
    {
        var isDead = 0;
        void Tick(string what, bool done)
        {
            if (Volatile.Read(ref isDead) == 1 || (what == at && done == isDone && Interlocked.Exchange(ref isDead, 1) == 0))
            {
                throw new OperationCanceledException("The process is gone.");
            }
        }

        var opens = cell.Opens;
        cell.AroundStep = (state, done) => Tick(state.ToString(), done);
        cell.Opens = m => new WatchedFolder(opens(m), Tick);
        var log = Path.Combine(machine, ProbedCell.Log);
        File.WriteAllText(log, await ProbedPiece.LogAsync());
        cell.Start();
        await ConfiguredCell.Until(() => Volatile.Read(ref isDead) == 1);
        await cell.BuryAsync();

        (cell.AroundStep, cell.Opens) = (null, opens);
        cell.Start();
        await ProbedCell.FinishedAsync(cell, machine);
        await ConfiguredCell.Until(() => Directory.GetFiles(machine).Length == 1);
        await cell.StopAsync();
        Assert.Null(cell.Store.Find(2));
        Assert.Single(cell.Store.Corrections.StepsOf(1), s => s.To == CorrectionState.Verified);
    }
}
