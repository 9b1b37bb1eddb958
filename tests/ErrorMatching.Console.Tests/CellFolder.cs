using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

/// <summary>A cell of its own for each test, with the paper's mating job, and people who type.</summary>
internal sealed class CellFolder : IDisposable
{
    public const string Annas = "correct horse battery";
    public const string Bens = "staple of the ox";

    private const string Configuration = """
        {
          "kind": "cell", "name": "Cell 1", "store": { "kind": "sqlite", "file": "cell.db" }, "keys": "keys", "logs": "logs",
          "gauges": [{ "name": "cmm", "incoming": "incoming", "files": "*.csv", "format": "points", "finished": "rename" }],
          "machines": [{ "name": "vmc1", "dialect": "delta-nc300", "transport": { "kind": "folder", "folder": "machine" }, "slots": [{ "name": "A", "program": "O0211.NC" }] }],
          "jobs": [{ "name": "housing", "job": "JOB", "gauges": ["cmm"], "recognize": { "fileName": "^(?<serial>[A-Z0-9]+)\\.csv$" }, "machine": "vmc1", "slot": "A" }],
          "policy": { "approve": "person" }
        }
        """;

    private readonly TemporaryFolder _folder = new();

    public CellFolder()
    {
        // A copy: a cell refuses what everybody may write, as a clone under another umask may be.
        Directory.CreateDirectory(_folder["job"]);
        foreach (var file in Directory.EnumerateFiles(Repository.PathTo("samples", "complex-mating")))
            File.Copy(file, Path.Combine(_folder["job"], Path.GetFileName(file)));
        Config = _folder.File("cell.json", Configuration.Replace("JOB", "job/job.json", StringComparison.Ordinal));
        Directory.CreateDirectory(_folder["incoming"]);
        Directory.CreateDirectory(_folder["machine"]);
    }

    public string Config { get; }

    public string this[string name] => _folder[name];

    /// <summary>A cell with Anna, an administrator, and Ben, an operator.</summary>
    public static CellFolder WithPeople()
    {
        var cell = new CellFolder();
        Assert.Equal(0, cell.Piped([Annas], "user", "add", cell.Config, "Anna", "--role", "administrator").Exit);
        Assert.Equal(0, cell.Piped([Annas, Bens], "user", "add", cell.Config, "Ben", "--role", "operator", "--user", "anna").Exit);
        return cell;
    }

    /// <summary>Runs a verb with passwords in the lines of standard input.</summary>
    public (int Exit, string Output, string Error) Piped(IEnumerable<string> lines, params IEnumerable<string> args)
    {
        using var input = new StringReader(string.Concat(lines.Select(l => l + "\n")));
        return Shell.Run(new SecretInput(input, null, TextWriter.Null), [.. args, "--password-stdin"]);
    }

    /// <summary>Runs a verb with passwords typed at a keyboard.</summary>
    /// <returns>With what the terminal shows meanwhile.</returns>
    public (int Exit, string Output, string Error, string Shown) Typed(string keys, params IReadOnlyList<string> args)
    {
        using var shown = new StringWriter();
        var (exit, output, error) = Shell.Run(new SecretInput(TextReader.Null, Keyboard(keys), shown), args);
        return (exit, output, error, shown.ToString());
    }

    public void Dispose() => _folder.Dispose();

    internal static Func<ConsoleKeyInfo> Keyboard(string keys)
    {
        var at = 0;
        return () => keys[at++] switch
        {
            '\n' => new('\r', ConsoleKey.Enter, false, false, false),
            '\b' => new('\b', ConsoleKey.Backspace, false, false, false),
            var c => new(c, ConsoleKey.None, false, false, false),
        };
    }
}
