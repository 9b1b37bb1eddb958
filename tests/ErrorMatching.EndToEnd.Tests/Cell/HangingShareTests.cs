using System.Diagnostics;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A cell at its own pace with a pipe in place of a slot's program: whoever opens it waits for good.</summary>
public sealed class HangingShareTests
{
    private static readonly TimeSpan Patience = TimeSpan.FromMinutes(2);

    [Fact]
    public async Task A_pipe_in_place_of_a_program_keeps_a_cell_from_nothing_but_its_slot_and_it_ends_within_10_s()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "Windows has no pipes in folders.");
        using var cell = new FireCell(slots: 2);
        var files = new FireFiles();
        var (hanging, other) = (files.Next(cell.Slots[0], 1), files.Next(cell.Slots[1], 2));
        var program = Path.Combine(cell.Machine, FireCell.ProgramOf(cell.Slots[0]));
        File.Move(program, cell["original"]);
        using (var make = Process.Start("mkfifo", program))
        {
            await make.WaitForExitAsync(TestContext.Current.CancellationToken);
            Assert.Equal(0, make.ExitCode);
        }

        // And telemetry goes to somebody who never answers.
        using var receiver = new OtlpReceiver(hangs: true);
        cell.Start(("OTEL_EXPORTER_OTLP_ENDPOINT", receiver.Endpoint), ("OTEL_BSP_SCHEDULE_DELAY", "100"));
        cell.Drop(hanging.Name, hanging.Bytes);
        await cell.Until(async () => await cell.StateOf(hanging.Name) == "failed", Patience, "the first finds no program");
        cell.Drop(other.Name, other.Bytes);
        await cell.Until(async () => await cell.StateOf(other.Name) == "verified", Patience, "the second is sent");

        await cell.Until(() => Task.FromResult(receiver.Connections > 0), Patience, "telemetry is sent");
        await cell.Stop();
        Assert.Equal("failed", await cell.StateOf(hanging.Name));

        // What fails waits for a person; what was there is untouched.
        File.Delete(program);
        File.Move(cell["original"], program);
        cell.Start();
        await cell.HasBegun();
        await cell.Until(async () => (await cell.StateOf(other.Name)) == "verified", Patience, "the next start goes on");
        Assert.False(files.FileByProgram.ContainsKey(FireFiles.Hash(
            await File.ReadAllBytesAsync(program, TestContext.Current.CancellationToken))));
        await cell.Stop();
        await cell.AuditHolds();
    }
}
