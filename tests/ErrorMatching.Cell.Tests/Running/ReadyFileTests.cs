namespace ErrorMatching.Cell.Tests;

/// <summary>What a cell does with a ready file where another one serves the same slot.</summary>
public sealed class ReadyFileTests
{
    private const string Ready = "B.READY";

    // Else the other one may have sent the next program meanwhile, and the ready file of its piece would be removed.
    [Fact]
    public async Task A_ready_file_is_removed_only_while_nobody_else_may_send_to_the_slot()
    {
        await using var cell = new RunningCell();
        var machine = cell.Machine["m1"];
        var (store, removed) = (cell.Store, 0);
        machine.Around = (what, isDone) =>
        {
            if (what == "delete " + Ready && !isDone)
            {
                using var right = store.TryLockSlot("m1", "B");
                Assert.Null(right);
                removed++;
            }
        };
        cell.Start();
        cell.Drop("b_S1.csv", 1);
        await cell.Until(1, CorrectionState.Verified);
        machine.Files[Ready] = [];
        await cell.Until(1, CorrectionState.Released);
        await cell.StopAsync();
        Assert.Null(machine.Broken);

        // Before the program is sent, and once it is cut.
        Assert.Equal(2, removed);
        Assert.DoesNotContain(Ready, machine.Files.Keys);
    }

    [Fact]
    public async Task A_ready_file_waits_for_whoever_has_the_right_to_the_slot()
    {
        await using var cell = new RunningCell();
        var machine = cell.Machine["m1"];
        cell.Start();
        cell.Drop("b_S1.csv", 1);
        await cell.Until(1, CorrectionState.Verified);
        ISlotLock? right = null;
        await RunningCell.Until(() => (right = cell.Store.TryLockSlot("m1", "B")) is not null);
        machine.Files[Ready] = [];
        await cell.UntilListedAgain("m1");
        Assert.Equal(CorrectionState.Verified, cell.Store.Find(1)!.State);
        Assert.Contains(Ready, machine.Files.Keys);
        right!.Dispose();
        await cell.Until(1, CorrectionState.Released);
        await RunningCell.Until(() => !machine.Files.ContainsKey(Ready));
    }
}
