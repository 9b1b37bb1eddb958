using System.Text;

namespace ErrorMatching.Cell.Tests;

/// <summary>The program of a taken slot is read again: the piece is cut by what lies there, not by what was sent once.</summary>
public sealed class HeldProgramTests
{
    private const string Program = "P2.NC";
    private const string Ready = "B.READY";
    private static readonly byte[] Edited = Encoding.ASCII.GetBytes("N10 G0 X0 (edited at the machine)\n");

    [Fact]
    public async Task A_held_program_that_somebody_changed_is_found_at_the_start_and_told_once()
    {
        await using var cell = new RunningCell();
        var sent = await SendOne(cell);
        cell.Machine["m1"].Files[Program] = Edited;
        cell.Start();
        await UntilChanged(cell, isChanged: true);
        await cell.UntilLookedAgain("slot m1/B");
        var told = Assert.Single(cell.Store.AuditEntries(0, 1000), e => e.What == "changed-at-machine");
        Assert.Equal("slot B of m1", told.Subject!.Sentence);
        Assert.StartsWith("changed-while-held(P2.NC, m1, 1, ", Stated.As(told.Basis), StringComparison.Ordinal);

        // What was found is kept; the slot stays taken.
        Assert.Equal(Edited, cell.Store.Content(RunningCell.Hash(Edited)));
        Assert.Equal(1L, cell.Store.Slot("m1", "B").Correction);
        Assert.False(CellStatus.Of(cell.Settings, cell.Store, TimeProvider.System).IsHealthy);

        // A person decides.
        using var elsewhere = cell.Open();
        var release = new SlotRelease(cell.Settings, elsewhere, m => cell.Machine[m.Name]);
        var refused = await Assert.ThrowsAsync<DecisionException>(() =>
            release.ReleaseAsync(1, "olga", null, TestContext.Current.CancellationToken));
        Assert.Equal("changed-at-machine", refused.Code);
        Assert.Equal(CorrectionState.Verified, cell.Store.Find(1)!.State);
        await release.ReleaseAsync(1, "olga", "cut with the change, which sam made", TestContext.Current.CancellationToken);
        await UntilChanged(cell, isChanged: false);
        Assert.NotEqual(RunningCell.Hash(sent), RunningCell.Hash(cell.Machine["m1"].Files[Program]));
    }

    [Fact]
    public async Task A_ready_file_does_not_release_a_program_that_somebody_changed()
    {
        await using var cell = new RunningCell();
        var machine = cell.Machine["m1"];
        cell.Pace = cell.Pace with { Held = TimeSpan.FromDays(1) };
        cell.Start();
        cell.Drop("b_S1.csv", 1);
        await cell.Until(1, CorrectionState.Verified);
        await cell.UntilLookedAgain("slot m1/B");
        var sent = machine.Files[Program];
        machine.Files[Program] = Edited;
        machine.Files[Ready] = [];
        await UntilChanged(cell, isChanged: true);
        await cell.UntilLookedAgain("slot m1/B");
        Assert.Equal(CorrectionState.Verified, cell.Store.Find(1)!.State);
        Assert.Contains(Ready, machine.Files.Keys);

        // Read again from time to time: with the program back, the machine's word holds.
        await cell.StopAsync();
        cell.Pace = cell.Pace with { Held = TimeSpan.FromMilliseconds(20) };
        cell.Start();
        await UntilChanged(cell, isChanged: true);
        machine.Files[Program] = sent;
        await cell.Until(1, CorrectionState.Released);
        await UntilChanged(cell, isChanged: false);
        Assert.Single(cell.Store.AuditEntries(0, 1000), e => e.What == "held-again");
    }

    [Fact]
    public async Task A_release_reads_the_program_again_and_takes_a_reason_where_it_cannot()
    {
        await using var cell = new RunningCell();
        await SendOne(cell);
        var machine = cell.Machine["m1"];
        var release = new SlotRelease(cell.Settings, cell.Store, m => cell.Machine[m.Name]);
        machine.Fails = TransportError.Away;
        await Assert.ThrowsAsync<TransportException>(() => release.ReleaseAsync(1, "olga", " ", TestContext.Current.CancellationToken));
        Assert.Equal(CorrectionState.Verified, cell.Store.Find(1)!.State);
        machine.Fails = null;
        var before = machine.Done.Count;
        Assert.Equal(CorrectionState.Released, (await release.ReleaseAsync(1, "olga", null, TestContext.Current.CancellationToken)).State);
        Assert.Equal(["read " + Program], machine.Done.Skip(before));
    }

    private static Task UntilChanged(RunningCell cell, bool isChanged) => RunningCell.Until(() =>
        CellStatus.Of(cell.Settings, cell.Store, TimeProvider.System).Heartbeat?.Troubles.Any(t =>
            t is { Where: "program m1/B", Code: "changed-at-machine" }) == isChanged);

    private static async Task<byte[]> SendOne(RunningCell cell)
    {
        cell.Start();
        cell.Drop("b_S1.csv", 1);
        await cell.Until(1, CorrectionState.Verified);
        await cell.StopAsync();
        return cell.Machine["m1"].Files[Program];
    }
}
