namespace ErrorMatching.Cell.Tests;

/// <summary>What a reversal does at a slot that has a ready file.</summary>
public sealed class SlotReversalTests
{
    private const string Program = "P2.NC";
    private const string Ready = "B.READY";

    [Fact]
    public async Task A_reversal_first_says_who_began_it_and_removes_the_ready_file_of_what_it_takes_back()
    {
        await using var cell = new RunningCell();
        var original = await SendOne(cell);
        var machine = cell.Machine["m1"];
        var (before, atWrite) = (cell.Store.ChangeCount(), new List<(string, string, string?, string)>());
        machine.Around = (what, isDone) =>
        {
            if (what == "write" && !isDone)
            {
                Assert.False(machine.Files.ContainsKey(Ready));
                atWrite.AddRange(cell.Store.AuditEntries(before, 9).Select(e => (e.Who, e.What, e.Subject?.Sentence, e.Basis.Sentence)));
            }
        };
        Assert.Equal(CorrectionState.Reverted, (await Revert(cell)).State);
        Assert.Equal(original, machine.Files[Program]);
        Assert.Equal([("sam", "reverting", "correction 1", "chatter")], atWrite);
    }

    [Fact]
    public async Task A_reversal_that_is_refused_leaves_the_ready_file_and_no_entry()
    {
        await using var cell = new RunningCell();
        await SendOne(cell);
        var machine = cell.Machine["m1"];
        machine.Files[Program] = "edited"u8.ToArray();
        var before = cell.Store.ChangeCount();
        Assert.Equal("changed-at-machine", (await Assert.ThrowsAsync<DecisionException>(() => Revert(cell))).Code);
        Assert.True(machine.Files.ContainsKey(Ready));
        Assert.Equal(before, cell.Store.ChangeCount());
    }

    [Fact]
    public async Task A_reversal_that_was_cut_behind_its_transfer_is_ended_without_another()
    {
        await using var cell = new RunningCell();
        var original = await SendOne(cell);
        var machine = cell.Machine["m1"];
        machine.Files[Program] = original;
        machine.Done.Clear();
        var before = cell.Store.ChangeCount();
        Assert.Equal(CorrectionState.Reverted, (await Revert(cell)).State);
        Assert.Equal([Program], machine.Files.Keys);
        Assert.DoesNotContain("write", machine.Done);
        Assert.Equal(["reverted"], cell.Store.AuditEntries(before, 9).Select(e => e.What));
    }

    // What was just sent holds its slot a moment longer than the store says.
    [Fact]
    public async Task A_reversal_waits_a_moment_for_whoever_has_just_sent()
    {
        await using var cell = new RunningCell();
        await SendOne(cell);
        var sending = cell.Store.TryLockSlot("m1", "B");
        Assert.NotNull(sending);
        var reverting = Revert(cell);
        Assert.False(reverting.IsCompleted);
        sending.Dispose();
        Assert.Equal(CorrectionState.Reverted, (await reverting).State);
    }

    // A program in a slot that held the original, and the machine's word that its piece is cut, which nobody has read yet.
    private static async Task<byte[]> SendOne(RunningCell cell)
    {
        var original = File.ReadAllBytes(cell.PathOf("job/counterpart-b.nc"));
        cell.Machine["m1"].Files[Program] = original;
        cell.Start();
        cell.Drop("b_S1.csv", 1);
        await cell.Until(1, CorrectionState.Verified);
        await cell.StopAsync();
        cell.Machine["m1"].Files[Ready] = [];
        return original;
    }

    private static Task<Correction> Revert(RunningCell cell) =>
        new SlotReversal(
            cell.Settings,
            cell.Store,
            m => cell.Machine[m.Name],
            TimeProvider.System).RevertAsync(1, "sam", "chatter", TestContext.Current.CancellationToken);
}
