using System.Text.RegularExpressions;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>CONTRIBUTING.md names only what exists: tests, types and their members, files and folders. What can be typed is tested next to
/// the console's verbs (<c>ContributingCommandTests</c>).</summary>
public sealed partial class ContributingTests
{
    private static readonly string Page = File.ReadAllText(Repository.PathTo("CONTRIBUTING.md"));

    private static readonly string[] Sources = [
        .. new[] { "src", "tests", "benchmarks", "examples" }
            .SelectMany(f => Directory.EnumerateFiles(Repository.PathTo(f), "*.cs", SearchOption.AllDirectories))
            .Select(File.ReadAllText)];

    private static readonly HashSet<string> Types = [
        .. Sources.SelectMany(s => Declared().Matches(s).Select(m => m.Groups["name"].Value))];

    [Fact]
    public void The_tests_that_it_runs_exist()
    {
        var filters = Filter().Matches(Page).Select(m => m.Groups["name"].Value).ToArray();
        Assert.NotEmpty(filters);
        Assert.All(filters, f => Assert.Contains(Types, t => t.Contains(f, StringComparison.Ordinal)));
    }

    [Fact]
    public void The_projects_scripts_and_folders_of_its_commands_exist()
    {
        var paths = CommandPath().Matches(Page).Select(m => m.Groups["path"].Value).ToArray();
        Assert.True(paths.Length > 15, string.Join(' ', paths));
        Assert.All(paths, p => Assert.True(Path.Exists(Repository.PathTo(p)), $"{p} is not there."));
    }

    [Fact]
    public void The_types_and_folders_in_code_marks_exist()
    {
        var names = Marked().Matches(Fenced().Replace(Page, "")).Select(m => m.Groups["name"].Value).ToArray();
        Assert.Contains("FeatureKinds", names);
        Assert.All(names, n => Assert.True(
            n.Split('.') is var parts && (Types.Contains(parts[0])
                || Path.Exists(Repository.PathTo(n)) || Path.Exists(Repository.PathTo("src/ErrorMatching." + n))),
            $"{n} is no type, file or folder."));
    }

    // Where the type is declared.
    [Fact]
    public void The_members_in_code_marks_exist()
    {
        var members = Marked().Matches(Fenced().Replace(Page, "")).Select(m => m.Groups["name"].Value.Split('.'))
            .Where(p => p.Length == 2 && char.IsUpper(p[1][0]) && Types.Contains(p[0])).ToArray();
        Assert.NotEmpty(members);
        Assert.All(members, m => Assert.True(
            Sources.Any(s => Declared().Matches(s).Any(d => d.Groups["name"].Value == m[0])
                && Member().Matches(s).Any(d => d.Groups["name"].Value == m[1])),
            $"{m[0]} has no {m[1]}."));
    }

    [Fact]
    public void The_consoles_commands_are_verbs()
    {
        var said = Fenced().Replace(Page, "");
        Assert.Contains("`match samples/complex-mating/job.json --out out`", said, StringComparison.Ordinal);
        Assert.Contains("`cell run samples/cell/cell.json`", said, StringComparison.Ordinal);
        foreach (Match file in SampleFile().Matches(said))
        {
            Assert.True(File.Exists(Repository.PathTo(file.Value)), file.Value);
        }
    }

    [GeneratedRegex(@"\b(class|record|struct|interface|enum)\s+((struct|class)\s+)?(?<name>\w+)", RegexOptions.ExplicitCapture, 5000)]
    private static partial Regex Declared();

    [GeneratedRegex(
        @"^ +(public|internal|private|protected)\b[^;={(\r\n]* (?<name>\w+)\s*($|[<({=;])",
        RegexOptions.ExplicitCapture | RegexOptions.Multiline, 5000)]
    private static partial Regex Member();

    [GeneratedRegex(@"FullyQualifiedName~(?<name>\w+)", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Filter();

    [GeneratedRegex(
        @"(?<![\w/.-])(?<path>(src|tests|benchmarks|deploy|tools|docs|examples|samples|\.ci)/[\w./-]*\w|\w+\.slnf)",
        RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex CommandPath();

    // Names begin with a capital letter: types, and folders below a project.
    [GeneratedRegex("`(?<name>[A-Z][a-z][A-Za-z0-9]*([./][A-Za-z0-9]+)*)`", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Marked();

    [GeneratedRegex("```.*?```", RegexOptions.ExplicitCapture | RegexOptions.Singleline, 1000)]
    private static partial Regex Fenced();

    [GeneratedRegex(@"samples/[\w/-]+\.json", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex SampleFile();
}
