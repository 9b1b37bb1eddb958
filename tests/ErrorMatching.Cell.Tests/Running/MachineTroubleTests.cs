using System.Text;

namespace ErrorMatching.Cell.Tests;

public sealed class MachineTroubleTests
{
    [Fact]
    public async Task A_program_that_somebody_changed_is_not_overwritten_before_a_setter_approves_again()
    {
        await using var cell = new RunningCell();
        var edited = Encoding.ASCII.GetBytes("N10 G0 X0 (edited at the machine)\n");
        cell.Machine["m1"].Files[RunningCell.Program] = edited;
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        var failed = await cell.Until(1, CorrectionState.Failed);
        Assert.Equal("changed-at-machine", failed.Code);
        Assert.Equal(edited, cell.Machine["m1"].Files[RunningCell.Program]);
        Assert.Equal(edited, cell.Store.Content(failed.PreviousSha256!));
        Assert.Null(cell.Store.Slot("m1", "A").Correction);

        // Nobody overtakes what failed there.
        cell.Drop("a_S2.csv", 2);
        await cell.Until(2, CorrectionState.Approved);
        await cell.UntilLookedAgain("slot m1/A");
        Assert.Equal(CorrectionState.Approved, cell.Store.Find(2)!.State);

        using var elsewhere = cell.Open();
        new CorrectionDecisions(elsewhere).Approve(1, "sam", "seen, may go");
        var verified = await cell.Until(1, CorrectionState.Verified);
        Assert.Equal((RunningCell.Hash(edited), null), (verified.PreviousSha256, verified.Code));
    }

    // The transfer takes its time, and somebody saves at the control meanwhile.
    [Fact]
    public async Task A_program_that_somebody_changes_while_the_next_one_is_written_is_not_overwritten()
    {
        await using var cell = new RunningCell();
        var (machine, edited) = (cell.Machine["m1"], Encoding.ASCII.GetBytes("N10 G0 X0 (edited at the last moment)\n"));
        machine.Files[RunningCell.Program] = File.ReadAllBytes(cell.PathOf("job/counterpart.nc"));
        machine.Around = (what, isDone) =>
        {
            if (isDone && what == "write")
            {
                machine.Files[RunningCell.Program] = edited;
            }
        };
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        var failed = await cell.Until(1, CorrectionState.Failed);
        Assert.Equal(("changed-at-machine", RunningCell.Hash(edited)), (failed.Code, failed.PreviousSha256));
        Assert.Equal(edited, cell.Store.Content(failed.PreviousSha256!));
        Assert.Equal(edited, machine.Files[RunningCell.Program]);
        Assert.Equal([RunningCell.Program], machine.Files.Keys);

        machine.Around = null;
        using var elsewhere = cell.Open();
        new CorrectionDecisions(elsewhere).Approve(1, "sam", "seen, may go");
        await cell.Until(1, CorrectionState.Verified);
    }

    [Fact]
    public async Task An_approval_holds_for_the_program_that_was_found_and_for_no_other()
    {
        await using var cell = new RunningCell();
        cell.Machine["m1"].Files[RunningCell.Program] = "first"u8.ToArray();
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await cell.Until(1, CorrectionState.Failed);
        await cell.StopAsync();
        new CorrectionDecisions(cell.Store).Approve(1, "sam", null);
        cell.Machine["m1"].Files[RunningCell.Program] = "second"u8.ToArray();
        cell.Start();
        await RunningCell.Until(
            () => cell.Store.Find(1) is { State: CorrectionState.Failed } c && c.PreviousSha256 == RunningCell.Hash("second"u8.ToArray()));
        Assert.Equal("second"u8.ToArray(), cell.Machine["m1"].Files[RunningCell.Program]);
    }

    [Fact]
    public async Task A_machine_that_is_away_delays_its_own_slots_only()
    {
        await using var cell = new RunningCell();
        cell.Pace = cell.Pace with { Answer = TimeSpan.FromMilliseconds(50) };
        cell.Machine["m2"].Fails = TransportError.Away;
        cell.Start();
        cell.Drop("c_S1.csv", 1);
        await cell.Until(1, CorrectionState.Approved);
        cell.Drop("a_S2.csv", 2);
        await cell.Until(2, CorrectionState.Verified);
        await RunningCell.Until(() =>
            CellStatus.Of(cell.Settings, cell.Store, TimeProvider.System).Heartbeat?.Troubles is { Count: > 0 } troubles
            && troubles.Any(t => t.Where == "slot m2/A")
                && troubles.All(t => t.Code == "machine-away" && t.Where is "slot m2/A" or "machine m2"));
        Assert.Equal(CorrectionState.Approved, cell.Store.Find(1)!.State);
        cell.Machine["m2"].Fails = null;
        await cell.Until(1, CorrectionState.Verified);
        await RunningCell.Until(
            () => CellStatus.Of(cell.Settings, cell.Store, TimeProvider.System) is { IsHealthy: true, Heartbeat.Troubles.Count: 0 });
    }

    [Theory]
    [InlineData(TransportError.Login, "machine-login")]
    [InlineData(TransportError.Full, "machine-full")]
    [InlineData(TransportError.WrongServer, "machine-wrong-server")]
    public async Task What_no_other_try_mends_fails_and_holds_its_slot_until_a_setter_approves_again(TransportError error, string code)
    {
        await using var cell = new RunningCell();
        cell.Machine["m1"].Fails = error;
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        Assert.Equal(code, (await cell.Until(1, CorrectionState.Failed)).Code);
        Assert.False(CellStatus.Of(cell.Settings, cell.Store, TimeProvider.System).IsHealthy);
        cell.Machine["m1"].Fails = null;
        using var elsewhere = cell.Open();
        new CorrectionDecisions(elsewhere).Approve(1, "sam", null);
        await cell.Until(1, CorrectionState.Verified);
    }

    [Fact]
    public async Task A_cut_behind_the_rename_is_seen_as_what_it_is_when_the_machine_is_back()
    {
        await using var cell = new RunningCell();
        var machine = cell.Machine["m1"];
        machine.Around = (what, isDone) =>
        {
            if (isDone && what == "rename " + RunningCell.Program)
            {
                machine.Fails = TransportError.Away;
                throw new TransportException(TransportError.Away, "cut");
            }
        };
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await RunningCell.Until(() => machine.Fails is not null);
        await cell.UntilLookedAgain("slot m1/A");
        Assert.Equal(CorrectionState.Uploading, cell.Store.Find(1)!.State);
        machine.Fails = null;
        await cell.Until(1, CorrectionState.Verified);
        Assert.Single(machine.Done, d => d == "rename " + RunningCell.Program);
    }

    [Fact]
    public async Task A_program_is_taken_back_in_one_step_and_the_slot_stays_taken_until_it_is_released()
    {
        await using var cell = new RunningCell();
        var original = File.ReadAllBytes(cell.PathOf("job/counterpart.nc"));
        cell.Machine["m1"].Files[RunningCell.Program] = original;
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await cell.Until(1, CorrectionState.Verified);
        using var elsewhere = cell.Open();
        var reverted = await Reversal(cell, elsewhere).RevertAsync(1, "sam", "chatter", TestContext.Current.CancellationToken);
        Assert.Equal(CorrectionState.Reverted, reverted.State);
        Assert.Equal(original, cell.Machine["m1"].Files[RunningCell.Program]);

        cell.Drop("a_S2.csv", 2);
        await cell.Until(2, CorrectionState.Approved);
        await cell.UntilLookedAgain("slot m1/A");
        Assert.Equal(CorrectionState.Approved, cell.Store.Find(2)!.State);
        new CorrectionDecisions(elsewhere).Release(1, "olga", null);
        await cell.Until(2, CorrectionState.Verified);
    }

    [Fact]
    public async Task What_somebody_changed_or_a_later_program_replaced_is_not_taken_back()
    {
        await using var cell = new RunningCell();
        cell.Machine["m1"].Files[RunningCell.Program] = File.ReadAllBytes(cell.PathOf("job/counterpart.nc"));
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await cell.Until(1, CorrectionState.Verified);
        await cell.StopAsync();
        var sent = cell.Machine["m1"].Files[RunningCell.Program];
        cell.Machine["m1"].Files[RunningCell.Program] = "other"u8.ToArray();
        var changed = await Assert.ThrowsAsync<DecisionException>(
            () => Reversal(cell, cell.Store).RevertAsync(1, "sam", "x", TestContext.Current.CancellationToken));
        Assert.Equal("changed-at-machine", changed.Code);
        Assert.Equal("other"u8.ToArray(), cell.Machine["m1"].Files[RunningCell.Program]);

        cell.Machine["m1"].Files[RunningCell.Program] = sent;
        new CorrectionDecisions(cell.Store).Release(1, "olga", null);
        cell.Start();
        cell.Drop("a_S2.csv", 2);
        await cell.Until(2, CorrectionState.Verified);
        await cell.StopAsync();
        Assert.Equal(
            "slot-taken",
            (
                await Assert.ThrowsAsync<DecisionException>(
                    () => Reversal(cell, cell.Store).RevertAsync(1, "sam", "x", TestContext.Current.CancellationToken))).Code);
        new CorrectionDecisions(cell.Store).Release(2, "olga", null);
        Assert.Equal(
            "wrong-state",
            (
                await Assert.ThrowsAsync<DecisionException>(
                    () => Reversal(cell, cell.Store).RevertAsync(1, "sam", "x", TestContext.Current.CancellationToken))).Code);
    }

    [Fact]
    public async Task A_slot_that_was_empty_has_nothing_to_take_back()
    {
        await using var cell = new RunningCell();
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await cell.Until(1, CorrectionState.Verified);
        Assert.Equal(
            "nothing-before",
            (
                await Assert.ThrowsAsync<DecisionException>(
                    () => Reversal(cell, cell.Store).RevertAsync(1, "sam", "x", TestContext.Current.CancellationToken))).Code);
    }

    [Fact]
    public async Task A_stop_in_the_middle_of_a_transfer_leaves_the_slot_in_order()
    {
        await using var cell = new RunningCell();
        var machine = cell.Machine["m1"];
        var hangs = false;
        machine.Hangs = what => hangs |= what == "write";
        cell.Pace = cell.Pace with { Finish = TimeSpan.FromMilliseconds(50) };
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await RunningCell.Until(() => hangs);
        machine.Hangs = null;
        await cell.StopAsync();
        Assert.Equal(CorrectionState.Approved, cell.Store.Find(1)!.State);
        Assert.Null(cell.Store.Slot("m1", "A").Correction);
        Assert.Empty(machine.Files);
        cell.Start();
        await cell.Until(1, CorrectionState.Verified);
    }

    private static SlotReversal Reversal(RunningCell cell, CellStore store) =>
        new(cell.Settings, store, m => cell.Machine[m.Name], TimeProvider.System);
}
