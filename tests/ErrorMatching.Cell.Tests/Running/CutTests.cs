namespace ErrorMatching.Cell.Tests;

/// <summary>The process ends where what lies at the machine is easily mistaken.</summary>
public sealed class CutTests
{
    [Theory]
    [InlineData(CorrectionState.Uploading, false)]
    [InlineData(CorrectionState.Uploading, true)]
    [InlineData(CorrectionState.Failed, false)]
    [InlineData(CorrectionState.Failed, true)]
    public async Task A_program_that_somebody_changed_is_never_overwritten_wherever_the_process_ends(CorrectionState to, bool isTaken)
    {
        await using var cell = new RunningCell();
        var edited = "N10 G0 X0 (edited at the machine)\n"u8.ToArray();
        var machine = cell.Machine["m1"];
        machine.Files[RunningCell.Program] = edited;
        var isCut = Cut(cell, to, isTaken);
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await RunningCell.Until(isCut);
        await cell.BuryAsync();

        cell.Start();
        await cell.Until(1, CorrectionState.Failed);
        await cell.UntilLookedAgain("slot m1/A");
        var failed = cell.Store.Find(1)!;
        Assert.Equal(
            (CorrectionState.Failed, "changed-at-machine", RunningCell.Hash(edited)), (failed.State, failed.Code, failed.PreviousSha256));
        Assert.Equal(edited, cell.Store.Content(failed.PreviousSha256!));
        Assert.Equal(edited, machine.Files[RunningCell.Program]);
        Assert.DoesNotContain("write", machine.Done);
    }

    [Fact]
    public async Task Where_the_old_program_is_the_new_one_a_ready_file_of_the_old_one_releases_nothing()
    {
        byte[] program;
        await using (var earlier = new RunningCell())
        {
            earlier.Start();
            earlier.Drop("b_S1.csv", 1);
            await earlier.Until(1, CorrectionState.Verified);
            program = earlier.Machine["m1"].Files["P2.NC"];
        }

        await using var cell = new RunningCell();
        var machine = cell.Machine["m1"];
        machine.Files["P2.NC"] = program;
        machine.Files["B.READY"] = [];
        var isCut = Cut(cell, CorrectionState.Uploading, true);
        cell.Start();
        cell.Drop("b_S1.csv", 1);
        await RunningCell.Until(isCut);
        await cell.BuryAsync();

        cell.Start();
        var verified = await cell.Until(1, CorrectionState.Verified);
        Assert.Equal((RunningCell.Hash(program), RunningCell.Hash(program)), (verified.PreviousSha256, verified.ProgramSha256));
        Assert.False(machine.Files.ContainsKey("B.READY"));
        await cell.UntilListedAgain("m1");
        Assert.Equal(CorrectionState.Verified, cell.Store.Find(1)!.State);
    }

    // The process ends once: before or behind the first step to a state.
    private static Func<bool> Cut(RunningCell cell, CorrectionState to, bool isTaken)
    {
        var isCut = false;
        cell.AroundStep = (state, isDone) =>
        {
            if (!isCut && (state, isDone) == (to, isTaken))
            {
                isCut = true;
                throw new OperationCanceledException("The process is gone.");
            }
        };
        return () => isCut;
    }
}
