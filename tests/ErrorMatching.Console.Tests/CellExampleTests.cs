using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

/// <summary>The examples of verbs about people and evidence, on a copy of the sample cell.</summary>
public sealed class CellExampleTests : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public CellExampleTests()
    {
        foreach (var sample in new[] { "cell", "complex-mating" })
        {
            foreach (var file in Directory.EnumerateFiles(Repository.PathTo("samples", sample)))
            {
                Directory.CreateDirectory(_folder[$"samples/{sample}"]);
                File.Copy(file, _folder[$"samples/{sample}/{Path.GetFileName(file)}"]);
            }
        }
    }

    [Theory]
    [InlineData("add"), InlineData("list"), InlineData("disable"), InlineData("enable"), InlineData("role"), InlineData("password")]
    public void Each_example_about_users_runs(string verb) => Run("user", verb);

    [Theory]
    [InlineData("verify"), InlineData("export")]
    public void Each_example_about_the_trail_runs(string verb) => Run("audit", verb);

    [Fact]
    public void The_example_about_secrets_runs() => Run("cell", "secret");

    public void Dispose() => _folder.Dispose();

    private void Run(string group, string verb)
    {
        if (verb != "add")
        {
            Assert.Equal((0, ""), Typed("user add samples/cell/cell.json anna --role administrator"));
            Assert.Equal((0, ""), Typed("user add samples/cell/cell.json ben --role setter --user anna"));
        }

        var example = CommandTree.Build().Subcommands.Single(c => c.Name == group).Subcommands.OfType<CellVerb>().Single(v => v.Name == verb).Example;
        Assert.StartsWith($"errormatch {group} {verb} ", example, StringComparison.Ordinal);
        Assert.Equal((0, ""), Typed(example["errormatch ".Length..]));
    }

    // Everybody has one password, and types it whenever asked.
    private (int Exit, string Error) Typed(string line)
    {
        using var shown = new StringWriter();
        var secrets = new SecretInput(TextReader.Null, CellFolder.Keyboard(string.Concat(Enumerable.Repeat(CellFolder.Annas + "\n", 3))), shown);
        var (exit, _, error) = Shell.Run(secrets, [.. line.Split(' ').Select(w => w.StartsWith("samples/", StringComparison.Ordinal) || w.StartsWith("out/", StringComparison.Ordinal) ? _folder[w] : w)]);
        return (exit, error);
    }
}
