using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

/// <summary>The examples in the help of a cell's verbs run on the sample, in the order in which people would type them.</summary>
public sealed class CellExampleTests : IDisposable
{
    private const string Password = "four words of nobody";
    private readonly TemporaryFolder _folder = new();
    private readonly HashSet<string> _ran = [];

    public CellExampleTests()
    {
        foreach (var file in new[] { "complex-mating", "cell" }.SelectMany(s => Directory.EnumerateFiles(Repository.PathTo("samples", s))))
        {
            var copy = Placed(Path.GetRelativePath(Repository.Root, file));
            Directory.CreateDirectory(Path.GetDirectoryName(copy)!);
            File.Copy(file, copy);
        }

        File.WriteAllText(Config, File.ReadAllText(Config).Replace("\"automatic\"", "\"person\"", StringComparison.Ordinal));
        Directory.CreateDirectory(Placed("samples/cell/incoming"));
        Directory.CreateDirectory(Placed("samples/cell/machine"));
        File.Copy(Placed("samples/complex-mating/counterpart.nc"), Placed("samples/cell/machine/counterpart.nc"));
    }

    private string Config => Placed("samples/cell/cell.json");

    [Fact]
    public async Task They_run_one_after_another()
    {
        Example("user add");
        Example("user add", e => e.Replace("anna --role administrator", "ben --role setter --user anna", StringComparison.Ordinal));
        using (var running = await BackgroundCell.Start(Config))
        {
            _ran.Add("cell run");
            Drop("part-0001.csv", "-32.067");
            await Until(1, "proposed");
            Example("cell status");
            Example("cell alarms");
            Example("cell approve");
            await Until(1, "verified");
            Example("cell release");
            Example("cell history");
            Example("cell show");
            Example("cell revert");
            Drop("part-0002.csv", "-32.068");
            await Until(2, "proposed");
            ChangeJob();
            Example("cell again");
            await Until(3, "proposed");
            Example("cell reject", e => e.Replace("cell.json 1 ", "cell.json 3 ", StringComparison.Ordinal));
            Example("cell backup");
            Example("cell thin");
            Example("cell secret");
        }

        Example("cell restore");
        foreach (var words in new[]
        {
            "cell check",
            "user list",
            "user disable",
            "user enable",
            "user role",
            "user password",
            "user badge",
            "audit verify",
            "audit export",
            "audit take-over"
        })
        {
            Example(words);
        }

        Example("user pin", secret: "502817");
        Assert.Equal(Verbs().Keys.Order(), _ran.Order());
    }

    public void Dispose() => _folder.Dispose();

    private void Example(string words, Func<string, string>? changed = null, string secret = Password)
    {
        if (!Verbs().TryGetValue(words, out var verb))
        {
            return;
        }

        _ran.Add(words);
        string[] args = [
            .. (changed?.Invoke(verb.Example) ?? verb.Example).Split(' ')[1..].Select(
                w => w.StartsWith("samples/", StringComparison.Ordinal) || w.StartsWith("out", StringComparison.Ordinal) ? Placed(w) : w)];
        using var passwords = new StringReader($"{Password}\n{secret}\n{secret}\n");
        var run = Shell.Run(new SecretInput(passwords, null, TextWriter.Null), verb is SigningVerb ? [.. args, "--password-stdin"] : args);
        Assert.True(run.Exit == 0, $"{verb.Example} ended with {run.Exit}: {run.Output}{run.Error}");
    }

    private static Dictionary<string, Verb> Verbs() =>
        CommandTree.Build().Subcommands
            .SelectMany(g => g.Subcommands.OfType<CellVerb>().Select(v => (Words: $"{g.Name} {v.Name}", Verb: (Verb)v)))
            .ToDictionary(v => v.Words, v => v.Verb);

    private void Drop(string name, string x)
    {
        Directory.CreateDirectory(Placed("out"));
        File.WriteAllText(
            Placed("written"), File.ReadAllText(Placed("samples/complex-mating/part.csv")).Replace("-32.067", x, StringComparison.Ordinal));
        File.Move(Placed("written"), Placed("samples/cell/incoming/" + name));
    }

    private void ChangeJob()
    {
        var theoretical = Placed("samples/complex-mating/theoretical.csv");
        File.WriteAllText(theoretical, File.ReadAllText(theoretical).Replace("-31.950", "-31.951", StringComparison.Ordinal));
    }

    private Task Until(int id, string state) => BackgroundCell.Until(
        () => Shell.Run("cell", "show", Config, $"{id}", "--json").Output.Contains($"\"state\": \"{state}\"", StringComparison.Ordinal));

    private string Placed(string path) => Path.Combine(_folder.Path, path);
}
