using System.Text.RegularExpressions;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>ARCHITECTURE.md is short, names only what exists, and its map lists every project and folder.</summary>
public sealed partial class ArchitectureTests
{
    private const string Architecture = "ARCHITECTURE.md";
    private const int MostLines = 350;

    // What is in code marks and is no name: the words "code marks", and spellings of words of programs, which only a control has.
    private static readonly string[] NoNames = ["code marks", "IY-5", "Y=IC(-5)"];

    private static readonly Lazy<HashSet<string>> Paths = new(ReadPaths);
    private static readonly Lazy<Source[]> Sources = new(ReadSources);
    private static readonly Lazy<HashSet<string>> Words = new(
        () => [.. Sources.Value.SelectMany(s => Word().Matches(s.Text).Concat(Hyphenated().Matches(s.Text)).Select(m => m.Value))]);

    /// <summary>The page, and those that it sends to for details.</summary>
    public static TheoryData<string> Pages =>
    [
        Architecture,
        .. Directory.EnumerateFiles(Repository.PathTo("docs"), "how-*.md")
            .Select(f => "docs/" + Path.GetFileName(f))
            .Order(StringComparer.Ordinal),
    ];

    [Fact]
    public void The_page_has_at_most_350_lines() => Assert.InRange(File.ReadLines(Repository.PathTo(Architecture)).Count(), 1, MostLines);

    [Theory]
    [MemberData(nameof(Pages))]
    public void Each_name_in_code_marks_exists(string page)
    {
        var names = Mark().Matches(File.ReadAllText(Repository.PathTo(page.Split('/')))).Select(m => m.Groups["name"].Value).ToArray();
        Assert.True(names.Length > 10, $"Only {names.Length} names were found.");
        string[] gone = [.. names.Except(NoNames).Where(n => !Exists(n))];
        Assert.True(gone.Length == 0, $"{page} names {string.Join(", ", gone)}: no path and no identifier.");
    }

    // As FolderTests and HouseTests hold them.
    [Fact]
    public void The_map_lists_all_projects_and_folders_in_their_order()
    {
        var text = File.ReadAllText(Repository.PathTo(Architecture)).ReplaceLineEndings("\n");
        var map = text[text.IndexOf("## Map\n", StringComparison.Ordinal)..text.IndexOf("## Invariants\n", StringComparison.Ordinal)];
        var sections = Section().Matches(map)
            .Where(m => m.Groups["project"].Value != "Outside src")
            .Select(m => (
                Project: m.Groups["project"].Value,
                Folders: Folder().Matches(m.Value).Select(f => f.Groups["folder"].Value).ToArray()))
            .ToArray();
        string[] projects = [.. sections.Select(s => s.Project)];
        Assert.Equal(HouseTests.Below.Keys.Order(StringComparer.Ordinal), projects.Order(StringComparer.Ordinal));
        Assert.All(projects, p => Assert.Empty(HouseTests.Below[p].Except(projects.TakeWhile(q => q != p))));
        Assert.All(sections, s => Assert.Equal(FolderTests.Orders.GetValueOrDefault(s.Project, []), s.Folders));
    }

    // A path, or words that occur in the sources; of Type.Member, the member occurs where the type is declared.
    private static bool Exists(string name)
    {
        if (Paths.Value.Contains(name.TrimEnd('/')))
        {
            return true;
        }

        var words = Word().Matches(name).Select(m => m.Value).ToArray();
        if (words is [var type, var member] && name == $"{type}.{member}"
            && Sources.Value.Where(s => s.Types.Contains(type)).ToArray() is { Length: > 0 } declaring)
        {
            return declaring.Any(s => Regex.IsMatch(s.Text, $@"\b{member}\b", RegexOptions.None, Regex.InfiniteMatchTimeout));
        }

        return words.Length > 0 && name.Split([' ', '"', ':', '.'], StringSplitOptions.RemoveEmptyEntries).All(Words.Value.Contains);
    }

    // Every end of every path, without the prefix of the projects.
    private static HashSet<string> ReadPaths()
    {
        var paths = new HashSet<string>(StringComparer.Ordinal);
        foreach (var entry in HouseTests.Folders(Repository.Root).SelectMany(f => Directory.EnumerateFiles(f).Prepend(f)))
        {
            var parts = Path.GetRelativePath(Repository.Root, entry).Split(Path.DirectorySeparatorChar);
            for (var first = 0; first < parts.Length; first++)
            {
                var end = string.Join('/', parts[first..]);
                paths.Add(end);
                paths.Add(end.Replace("ErrorMatching.", "", StringComparison.Ordinal));
            }
        }

        return paths;
    }

    // Comments may name what is gone.
    private static Source[] ReadSources() =>
    [
        .. new[] { "src", "tests", "tools", "deploy", ".ci" }
            .SelectMany(f => HouseTests.Folders(Repository.PathTo(f)))
            .SelectMany(Directory.EnumerateFiles)
            .Where(f => Path.GetExtension(f) is ".cs" or ".axaml" or ".json" or ".py" or ".csproj" or ".sql" or ".cmd" or ".ps1" or "")
            .Select(f => Path.GetExtension(f) == ".cs" ? Comment().Replace(File.ReadAllText(f), "") : File.ReadAllText(f))
            .Select(t => new Source(t, [.. Declared().Matches(t).Select(m => m.Groups["type"].Value)])),
    ];

    private sealed record Source(string Text, HashSet<string> Types);

    [GeneratedRegex("`(?<name>[^`\n]+)`", RegexOptions.ExplicitCapture, Timeout.Infinite)]
    private static partial Regex Mark();

    [GeneratedRegex(@"^### (?<project>.+)\n(?<text>(?!##).*\n)*", RegexOptions.ExplicitCapture | RegexOptions.Multiline, Timeout.Infinite)]
    private static partial Regex Section();

    // "(project)" is the project's own folder, which FolderTests calls "".
    [GeneratedRegex(
        @"^- (`(?<folder>\w+)`|\(project\)(?<folder>)):", RegexOptions.ExplicitCapture | RegexOptions.Multiline, Timeout.Infinite)]
    private static partial Regex Folder();

    [GeneratedRegex(@"//[^\n]*", RegexOptions.None, Timeout.Infinite)]
    private static partial Regex Comment();

    [GeneratedRegex(@"\b(class|record struct|record|struct|enum|interface) (?<type>\w+)", RegexOptions.ExplicitCapture, Timeout.Infinite)]
    private static partial Regex Declared();

    [GeneratedRegex(@"\w+", RegexOptions.None, Timeout.Infinite)]
    private static partial Regex Word();

    [GeneratedRegex(@"-*\w+(-\w+)+|-+\w+", RegexOptions.ExplicitCapture, Timeout.Infinite)]
    private static partial Regex Hyphenated();
}
