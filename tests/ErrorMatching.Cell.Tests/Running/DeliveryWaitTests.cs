namespace ErrorMatching.Cell.Tests;

/// <summary>A program waits for its machine, says why, and goes on.</summary>
public sealed class DeliveryWaitTests
{
    private static readonly MachineState Busy = ToldState.Of(MachineActivity.Running, RunningCell.Program);
    private static readonly MachineState Free = ToldState.Of(MachineActivity.Idle, RunningCell.Program);
    private static readonly MachineState Other = ToldState.Of(MachineActivity.Running, "O9.NC");

    [Fact]
    public async Task A_program_waits_while_the_machine_runs_the_one_before_says_why_and_is_sent_when_it_is_idle()
    {
        var state = Busy;
        await using var cell = Cell(() => state);
        var original = cell.Machine["m1"].Files[RunningCell.Program];
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await cell.Until(1, CorrectionState.Approved);
        await RunningCell.Until(() => Status(cell).Slots[0].Delivery is { Correction: 1 });
        var slot = Status(cell).Slots[0];
        Assert.StartsWith("machine-busy(m1, running, P1.NC, ", Stated.As(slot.Delivery!.Statement), StringComparison.Ordinal);
        Assert.Equal(MachineActivity.Running, slot.Report?.State.Activity);

        // Waiting is no trouble, and only the machine's own slots wait.
        Assert.True(Status(cell).IsHealthy);
        cell.Drop("c_S2.csv", 2);
        await cell.Until(2, CorrectionState.Verified);
        await cell.UntilLookedAgain("slot m1/A");
        Assert.Equal(original, cell.Machine["m1"].Files[RunningCell.Program]);
        Assert.Equal(CorrectionState.Approved, cell.Way(1).Last());

        state = Free;
        await cell.Until(1, CorrectionState.Verified);
        await RunningCell.Until(() => Status(cell).Slots[0] is { Delivery: null, Report.State.Activity: MachineActivity.Idle });
        Assert.Equal("read-back", Stated.As(cell.Store.Corrections.StepsOf(1)[^1].Basis));
    }

    [Fact]
    public async Task A_program_is_sent_while_the_machine_runs_another_one()
    {
        await using var cell = Cell(() => Other);
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await cell.Until(1, CorrectionState.Verified);
    }

    // The file of the slot is P1.NC, and the program in it is O0211: the control calls it by its number.
    [Theory]
    [InlineData("O0211")]
    [InlineData("211")]
    [InlineData("//CNC_MEM/USER/PATH1/O0211")]
    [InlineData("O0211(COMPLEX MATING)")]
    [InlineData("")]
    public async Task A_program_that_the_machine_runs_by_its_number_is_not_replaced(string reported)
    {
        var state = ToldState.Of(MachineActivity.Running, reported);
        await using var cell = Cell(() => state);
        var original = cell.Machine["m1"].Files[RunningCell.Program];
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await cell.Until(1, CorrectionState.Approved);
        await RunningCell.Until(
            () => Status(cell).Slots[0].Delivery is { Correction: 1 } || cell.Store.Find(1)!.State != CorrectionState.Approved);
        await cell.UntilLookedAgain("slot m1/A");
        Assert.Equal((CorrectionState.Approved, original), (cell.Store.Find(1)!.State, cell.Machine["m1"].Files[RunningCell.Program]));
        state = Other;
        await cell.Until(1, CorrectionState.Verified);
    }

    // What is there has another number than what is to be sent: both are in use.
    [Fact]
    public async Task The_program_before_counts_by_its_own_number_too()
    {
        var state = ToldState.Of(MachineActivity.Running, "O0999");
        await using var cell = Cell(() => state);
        var there = System.Text.Encoding.ASCII.GetBytes("%\nO0999\nG0 X0\nM30\n%\n");
        cell.Machine["m1"].Files[RunningCell.Program] = there;
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await RunningCell.Until(() => Status(cell).Slots[0].Delivery is { Correction: 1 });
        Assert.Equal(there, cell.Machine["m1"].Files[RunningCell.Program]);
    }

    [Fact]
    public async Task A_wait_beyond_its_limit_is_a_trouble_and_no_loss()
    {
        var state = MachineState.Unknown(Recorded.StateUnavailable.With("agent", "Execution"));
        await using var cell = Cell(() => state, TimeSpan.FromMilliseconds(1));
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await RunningCell.Until(() => Status(cell).Heartbeat?.Troubles is [{ Code: "waits-too-long", Where: "delivery m1/A" }]);
        Assert.False(Status(cell).IsHealthy);
        Assert.Contains(
            "state-unavailable(agent, Execution)", Stated.As(Status(cell).Heartbeat!.Troubles[0].Statement), StringComparison.Ordinal);
        await cell.UntilLookedAgain("slot m1/A", "slot m1/A");
        Assert.Single(cell.Store.AuditEntries(0, 1000), e => e.What == "waits-too-long");
        Assert.Equal(CorrectionState.Approved, cell.Store.Find(1)!.State);
        state = Free;
        await cell.Until(1, CorrectionState.Verified);
        await RunningCell.Until(() => Status(cell).IsHealthy);
    }

    [Fact]
    public async Task A_source_that_does_not_answer_is_a_trouble_and_recorded_once_and_so_is_its_return()
    {
        var state = MachineState.Unknown(Recorded.StateAway.With("agent", "refused"), "state-away");
        await using var cell = Cell(() => state);
        cell.Pace = cell.Pace with { Answer = TimeSpan.FromMilliseconds(30) };
        cell.Start();
        await RunningCell.Until(() => Status(cell).Heartbeat?.Troubles is [{ Code: "state-away", Where: "state m1" }]);
        state = Free;
        await RunningCell.Until(() => Status(cell).IsHealthy);
        Assert.Equal(
            ["no-answer", "answers-again"],
            cell.Store.AuditEntries(0, 1000).Where(e => e.Subject == "the test").Select(e => e.What));
    }

    // Idle when the slot is taken, running at the last look: it is given back before anything is replaced, and waits.
    [Fact]
    public async Task A_machine_that_starts_after_the_slot_is_taken_gets_nothing_and_the_slot_is_given_back()
    {
        var state = Free;
        await using var cell = Cell(() => state);
        var (machine, before) = (cell.Machine["m1"], cell.Machine["m1"].Files[RunningCell.Program]);
        machine.Around = (what, isDone) =>
        {
            if (what == "write" && isDone)
                state = Busy;
        };
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await RunningCell.Until(() => Status(cell).Slots[0].Delivery is { Correction: 1 });
        Assert.Equal(CorrectionState.Approved, cell.Way(1).Last());
        Assert.Equal(before, Assert.Single(machine.Files).Value);
        machine.Around = null;
        state = Free;
        await cell.Until(1, CorrectionState.Verified);
    }

    // Between the last look and the replacement: noticed, and nobody is told that the program is verified.
    [Fact]
    public async Task A_machine_that_starts_during_the_replacement_is_told_and_a_person_decides()
    {
        var state = Free;
        await using var cell = Cell(() => state);
        cell.Machine["m1"].Around = (what, isDone) =>
        {
            if (what == "rename " + RunningCell.Program && !isDone)
                state = Busy;
        };
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        var failed = await cell.Until(1, CorrectionState.Failed);
        Assert.Equal("started-meanwhile", failed.Code);
        Assert.DoesNotContain(CorrectionState.Verified, cell.Way(1));
        cell.Machine["m1"].Around = null;
        state = Free;
        new CorrectionDecisions(cell.Store).Approve(1, "sam", "stopped and looked");
        await cell.Until(1, CorrectionState.Verified);
    }

    [Fact]
    public async Task A_revert_is_refused_while_the_machine_runs_the_program_and_changes_nothing()
    {
        var state = Free;
        await using var cell = Cell(() => state);
        var original = cell.Machine["m1"].Files[RunningCell.Program];
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await cell.Until(1, CorrectionState.Verified);
        await cell.StopAsync();
        state = Busy;
        var (sent, before) = (cell.Machine["m1"].Files[RunningCell.Program], cell.Store.ChangeCount());
        Assert.Equal("machine-busy", (await Assert.ThrowsAsync<DecisionException>(() => Revert(cell))).Code);
        Assert.Equal(sent, Assert.Single(cell.Machine["m1"].Files).Value);
        Assert.Equal(before, cell.Store.ChangeCount());

        state = Free;
        cell.Machine["m1"].Around = (what, isDone) =>
        {
            if (what == "rename " + RunningCell.Program && !isDone)
                state = Busy;
        };
        Assert.Equal("started-meanwhile", (await Assert.ThrowsAsync<DecisionException>(() => Revert(cell))).Code);
        Assert.Equal(CorrectionState.Verified, cell.Store.Find(1)!.State);
        cell.Machine["m1"].Around = null;
        Assert.Equal(CorrectionState.Reverted, (await Revert(cell)).State);
        Assert.Equal(original, cell.Machine["m1"].Files[RunningCell.Program]);
    }

    [Fact]
    public async Task Over_1000_random_states_a_running_cell_replaces_no_program_in_use()
    {
        var control = new SimulatedControl(29, RunningCell.Program, freed: 0.01);
        await using var cell = Cell(control.Ask);

        // Other questions would change the state in the window that no cell can close.
        cell.Pace = cell.Pace with { State = TimeSpan.FromDays(1) };
        cell.Machine["m1"].Around = (what, isDone) =>
        {
            if (!isDone)
                control.Do(what == "rename " + RunningCell.Program);
        };
        cell.Start();
        for (var i = 1; control.Changes < 1000; i++)
        {
            cell.Drop($"a_S{i}.csv", i);
            await RunningCell.Until(() =>
            {
                if (cell.Store.Find(i) is { State: CorrectionState.Failed } failed)
                    new CorrectionDecisions(cell.Store).Approve(failed.Id, "sam", "looked");
                return cell.Store.Find(i)?.State == CorrectionState.Verified;
            });
            new CorrectionDecisions(cell.Store).Release(i, "sam", "cut");
        }

        Assert.Empty(control.Wrong);
        Assert.InRange(control.Replaced, 3, 1000);
    }

    private static RunningCell Cell(Func<MachineState> say, TimeSpan? limit = null)
    {
        var told = new ToldState(say);
        var cell = new RunningCell { State = told with { WaitLimit = limit ?? told.WaitLimit } };
        cell.Machine["m1"].Files[RunningCell.Program] = File.ReadAllBytes(cell.PathOf("job/counterpart.nc"));
        cell.Pace = cell.Pace with { Busy = TimeSpan.FromMilliseconds(1), State = TimeSpan.FromMilliseconds(20) };
        return cell;
    }

    private static CellStatus Status(RunningCell cell) => CellStatus.Of(cell.Settings, cell.Store, TimeProvider.System);

    private static Task<Correction> Revert(RunningCell cell) => new SlotReversal(
        cell.Settings, cell.Store, m => cell.Machine[m.Name], TimeProvider.System)
        .RevertAsync(1, "sam", "chatter", TestContext.Current.CancellationToken);
}
