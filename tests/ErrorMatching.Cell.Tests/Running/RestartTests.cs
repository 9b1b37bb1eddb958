namespace ErrorMatching.Cell.Tests;

/// <summary>The process ends at every instant: before and behind each step of the store, before and behind each operation at the machine.
/// The next one goes on, and the end is the same.</summary>
public sealed class RestartTests
{
    // More instants than one way has; those beyond the last one end nothing and hold as well.
    private const int Instants = 44;

    public static TheoryData<int> All => [.. Enumerable.Range(0, Instants)];

    [Theory]
    [MemberData(nameof(All))]
    public async Task Whenever_the_process_ends_the_next_one_goes_on_to_the_same_end(int instant)
    {
        await using var cell = new RunningCell();
        var machine = cell.Machine["m1"];
        var original = File.ReadAllBytes(cell.PathOf("job/counterpart-b.nc"));
        machine.Files["P2.NC"] = original;
        var killer = new Killer(instant);
        cell.AroundStep = (_, _) => killer.Tick();
        machine.Around = (_, _) =>
        {
            killer.Tick();
            Assert.True(
                machine.Files["P2.NC"] is var there
                    && (there.AsSpan().SequenceEqual(original) || RunningCell.Hash(there) == cell.Store.Find(1)?.ProgramSha256));
        };
        cell.Start();
        cell.Drop("b_S1.csv", 1);
        await RunningCell.Until(() => killer.IsDead || cell.Store.Find(1)?.State == CorrectionState.Verified);
        await cell.BuryAsync();

        killer.Revive();
        cell.Start();
        var verified = await cell.Until(1, CorrectionState.Verified);
        await cell.StopAsync();

        Assert.Null(cell.Store.Find(2));
        Assert.Equal(verified.ProgramSha256, RunningCell.Hash(machine.Files["P2.NC"]));
        Assert.Equal(["P2.NC"], machine.Files.Keys);
        Assert.Equal((RunningCell.Hash(original), 1L), (verified.PreviousSha256, cell.Store.Slot("m1", "B").Correction));
        var way = cell.Way(1).ToArray();
        Assert.Single(way, CorrectionState.Verified);
        Assert.All(way.Zip(way.Skip(1)), step => Assert.True(CorrectionSteps.Allows(step.First, step.Second)));
        Assert.Single(machine.Done, d => d == "rename P2.NC");
        Assert.Null(cell.Store.VerifyAudit());
        Assert.Empty(Directory.EnumerateFiles(cell.PathOf("incoming")));
    }

    [Fact]
    public async Task The_instants_reach_to_the_end_of_the_way()
    {
        await using var cell = new RunningCell();
        var ticks = new Killer(int.MaxValue);
        var whole = 0;
        cell.AroundStep = (to, isDone) =>
        {
            ticks.Tick();

            // What follows is looked for again and again.
            whole = (to, isDone) == (CorrectionState.Verified, true) ? ticks.Count : whole;
        };
        cell.Machine["m1"].Around = (_, _) => ticks.Tick();
        cell.Start();
        cell.Drop("b_S1.csv", 1);
        await RunningCell.Until(() => whole > 0);
        Assert.InRange(whole, 20, Instants);
    }

    // A process that is gone takes no step and sends nothing more, whatever its threads still try.
    private sealed class Killer(int instant)
    {
        private int _count;
        private volatile bool _isDead;

        public bool IsDead => _isDead;

        public int Count => _count;

        public void Tick()
        {
            if (_isDead || Interlocked.Increment(ref _count) - 1 == instant)
            {
                _isDead = true;
                throw new OperationCanceledException("The process is gone.");
            }
        }

        public void Revive() => (_isDead, _count) = (false, int.MinValue);
    }
}
