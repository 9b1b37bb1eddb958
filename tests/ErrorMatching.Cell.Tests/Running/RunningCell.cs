using System.Collections.Concurrent;
using System.Diagnostics;
using System.Globalization;
using System.Security.Cryptography;
using System.Text;
using ErrorMatching.Testing;
using Serilog.Core;

namespace ErrorMatching.Cell.Tests;

/// <summary>A cell in this process: the paper's mating job, machines in memory, a store in a file, runners that are started,
/// stopped and killed.</summary>
internal sealed class RunningCell : IAsyncDisposable
{
    public const string Program = "P1.NC";
    private const string Machines = """
        { "name": "m1", "dialect": "delta-nc300", "transport": { "kind": "folder", "folder": "m1" }, "attempts": 1, "slots": [{ "name": "A", "program": "P1.NC" }, { "name": "B", "program": "P2.NC", "readyFile": "B.READY" }] },
        { "name": "m2", "dialect": "delta-nc300", "transport": { "kind": "folder", "folder": "m2" }, "attempts": 1, "slots": [{ "name": "A", "program": "P3.NC" }] }
        """;

    // So long nothing takes on any machine: what has not come about by then does not come about.
    private static readonly TimeSpan Forever = TimeSpan.FromMinutes(2);

    private readonly ConcurrentDictionary<string, int> _looks = new(StringComparer.Ordinal);
    private readonly List<CellStore> _stores = [];
    private readonly List<(CancellationTokenSource Stop, Task Run)> _runs = [];
    private int _drops;

    /// <summary>A cell that is not started.</summary>
    /// <param name="policy">The cell's policy.</param>
    /// <param name="order">The order of the job <c>a</c>.</param>
    public RunningCell(string policy = """{ "approve": "automatic" }""", string order = "arrival")
    {
        Copy(Repository.PathTo("samples", "complex-mating"), PathOf("job"));
        var feedback = File.ReadAllText(PathOf("job/job.json")).Replace(
            "\"from\": \"part\"", "\"from\": \"counterpart\"", StringComparison.Ordinal);
        File.WriteAllText(PathOf("job/feedback.json"), feedback);

        // Two slots of one machine have programs of two numbers.
        File.WriteAllText(
            PathOf("job/b.json"),
            File.ReadAllText(PathOf("job/job.json")).Replace("\"counterpart.nc\"", "\"counterpart-b.nc\"", StringComparison.Ordinal));
        File.WriteAllText(
            PathOf("job/counterpart-b.nc"),
            File.ReadAllText(PathOf("job/counterpart.nc")).Replace("O0211", "O0212", StringComparison.Ordinal));
        foreach (var folder in new[] { "incoming", "m1", "m2" })
        {
            Directory.CreateDirectory(PathOf(folder));
        }

        Policy = policy;
        Order = order;
        foreach (var name in new[] { "m1", "m2" })
        {
            Machine[name] = new(name);
        }
    }

    /// <summary>Seals the audit trail and codes rows.</summary>
    public static byte[] Key { get; } = [.. Enumerable.Range(1, 32).Select(i => (byte)i)];

    public string Folder { get; } = Directory.CreateTempSubdirectory("errormatch-run-").FullName;

    public string Policy { get; set; }

    public string Order { get; set; }

    public Dictionary<string, MemoryMachine> Machine { get; } = [];

    public FlowPace Pace { get; set; } = new()
    {
        Idle = TimeSpan.FromMilliseconds(200),
        Store = TimeSpan.FromMilliseconds(20),
        Ready = TimeSpan.FromMilliseconds(20),

        // Tests count listings; those of who asks whether a machine answers would be among them.
        Answer = TimeSpan.FromDays(1),
        Locked = TimeSpan.FromMilliseconds(10),
        Pause = TimeSpan.FromMilliseconds(30),
        LongestPause = TimeSpan.FromMilliseconds(60),
        Finish = Forever,
        GiveBack = Forever,
        Heartbeat = TimeSpan.FromMilliseconds(100),
    };

    public Action<CorrectionState, bool>? AroundStep { get; set; }

    public CellStore Store => _stores.Count > 0 ? _stores[0] : Open();

    /// <summary>How machine m1 is asked what it is doing; null if nothing says that.</summary>
    public StateSettings? State { get; set; }

    /// <summary>The file of the slot A of machine m1.</summary>
    public string SlotFile { get; set; } = Program;

    public CellSettings Settings
    {
        get
        {
            var parsed = Parsed;
            return parsed with { Machines = [.. parsed.Machines.Select(m => m.Name == "m1" ? m with { State = State } : m)] };
        }
    }

    private CellSettings Parsed => CellSettingsReader.Parse(Encoding.UTF8.GetBytes($$"""
        {
          "kind": "cell", "name": "Test cell", "store": { "kind": "sqlite", "file": "cell.db" }, "keys": "keys", "logs": "logs",
          "gauges": [{ "name": "cmm", "incoming": "incoming", "files": "*.csv", "format": "points", "finished": "rename", "everyMs": 20 }],
          "machines": [{{Machines.Replace(Program, SlotFile, StringComparison.Ordinal)}}],
          "jobs": [
            { "name": "a", "job": "job/job.json", "gauges": ["cmm"], "recognize": { "fileName": "^a_(?<serial>[A-Z0-9-]+)(_.*)?\\.csv$" }, "machine": "m1", "slot": "A", "order": "{{Order}}" },
            { "name": "b", "job": "job/b.json", "gauges": ["cmm"], "recognize": { "fileName": "^b_(?<serial>[A-Z0-9-]+)(_(?<workOrder>WO[0-9]+))?(_.*)?\\.csv$" }, "machine": "m1", "slot": "B" },
            { "name": "c", "job": "job/job.json", "gauges": ["cmm"], "recognize": { "fileName": "^c_(?<serial>[A-Z0-9-]+)(_.*)?\\.csv$" }, "machine": "m2", "slot": "A" },
            { "name": "part", "job": "job/job.json", "gauges": ["cmm"], "recognize": { "fileName": "^first-article" }, "piece": "counterpart", "machine": "m2", "slot": "A" }
          ],
          "policy": {{Policy}}
        }
        """), PathOf("cell.json"));

    public string PathOf(string name) => Path.Combine(Folder, name);

    /// <summary>Another view of the store, as another process has it.</summary>
    public CellStore Open()
    {
        var store = CellStore.Open(new SqliteSettings(PathOf("cell.db")), TimeProvider.System, Key);
        _stores.Add(store);
        if (_stores.Count == 1) new UserBook(store, TimeProvider.System, new PasswordHashes(10)).AddFirst("sam", "correct horse battery");
        return store;
    }

    /// <summary>Starts a runner with a view of the store of its own.</summary>
    public void Start()
    {
        var stop = new CancellationTokenSource();
        var runner = new CellRunner(Settings, Open(), m => Machine[m.Name], TimeProvider.System, Logger.None)
        {
            Pace = Pace,
            AroundStep = AroundStep,
            Looking = where => _looks.AddOrUpdate(where, 1, (_, looks) => looks + 1),
        };
        _runs.Add((stop, Task.Run(() => runner.RunAsync(stop.Token))));
    }

    /// <summary>Stops all runners in order.</summary>
    public async Task StopAsync()
    {
        foreach (var (stop, run) in _runs)
        {
            await stop.CancelAsync();
            await run.WaitAsync(4 * Forever);
            stop.Dispose();
        }

        _runs.Clear();
    }

    /// <summary>Waits for the end of runners that a test has killed, whatever they say.</summary>
    public async Task BuryAsync()
    {
        foreach (var (stop, run) in _runs)
        {
            await stop.CancelAsync();
            await Task.WhenAny(run, Task.Delay(4 * Forever));
            Assert.True(run.IsCompleted);
            stop.Dispose();
        }

        _runs.Clear();
    }

    /// <summary>Puts a measurement of the part into the incoming folder.
    /// Each number gives another one, by some tenths of a micrometer.</summary>
    public void Drop(string name, int number) => DropText(name, Measurement(number));

    public void DropText(string name, string text)
    {
        var written = PathOf($"written-{Interlocked.Increment(ref _drops)}");
        File.WriteAllText(written, text);
        File.Move(written, PathOf("incoming/" + name));
    }

    public static string Measurement(int number)
    {
        var text = File.ReadAllText(Repository.PathTo("samples", "complex-mating", "part.csv"));
        var x = (-32.067 - (0.0001 * number)).ToString("0.0000", CultureInfo.InvariantCulture);
        Assert.Contains("1,-32.067,", text, StringComparison.Ordinal);
        return text.Replace("1,-32.067,", $"1,{x},", StringComparison.Ordinal);
    }

    /// <summary>Waits until something holds.</summary>
    public static async Task Until(Func<bool> holds, Func<string>? otherwise = null)
    {
        var began = Stopwatch.GetTimestamp();
        while (!holds())
        {
            Assert.True(Stopwatch.GetElapsedTime(began) < Forever, $"It did not come about within {Forever}. {otherwise?.Invoke()}");
            await Task.Delay(10);
        }
    }

    /// <summary>Waits until a correction is in a state.</summary>
    public async Task<Correction> Until(long id, CorrectionState state)
    {
        await Until(() => Store.Find(id)?.State == state, () => $"Correction {id}: {Store.Find(id)}");
        return Store.Find(id)!;
    }

    /// <summary>Waits until some workers have looked once more for work, and ended that look:
    /// what they have not done by then, they do not do.</summary>
    /// <param name="workers">Their names, such as <c>slot m1/A</c>.</param>
    public async Task UntilLookedAgain(params string[] workers)
    {
        foreach (var worker in workers)
        {
            // The next look begins after this, and has ended when the one behind it begins.
            var before = _looks.GetValueOrDefault(worker);
            await Until(() => _looks.GetValueOrDefault(worker) >= before + 2, () => $"{worker} does not look.");
        }
    }

    /// <summary>Waits until a machine was asked once more what lies there, and whoever asked has done what follows from it.</summary>
    public async Task UntilListedAgain(string machine)
    {
        var before = Listings();
        await Until(() => Listings() >= before + 2, () => $"{machine} is not listed.");

        int Listings() => Machine[machine].Done.Count(d => d == "list");
    }

    /// <summary>The states that a correction went through.</summary>
    public IEnumerable<CorrectionState> Way(long id) => Store.Corrections.StepsOf(id).Select(s => s.To);

    public static string Hash(byte[] bytes) => Convert.ToHexStringLower(SHA256.HashData(bytes));

    public string OriginalHash => Hash(File.ReadAllBytes(PathOf("job/counterpart.nc")));

    public async ValueTask DisposeAsync()
    {
        await BuryAsync();
        foreach (var store in _stores)
        {
            store.Dispose();
        }

        Directory.Delete(Folder, recursive: true);
        Assert.All(Machine.Values, m => Assert.Null(m.Broken));
    }

    private static void Copy(string from, string to)
    {
        Directory.CreateDirectory(to);
        foreach (var file in Directory.EnumerateFiles(from))
        {
            File.Copy(file, Path.Combine(to, Path.GetFileName(file)));
        }
    }
}
