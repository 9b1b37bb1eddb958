using System.Diagnostics;
using System.Text;
using System.Text.Json;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A cell in a temporary folder, run by the built console:
/// incoming files, slots with ready files, and ways to end the process.</summary>
internal sealed class FireCell : IDisposable
{
    private readonly StringBuilder _said = new();
    private Process? _process;
    private volatile bool _hasBegun;

    /// <summary>Lays out a cell.</summary>
    /// <param name="slots">How many slots it has; jobs are told by the slot in the file's name.</param>
    /// <param name="store">The store's part of the configuration.</param>
    /// <param name="transport">The machine's transport; null for a folder.</param>
    /// <param name="machine">The folder in which the machine's files lie as the machine itself sees it; null for one of the cell's.</param>
    /// <param name="name">The cell's name.</param>
    /// <param name="keys">Folder of the keys, which the cells of one store share.</param>
    public FireCell(
        int slots,
        string store = """{ "kind": "sqlite", "file": "store/cell.db" }""",
        string? transport = null,
        string? machine = null,
        string name = "Under fire",
        string keys = "keys")
    {
        Slots = [.. Enumerable.Range(0, slots).Select(i => $"S{i:00}")];
        Machine = machine ?? this["machine"];
        Directory.CreateDirectory(Machine);
        Directory.CreateDirectory(Incoming);
        Directory.CreateDirectory(this["store"]);
        Directory.CreateDirectory(this["job"]);
        foreach (var file in Directory.EnumerateFiles(Repository.PathTo("samples", "complex-mating")))
        {
            File.Copy(file, Path.Combine(this["job"], Path.GetFileName(file)));
        }

        File.WriteAllBytes(this["job", "counterpart.nc"], FireFiles.Original);
        foreach (var slot in Slots)
        {
            File.Copy(this["job", "counterpart.nc"], Path.Combine(Machine, ProgramOf(slot)), overwrite: true);
        }

        Configuration = this["cell.json"];
        File.WriteAllText(Configuration, $$"""
            {
              "kind": "cell", "name": "{{name}}",
              "store": {{store}}, "keys": "{{keys}}",
              "gauges": [{ "name": "cmm", "incoming": "incoming", "files": "*.csv", "finished": "rename", "everyMs": 50, "mostMB": 16 }],
              "machines": [{
                "name": "vmc", "dialect": "delta-nc300", "transport": {{transport ?? """{ "kind": "folder", "folder": "machine" }"""}},
                "slots": [{{string.Join(", ", Slots.Select(s => $$"""{ "name": "{{s}}", "program": "{{ProgramOf(s)}}", "readyFile": "{{s}}.READY" }"""))}}],
              }],
              "jobs": [{{string.Join(", ", Slots.Select(s => $$"""{ "name": "job-{{s}}", "job": "job/job.json", "gauges": ["cmm"], "recognize": { "fileName": "^{{s}}_(?<serial>[0-9]+)\\.csv$" }, "machine": "vmc", "slot": "{{s}}" }"""))}}],
              "policy": { "approve": "automatic", "limitMm": 1.0 },
            }
            """);
    }

    /// <summary>The cell's configuration.</summary>
    public string Configuration { get; }

    /// <summary>How the console is started, by its arguments; null for the one that is built beside the tests.</summary>
    public Func<string[], ProcessStartInfo>? Launch { get; init; }

    /// <summary>False where a process cannot be told to end: then it is killed for that, too.</summary>
    public bool EndsInOrder { get; init; } = true;

    /// <summary>The slots' names.</summary>
    public IReadOnlyList<string> Slots { get; }

    /// <summary>The cell's folder.</summary>
    public string Folder { get; } = Directory.CreateTempSubdirectory("errormatch-fire-").FullName;

    /// <summary>The machine's folder.</summary>
    public string Machine { get; }

    /// <summary>The gauge's folder.</summary>
    public string Incoming => this["incoming"];

    /// <summary>What the process said on its error stream, all of them together.</summary>
    public string Said
    {
        get
        {
            lock (_said)
            {
                return _said.ToString();
            }
        }
    }

    public string this[params string[] parts] => Path.Combine([Folder, .. parts]);

    /// <summary>The program's name in a slot.</summary>
    public static string ProgramOf(string slot) => $"O{slot}.NC";

    /// <summary>Adds a key to the configuration.</summary>
    /// <param name="key">The key and its value, as JSON.</param>
    public void Configure(string key)
    {
        var text = File.ReadAllText(Configuration);
        File.WriteAllText(Configuration, text[..text.LastIndexOf('}')] + $"  {key},\n}}\n");
    }

    /// <summary>Lets a finished file appear as a gauge does: written under another name, then renamed.</summary>
    public void Drop(string name, ReadOnlySpan<byte> bytes)
    {
        var beside = this["beside-" + Guid.NewGuid().ToString("N")];
        File.WriteAllBytes(beside, bytes);
        File.Move(beside, Path.Combine(Incoming, name));
    }

    /// <summary>Starts the cell.</summary>
    /// <param name="variables">Further variables of its environment.</param>
    public Process Start(params IEnumerable<(string Name, string Value)> variables)
    {
        _hasBegun = false;
        var start = Of("cell", "run", Configuration);
        start.UseShellExecute = false;
        start.RedirectStandardInput = start.RedirectStandardOutput = start.RedirectStandardError = true;
        foreach (var (name, value) in variables)
        {
            start.Environment[name] = value;
        }

        var process = Process.Start(start)!;
        process.StandardInput.Close();
        process.ErrorDataReceived += (_, line) => Heard(line.Data);
        process.OutputDataReceived += (_, line) => Heard(line.Data);
        process.BeginErrorReadLine();
        process.BeginOutputReadLine();
        return _process = process;
    }

    /// <summary>Ends the process at once.</summary>
    /// <param name="withTools">True as a power cut does, with the programs that it runs; false as somebody does who kills it alone.</param>
    public async Task Kill(bool withTools = true)
    {
        _process!.Kill(withTools);
        await _process.WaitForExitAsync(TestContext.Current.CancellationToken);
    }

    /// <summary>Ends the process as a service manager does, which must not take long.</summary>
    public async Task Stop(TimeSpan? atMost = null)
    {
        if (!EndsInOrder)
        {
            await Kill();
            return;
        }

        var exit = await FireStop.Of(_process!, atMost);
        Assert.True(exit is 0 or 130, $"Exit {exit}. {Tail()}");
    }

    /// <summary>Waits until the process that was started says that it runs.</summary>
    public Task HasBegun() => Until(() => Task.FromResult(_hasBegun), TimeSpan.FromMinutes(3), "the cell runs");

    /// <summary>All corrections, as the console tells them.</summary>
    public async Task<IReadOnlyList<JsonElement>> History()
    {
        var run = await ConsoleRun.Of(Of("cell", "history", Configuration, "--most", "100000", "--json"));
        Assert.True(run.Exit == 0, run.Output + run.Error);
        return [.. run.Json.GetProperty("corrections").EnumerateArray()];
    }

    /// <summary>Fails unless the audit trail is whole.</summary>
    public async Task AuditHolds()
    {
        var run = await ConsoleRun.Of(Of("audit", "verify", Configuration));
        Assert.True(run.Exit == 0, run.Output + run.Error);
    }

    /// <summary>Waits until something is so.</summary>
    public async Task Until(Func<Task<bool>> isSo, TimeSpan atMost, string what)
    {
        var clock = Stopwatch.StartNew();
        while (!await isSo())
        {
            Assert.True(
                clock.Elapsed < atMost,
                $"{what}: not after {atMost}. Left: {string.Join(", ", Directory.EnumerateFiles(Incoming).Select(Path.GetFileName))}. "
                    + $"{Tail()}");
            await Task.Delay(100, TestContext.Current.CancellationToken);
        }
    }

    public void Dispose()
    {
        if (_process is { HasExited: false })
        {
            _process.Kill(entireProcessTree: true);
            _process.WaitForExit();
        }

        _process?.Dispose();
        Directory.Delete(Folder, recursive: true);
    }

    private ProcessStartInfo Of(params string[] arguments)
    {
        var start = Launch?.Invoke(arguments) ?? new(ConsoleRun.Executable, arguments);
        start.WorkingDirectory = Folder;
        return start;
    }

    private string Tail()
    {
        var said = Said;
        return said.Length > 4000 ? said[^4000..] : said;
    }

    private void Heard(string? line)
    {
        if (line is not null)
        {
            _hasBegun |= line.Contains(" runs: ", StringComparison.Ordinal);
            lock (_said)
            {
                _said.AppendLine(line);
            }
        }
    }
}
