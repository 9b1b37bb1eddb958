using System.Text;
using ErrorMatching.Testing;
using Serilog.Core;

namespace ErrorMatching.Cell.Tests;

/// <summary>A cell in this process with a configuration that a test writes:
/// a store in a file, runners that are started, stopped and killed.</summary>
internal sealed class ConfiguredCell : IAsyncDisposable
{
    private static readonly byte[] Key = [.. Enumerable.Range(1, 32).Select(i => (byte)i)];
    private readonly List<CellStore> _stores = [];
    private readonly List<(CancellationTokenSource Stop, Task Run)> _runs = [];
    private int _drops;

    /// <summary>A cell that is not started, with a folder <c>incoming</c>.</summary>
    /// <param name="configuration">Its configuration but for kind, name, store, keys and logs.</param>
    public ConfiguredCell(string configuration)
    {
        Configuration = configuration;
        Directory.CreateDirectory(PathOf("incoming"));
        Directory.CreateDirectory(PathOf("m1"));
    }

    public string Folder { get; } = Directory.CreateTempSubdirectory("errormatch-cells-").FullName;

    public string Configuration { get; set; }

    /// <summary>Opens a machine's folder.</summary>
    public Func<MachineSettings, IMachineFolder> Opens { get; set; } = m => MachineFolders.Open(m, () => null);

    public Action<CorrectionState, bool>? AroundStep { get; set; }

    public CellStore Store => _stores.Count > 0 ? _stores[0] : Open();

    public CellSettings Settings => CellSettingsReader.Parse(
        Encoding.UTF8.GetBytes(
            $$"""{ "kind": "cell", "name": "Test cell", "store": { "kind": "sqlite", "file": "cell.db" }, "keys": "keys", "logs": "logs", {{Configuration}} }"""),
        PathOf("cell.json"));

    /// <summary>What keeps the running cell from working, as its last sign of life says.</summary>
    public IReadOnlyList<CellTrouble> Troubles => Heartbeat.Read(PathOf("logs"))?.Troubles ?? [];

    public string PathOf(string name) => Path.Combine(Folder, name);

    /// <summary>Copies a sample's files into a folder of the cell.</summary>
    public void Copy(string sample, string to)
    {
        Directory.CreateDirectory(PathOf(to));
        foreach (var file in Directory.EnumerateFiles(Repository.PathTo("samples", sample)))
        {
            File.Copy(file, Path.Combine(PathOf(to), Path.GetFileName(file)));
        }
    }

    /// <summary>Changes a text that a file has once.</summary>
    public void Change(string file, string old, string text)
    {
        var before = File.ReadAllText(PathOf(file));
        Assert.Equal(2, before.Split(old).Length);
        File.WriteAllText(PathOf(file), before.Replace(old, text, StringComparison.Ordinal));
    }

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
        _ = Store;
        var stop = new CancellationTokenSource();
        var runner = new CellRunner(Settings, Open(), Opens, TimeProvider.System, Logger.None) { Pace = Pace, AroundStep = AroundStep };
        _runs.Add((stop, Task.Run(() => runner.RunAsync(stop.Token))));
    }

    /// <summary>Stops all runners in order.</summary>
    public async Task StopAsync()
    {
        foreach (var (stop, run) in _runs)
        {
            await stop.CancelAsync();
            await run.WaitAsync(TimeSpan.FromMinutes(1));
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
            await Task.WhenAny(run, Task.Delay(TimeSpan.FromMinutes(1)));
            Assert.True(run.IsCompleted);
            stop.Dispose();
        }

        _runs.Clear();
    }

    /// <summary>Lets a finished file appear in the incoming folder.</summary>
    public void Drop(string name, string text)
    {
        var written = PathOf($"written-{Interlocked.Increment(ref _drops)}");
        File.WriteAllText(written, text);
        File.Move(written, PathOf("incoming/" + name));
    }

    /// <summary>Waits until something holds.</summary>
    public static async Task Until(Func<bool> holds, Func<string>? otherwise = null)
    {
        for (var i = 0; i < 12_000; i++)
        {
            if (holds())
            {
                return;
            }

            await Task.Delay(10, TestContext.Current.CancellationToken);
        }

        Assert.Fail("It did not come about within two minutes. " + otherwise?.Invoke());
    }

    /// <summary>Waits until a correction is in a state; one that has come to another end never is.</summary>
    public async Task<Correction> Until(long id, CorrectionState state)
    {
        Correction? found = null;
        await Until(
            () => (found = Store.Find(id)) is { } c && (c.State == state || CorrectionSteps.IsEnd(c.State)),
            () => $"Correction {id}: {Store.Find(id)}; {string.Join("; ", Troubles)}");
        Assert.True(found!.State == state, $"{state} expected: {found}");
        return found;
    }

    public async ValueTask DisposeAsync()
    {
        await BuryAsync();
        foreach (var store in _stores)
        {
            store.Dispose();
        }

        Directory.Delete(Folder, recursive: true);
    }

    private static FlowPace Pace => new()
    {
        Idle = TimeSpan.FromMilliseconds(200),
        Store = TimeSpan.FromMilliseconds(20),
        Ready = TimeSpan.FromMilliseconds(20),
        Locked = TimeSpan.FromMilliseconds(10),
        Pause = TimeSpan.FromMilliseconds(30),
        LongestPause = TimeSpan.FromMilliseconds(60),
        Finish = TimeSpan.FromSeconds(20),
        GiveBack = TimeSpan.FromSeconds(10),
        Heartbeat = TimeSpan.FromMilliseconds(50),
    };
}
