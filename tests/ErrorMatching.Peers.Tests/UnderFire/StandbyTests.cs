using System.Diagnostics;
using System.Globalization;
using ErrorMatching.EndToEnd.Tests;

namespace ErrorMatching.Peers.Tests;

/// <summary>Two processes of one cell, with a schema of its own on a PostgreSQL server: when the one that runs is killed or frozen, in the
/// middle of whatever it does, the other goes on within ten seconds, and the machine gets every program once.</summary>
/// <remarks>Every other round freezes a process, which goes on later. <c>ERRORMATCH_ROUNDS=20</c> does twenty rounds instead of
/// two.</remarks>
[Collection(PostgresTests.Name)]
public sealed class StandbyTests(PostgresServer server)
{
    private static readonly TimeSpan Takeover = TimeSpan.FromSeconds(10);
    private static readonly TimeSpan Long = TimeSpan.FromMinutes(2);
    private readonly List<Process> _processes = [];

    [Fact]
    public async Task A_standby_goes_on_within_ten_seconds_and_every_program_is_sent_once()
    {
        PostgresServer.IsNeeded();
        var rounds = int.Parse(Environment.GetEnvironmentVariable("ERRORMATCH_ROUNDS") ?? "2", CultureInfo.InvariantCulture);
        var token = TestContext.Current.CancellationToken;
        var settings = server.NewDatabase();
        using var cell = new FireCell(slots: 3, server.StoreOf(settings, "line_1"));
        var files = new FireFiles();
        await using var machine = new FireMachine(cell, () => files.FileByProgram);
        var (random, dropped, taken) = (new Random(29), new List<string>(), new List<TimeSpan>());
        try
        {
            var owner = Start(cell);
            await Until(owner, " runs: ");
            for (var round = 0; round < rounds; round++)
            {
                var standby = Start(cell, "--standby");
                await Until(standby, " stands by");
                for (var i = 0; i < 9; i++)
                {
                    var (name, bytes) = files.Next(cell.Slots[i % 3], dropped.Count);
                    dropped.Add(name);
                    cell.Drop(name, bytes);
                }

                await Task.Delay(random.Next(100, 1200), token);
                var isFrozen = round % 2 == 1;
                Signal(owner.Process, isFrozen ? "STOP" : "KILL");
                var since = Stopwatch.StartNew();
                await Until(standby, " runs: ");
                taken.Add(since.Elapsed);
                if (isFrozen)
                {
                    // It goes on in the middle of what the other one does.
                    Signal(owner.Process, "CONT");
                    await owner.Process.WaitForExitAsync(token).WaitAsync(Long, token);
                    Assert.Contains("another one took the cell over", owner.Said(), StringComparison.Ordinal);
                }

                await cell.Until(() => Task.FromResult(machine.Cut.Count >= dropped.Count), Long, "all cut");
                owner = standby;
            }

            await cell.Until(
                async () => (await cell.History()).Count(c => c.GetProperty("state").GetString() == "released") == dropped.Count,
                Long,
                "all released");
        }
        finally
        {
            foreach (var process in _processes)
            {
                process.Kill(entireProcessTree: true);
                process.WaitForExit();
                process.Dispose();
            }
        }

        TestContext.Current.TestOutputHelper?.WriteLine(string.Join(", ", taken.Select(t => $"{t.TotalSeconds:0.0}")));
        Assert.All(taken, t => Assert.InRange(t, TimeSpan.Zero, Takeover));
        Assert.Empty(machine.Wrong);
        Assert.Equal(dropped.Order(StringComparer.Ordinal), machine.Cut.Select(c => c.File).Order(StringComparer.Ordinal));
        await cell.AuditHolds();
    }

    private (Process Process, Func<string> Said) Start(FireCell cell, params string[] words)
    {
        var start = new ProcessStartInfo(ConsoleRun.Executable, ["cell", "run", cell.Configuration, .. words])
        {
            UseShellExecute = false,
            WorkingDirectory = cell.Folder,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        var (said, process) = (new List<string>(), Process.Start(start)!);
        _processes.Add(process);
        process.OutputDataReceived += (_, line) => Hear(line.Data);
        process.ErrorDataReceived += (_, line) => Hear(line.Data);
        process.BeginOutputReadLine();
        process.BeginErrorReadLine();
        return (process, Said);

        string Said()
        {
            lock (said) return string.Join('\n', said);
        }

        void Hear(string? line)
        {
            lock (said) said.Add(line ?? "");
        }
    }

    private static async Task Until((Process Process, Func<string> Said) cell, string words)
    {
        for (var since = Stopwatch.StartNew(); !cell.Said().Contains(words, StringComparison.Ordinal);)
        {
            Assert.True(since.Elapsed < Long && !cell.Process.HasExited, $"It does not say \"{words}\" but: {cell.Said()}");
            await Task.Delay(20, TestContext.Current.CancellationToken);
        }
    }

    private static void Signal(Process process, string signal)
    {
        using var kill = Process.Start("kill", ["-" + signal, process.Id.ToString(CultureInfo.InvariantCulture)]);
        kill.WaitForExit();
        Assert.Equal(0, kill.ExitCode);
    }
}
