using ErrorMatching.Json;

namespace ErrorMatching.Cell.Tests;

/// <summary>The process ends at some instant of an offset's way to its machine, and of the way back. The next one goes on to the same
/// end.</summary>
public sealed class OffsetRestartTests
{
    // Some of the instants before and behind steps and operations; RestartTests has all of them, for a program that cuts.
    private const int Instants = 44;
    private const int Each = 9;

    [Fact]
    public async Task Whenever_the_process_ends_an_offset_is_sent_once_and_taken_back_once()
    {
        for (var instant = 1; instant < Instants; instant += Each)
        {
            await using var cell = OffsetCell.Of();
            var machine = new MemoryMachine("m1");
            var left = instant;
            void Tick()
            {
                if (left-- <= 0) throw new OperationCanceledException("The process is gone.");
            }

            cell.Opens = _ => machine;
            cell.AroundStep = (_, _) => Tick();
            machine.Around = (_, _) => Tick();
            cell.Start();
            cell.Drop("part_S1.csv", OffsetCell.Grown(0.02));
            await ConfiguredCell.Until(() => left < 0 || cell.Store.Find(1)?.State == CorrectionState.Verified);
            await cell.BuryAsync();
            left = int.MaxValue;
            cell.Start();
            var sent = await cell.Until(1, CorrectionState.Verified);
            await cell.StopAsync();
            Assert.Null(cell.Store.Find(2));
            Assert.Equal([OffsetCell.Program], machine.Files.Keys);
            Assert.Equal(sent.ProgramSha256, ContentHash.Sha256(machine.Files[OffsetCell.Program]));
            Assert.Single(machine.Done, d => d == "rename " + OffsetCell.Program);

            left = instant / 4;
            await Assert.ThrowsAsync<OperationCanceledException>(() => Revert(cell));
            var there = ContentHash.Sha256(machine.Files[OffsetCell.Program]);
            Assert.Contains(there, new[] { sent.ProgramSha256, sent.UndoSha256 });
            left = int.MaxValue;
            Assert.Equal(CorrectionState.Reverted, (await Revert(cell)).State);
            Assert.Equal([OffsetCell.Program], machine.Files.Keys);
            Assert.Equal(sent.UndoSha256, ContentHash.Sha256(machine.Files[OffsetCell.Program]));
            Assert.Equal(2, machine.Done.Count(d => d == "rename " + OffsetCell.Program));
            Assert.Equal(sent.UndoSha256, cell.Store.Slot("m1", "A").ProgramSha256);
            Assert.Null(cell.Store.VerifyAudit());
        }
    }

    private static Task<Correction> Revert(ConfiguredCell cell) =>
        new SlotReversal(cell.Settings, cell.Store, cell.Opens, TimeProvider.System).RevertAsync(
            1, "sam", "chatter", TestContext.Current.CancellationToken);
}
