using System.Security.Cryptography;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A temporary folder with a copy of the samples, in which a process may do what it likes.</summary>
internal sealed class Workshop : IDisposable
{
    public Workshop()
    {
        var samples = Repository.PathTo("samples");
        foreach (var file in Directory.EnumerateFiles(samples, "*", SearchOption.AllDirectories))
        {
            var copy = this["samples", Path.GetRelativePath(samples, file)];
            Directory.CreateDirectory(Path.GetDirectoryName(copy)!);
            File.Copy(file, copy);
        }
    }

    public string Folder { get; } = Directory.CreateTempSubdirectory("errormatch-").FullName;

    public string this[params string[] parts] => Path.Combine([Folder, .. parts]);

    /// <summary>All files with the hashes of their bytes, sorted by name.</summary>
    public IReadOnlyList<string> State() =>
        [
            .. Directory.EnumerateFiles(Folder, "*", SearchOption.AllDirectories)
                .Order(StringComparer.Ordinal)
                .Select(f => $"{Path.GetRelativePath(Folder, f)} {Sha256(f)}")];

    public static string Sha256(string file) => Convert.ToHexStringLower(SHA256.HashData(File.ReadAllBytes(file)));

    /// <summary>Replaces a text that must be in a file.</summary>
    public void Edit(string file, string old, string replacement)
    {
        var text = File.ReadAllText(this[file]);
        Assert.Contains(old, text, StringComparison.Ordinal);
        File.WriteAllText(this[file], text.Replace(old, replacement, StringComparison.Ordinal));
    }

    public Task<ConsoleRun> Run(params IReadOnlyList<string> arguments) => ConsoleRun.Of(Folder, arguments);

    /// <summary>Runs the words of a command line without quotation marks.</summary>
    public Task<ConsoleRun> Run(string line) => Run(line.Split(' ', StringSplitOptions.RemoveEmptyEntries));

    public void Dispose() => Directory.Delete(Folder, recursive: true);
}
