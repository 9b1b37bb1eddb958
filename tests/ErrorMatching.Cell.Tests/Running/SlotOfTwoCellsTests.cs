namespace ErrorMatching.Cell.Tests;

/// <summary>Two cells with stores, or schemas, of their own whose configurations name one slot of one machine. No right is common to them:
/// each must find the other's program, and leave it.</summary>
public sealed class SlotOfTwoCellsTests
{
    [Fact]
    public async Task The_program_of_another_cell_is_left_and_said_to_be_its()
    {
        await using var first = new RunningCell();
        await using var second = new RunningCell();
        second.Machine["m1"] = first.Machine["m1"];
        first.Start();
        first.Drop("a_S1.csv", 1);
        var sent = await first.Until(1, CorrectionState.Verified);
        second.Start();
        second.Drop("a_S2.csv", 2);
        var failed = await second.Until(1, CorrectionState.Failed);
        Assert.Equal("changed-at-machine", failed.Code);
        Assert.Equal($"of-other-cell(P1.NC, m1, {sent.ProgramSha256})", Stated.As(failed.Reason));
        Assert.Equal(sent.ProgramSha256, RunningCell.Hash(first.Machine["m1"].Files[RunningCell.Program]));
        Assert.Single(first.Machine["m1"].Done, d => d == "rename " + RunningCell.Program);

        // The cell that was first goes on, and sends the next piece once.
        new CorrectionDecisions(first.Store).Release(1, "sam", null);
        first.Drop("a_S3.csv", 3);
        var next = await first.Until(2, CorrectionState.Verified);
        Assert.Equal(next.ProgramSha256, RunningCell.Hash(first.Machine["m1"].Files[RunningCell.Program]));
        Assert.Equal(2, first.Machine["m1"].Done.Count(d => d == "rename " + RunningCell.Program));
    }

    // Both have found the slot empty, and have written their programs under names of their own.
    [Fact]
    public async Task Of_two_programs_at_once_one_at_most_counts_as_sent_and_it_is_the_one_at_the_machine()
    {
        await using var first = new RunningCell();
        await using var second = new RunningCell();
        second.Machine["m1"] = first.Machine["m1"];
        using var both = new Barrier(2);
        var written = 0;
        first.Machine["m1"].Around = (what, isDone) =>
        {
            if (what == "write" && isDone && Interlocked.Increment(ref written) <= 2)
                Assert.True(both.SignalAndWait(TimeSpan.FromMinutes(1), TestContext.Current.CancellationToken));
        };
        first.Start();
        second.Start();
        first.Drop("a_S1.csv", 1);
        second.Drop("a_S2.csv", 2);
        CorrectionState?[] ends = [];
        await RunningCell.Until(() =>
        {
            ends = [first.Store.Find(1)?.State, second.Store.Find(1)?.State];
            return ends.All(e => e is CorrectionState.Verified or CorrectionState.Failed);
        });
        Assert.Contains(CorrectionState.Failed, ends);
        foreach (var cell in new[] { first, second })
        {
            var correction = cell.Store.Find(1)!;
            if (correction.State == CorrectionState.Failed) Assert.Equal("changed-at-machine", correction.Code);
            else Assert.Equal(correction.ProgramSha256, RunningCell.Hash(first.Machine["m1"].Files[RunningCell.Program]));
        }
    }
}
