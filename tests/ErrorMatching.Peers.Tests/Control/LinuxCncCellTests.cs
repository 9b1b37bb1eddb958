using System.Diagnostics;
using System.Globalization;
using System.Text;
using ErrorMatching.Cell;
using ErrorMatching.Cell.Tests;

namespace ErrorMatching.Peers.Tests;

/// <summary>A cell and a real control: no program is replaced while it runs.</summary>
public sealed class LinuxCncCellTests(LinuxCncControl control) : IClassFixture<LinuxCncControl>
{
    private const string Program = "COUNTERPART.NGC";

    private static CancellationToken Token => TestContext.Current.CancellationToken;

    [Fact]
    public async Task A_running_program_is_not_replaced_and_the_next_one_comes_when_it_has_ended()
    {
        LinuxCncControl.IsNeeded();
        await using var cell = await StartAsync();
        cell.Drop("S1.csv", Measurement(1));
        await cell.Until(1, CorrectionState.Verified);
        var first = await File.ReadAllBytesAsync(Path.Combine(control.Nc, Program), Token);
        await control.OpenAsync(Program);
        await control.RunAsync();
        new CorrectionDecisions(cell.Store).Release(1, "sam", "in the machine");

        // Asked to replace it while it runs.
        cell.Drop("S2.csv", Measurement(2));
        await ConfiguredCell.Until(() => Slot(cell).Delivery is { Correction: 2 });
        Assert.Contains(
            $"running with the program {control.Nc}/{Program}", Slot(cell).Delivery!.Statement.Sentence, StringComparison.Ordinal);
        Assert.Equal("RUNNING", await control.StatusAsync());

        // Held is not ended.
        await control.SetAsync("pause");
        await control.UntilStatusAsync("PAUSED");
        await ConfiguredCell.Until(() => Slot(cell).Report?.State.Activity == MachineActivity.Held);
        Assert.Equal(first, await File.ReadAllBytesAsync(Path.Combine(control.Nc, Program), Token));
        Assert.Equal(CorrectionState.Approved, cell.Store.Find(2)!.State);
        await control.SetAsync("resume");
        await control.UntilStatusAsync("RUNNING");

        while (await control.StatusAsync() != "IDLE")
        {
            Assert.Equal(CorrectionState.Approved, cell.Store.Find(2)!.State);
            await Task.Delay(50, Token);
        }

        var idle = Stopwatch.GetTimestamp();
        Assert.Equal(50, (await control.PlaceAsync()).Z, 6);
        await cell.Until(2, CorrectionState.Verified);
        TestContext.Current.TestOutputHelper!.WriteLine($"sent {Stopwatch.GetElapsedTime(idle).TotalSeconds:0.00} s after the end");
        Assert.NotEqual(first, await File.ReadAllBytesAsync(Path.Combine(control.Nc, Program), Token));
        Assert.Null(cell.Store.VerifyAudit());
    }

    // The control's state changes at random whenever it is asked and between any two operations with its files, except between the last
    // answer and the replacement: that window no cell can close.
    [Fact(Explicit = true)]
    public async Task Over_random_states_of_the_control_no_program_that_runs_is_replaced()
    {
        LinuxCncControl.IsNeeded();
        var changes = Environment.GetEnvironmentVariable("ERRORMATCH_CONTROL_CHANGES") is { } text
            ? int.Parse(text, CultureInfo.InvariantCulture)
            : 50;
        foreach (var name in new[] { "A.NGC", "B.NGC" })
            await File.WriteAllTextAsync(Path.Combine(control.Nc, name), "G21 G90\nG4 P600\nM2\n", Token);
        var (random, done, replaced, windows) = (new Random(29), 0, 0, new List<double>());
        long answered = 0;
        var source = new LinuxCncSettings("127.0.0.1", control.Port);
        var state = new HookedState(source, ChangeAsync, () => answered = Stopwatch.GetTimestamp());
        var guard = ReplacementGuard.Of(Machine(state), TimeProvider.System);
        var folder = new HookedFolder(
            MachineFolders.Open(Machine(state), () => null),
            async isReplacing =>
            {
                if (!isReplacing)
                {
                    await ChangeAsync();
                    return;
                }

                windows.Add(Stopwatch.GetElapsedTime(answered).TotalMilliseconds);
                replaced++;
                var (status, program) = (await control.StatusAsync(), await control.ProgramAsync());
                Assert.False(
                    status != "IDLE" && program.EndsWith("A.NGC", StringComparison.Ordinal), $"Replaced while {status}: {program}");
            });
        for (var number = 1; done < changes; number++)
        {
            var (old, sender) = (
                await File.ReadAllBytesAsync(Path.Combine(control.Nc, "A.NGC"), Token), new ProgramSender(folder, _ => true, null, guard));
            try
            {
                await sender.SendAsync(
                    "A.NGC", Hash(old), Encoding.ASCII.GetBytes($"(NUMBER {number})\nG21 G90\nG4 P600\nM2\n"), "1", Token);
            }
            catch (MachineBusyException)
            {
                // It waits for another state.
            }
        }

        await control.SetAsync("abort");
        await control.UntilStatusAsync("IDLE");
        windows.Sort();
        TestContext.Current.TestOutputHelper!.WriteLine(
            $"{done} changes, {replaced} replacements, "
            + $"from answer to replacement {windows[windows.Count / 2]:0.00} ms (at most {windows[^1]:0.00} ms)");
        Assert.InRange(replaced, 3, done);

        async Task ChangeAsync()
        {
            done++;
            var status = await control.StatusAsync();
            switch (random.Next(6))
            {
                case 0 when status == "RUNNING":
                    await control.SetAsync("pause");
                    await control.UntilStatusAsync("PAUSED");
                    break;
                case 1 when status == "PAUSED":
                    await control.SetAsync("resume");
                    await control.UntilStatusAsync("RUNNING");
                    break;
                case 2 when status == "IDLE":
                    await control.OpenAsync(random.Next(3) == 0 ? "B.NGC" : "A.NGC");
                    await control.RunAsync();
                    break;
                case 3 or 4 when status != "IDLE":
                    await control.SetAsync("abort");
                    await control.UntilStatusAsync("IDLE");
                    break;
            }
        }
    }

    // What remains: the control has opened a selected program, and runs what it has opened.
    [Fact]
    public async Task A_program_that_was_selected_before_it_was_replaced_runs_once_more_as_it_was()
    {
        LinuxCncControl.IsNeeded();
        await WriteAsync("G21 G90\nG1 X1 F6000\nM2\n");
        await control.OpenAsync("S.NGC");
        await WriteAsync("G21 G90\nG1 X2 F6000\nM2\n");
        foreach (var x in new[] { 1.0, 2.0 })
        {
            await control.SetAsync("run");
            await UntilEndAtAsync(x);
        }

        await WriteAsync("G21 G90\nG1 X3 F6000\nM2\n");
        await control.OpenAsync("S.NGC");
        await control.SetAsync("run");
        await UntilEndAtAsync(3);

        Task UntilEndAtAsync(double x) => control.UntilAsync(
            async () => Math.Abs((await control.PlaceAsync()).X - x) < 1e-6 && await control.StatusAsync() == "IDLE");

        async Task WriteAsync(string text)
        {
            await File.WriteAllTextAsync(Path.Combine(control.Nc, "S.NEW"), text, Token);
            File.Move(Path.Combine(control.Nc, "S.NEW"), Path.Combine(control.Nc, "S.NGC"), overwrite: true);
        }
    }

    private static SlotStatus Slot(ConfiguredCell cell) => CellStatus.Of(cell.Settings, cell.Store, TimeProvider.System).Slots[0];

    private static string Hash(byte[] bytes) => Convert.ToHexStringLower(System.Security.Cryptography.SHA256.HashData(bytes));

    private static string Measurement(int number) => File.ReadAllText(
        Testing.Repository.PathTo("samples", "slot-mating", "part.csv")).Replace(
        "1,12.0000,-10.0377", string.Create(CultureInfo.InvariantCulture, $"1,12.0000,-10.0{377 + number}"), StringComparison.Ordinal);

    private MachineSettings Machine(StateSettings state) => CellSettingsReader.Parse(
        Encoding.UTF8.GetBytes(
            $$"""
            { "kind": "cell", "name": "Test cell", "store": { "kind": "sqlite" },
              "gauges": [{ "name": "cmm", "incoming": "in", "files": "*.csv" }],
              "machines": [{ "name": "mill", "dialect": "delta-nc300", "transport": { "kind": "folder", "folder": "{{control.Nc}}" },
                "slots": [{ "name": "A", "program": "A.NGC" }] }],
              "jobs": [{ "name": "slot", "job": "{{Testing.Repository.PathTo("samples", "slot-mating", "job.json")}}", "gauges": ["cmm"],
                "recognize": { "fileName": "x" }, "machine": "mill", "slot": "A" }] }
            """),
        // A folder of its own: everybody may write the control's.
        Path.Combine(Directory.CreateDirectory(Path.Combine(control.Home, "cell")).FullName, "cell.json")).Machines[0] with
    {
        State = state
    };

    private async Task<ConfiguredCell> StartAsync()
    {
        var cell = new ConfiguredCell($$"""
            "gauges": [{ "name": "cmm", "incoming": "incoming", "files": "*.csv", "format": "points", "finished": "rename", "everyMs": 20 }],
            "machines": [{
              "name": "mill", "dialect": "linuxcnc", "transport": { "kind": "folder", "folder": "{{control.Nc}}" },
              "state": { "kind": "linuxcnc", "host": "127.0.0.1", "port": {{control.Port}} },
              "slots": [{ "name": "A", "program": "{{Program}}" }] }],
            "jobs": [{
              "name": "slot", "job": "job/job.json", "gauges": ["cmm"], "machine": "mill", "slot": "A",
              "recognize": { "fileName": "^(?<serial>S[0-9]+)[.]csv$" } }],
            "policy": { "approve": "automatic" }
            """);
        await SlotJob.LayOutAsync(cell.PathOf("job"));
        cell.Start();
        return cell;
    }
}
