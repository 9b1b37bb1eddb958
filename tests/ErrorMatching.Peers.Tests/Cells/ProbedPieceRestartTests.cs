using ErrorMatching.Cell;
using ErrorMatching.Cell.Tests;

namespace ErrorMatching.Peers.Tests;

/// <summary>The process ends on the way from the log on the control to the finishing program there. The next one goes on, and the end is the same: one correction, one program, the log removed.</summary>
public sealed class ProbedPieceRestartTests
{
    [Theory]
    [InlineData("list", true)]
    [InlineData("read PROBE.LOG", true)]
    [InlineData("Archived", false)]
    [InlineData("Archived", true)]
    [InlineData("rename PROBE.LOG.taken", true)]
    [InlineData("delete PROBE.LOG.taken", false)]
    [InlineData("delete PROBE.LOG.taken", true)]
    [InlineData("Recognized", true)]
    [InlineData("Computed", false)]
    [InlineData("Computed", true)]
    [InlineData("Proposed", true)]
    [InlineData("Approved", true)]
    [InlineData("Uploading", true)]
    [InlineData("write", true)]
    [InlineData("rename FINISH.MPF", true)]
    public async Task Wherever_the_process_ends_the_next_one_comes_to_the_same_end(string at, bool isDone)
    {
        await using var cell = await ProbedCell.OfFolderAsync(keeps: false);
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
        var log = Path.Combine(cell.PathOf("machine"), ProbedCell.Log);
        File.WriteAllText(log, await ProbedPiece.LogAsync());
        cell.Start();
        await ConfiguredCell.Until(() => Volatile.Read(ref isDead) == 1);
        await cell.BuryAsync();

        (cell.AroundStep, cell.Opens) = (null, opens);
        cell.Start();
        await ProbedCell.FinishedAsync(cell, cell.PathOf("machine"));
        await ConfiguredCell.Until(() => Directory.GetFiles(cell.PathOf("machine")).Length == 1);
        await cell.StopAsync();
        Assert.Null(cell.Store.Find(2));
        Assert.Single(cell.Store.StepsOf(1), s => s.To == CorrectionState.Verified);
    }
}
