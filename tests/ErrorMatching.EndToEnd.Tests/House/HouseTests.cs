using System.Text;
using System.Text.Json;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>What holds of the sources as a whole.</summary>
public sealed partial class HouseTests
{
    private const int MostColumns = 140;

    // What each project may refer to. Whoever adds an arrow here turns the architecture round, or says in ARCHITECTURE.md why not.
    internal static readonly Dictionary<string, string[]> Below = new(StringComparer.Ordinal)
    {
        ["Geometry"] = [],
        ["Refusals"] = [],
        ["Json"] = ["Refusals"],
        ["Measurement"] = ["Geometry", "Json", "Refusals", "Reporting"],
        ["Nc"] = ["Geometry", "Json", "Refusals"],
        ["Reporting"] = ["Geometry", "Json", "Refusals"],
        ["Mating"] = ["Geometry", "Json", "Refusals", "Measurement", "Nc", "Reporting"],
        ["Freeform"] = ["Geometry", "Json", "Refusals", "Measurement", "Nc", "Reporting"],
        ["Jobs"] = ["Geometry", "Json", "Refusals", "Measurement", "Nc", "Reporting", "Mating", "Freeform"],
        ["Cell"] = ["Geometry", "Json", "Refusals", "Measurement", "Nc", "Reporting", "Mating", "Freeform", "Jobs"],
        ["Console"] = ["Geometry", "Json", "Refusals", "Measurement", "Nc", "Reporting", "Mating", "Freeform", "Jobs", "Cell"],

        // The station: what it shows is apart from what draws it, and neither knows the console.
        ["Hmi.Platform"] = [],
        ["Hmi"] = ["Geometry", "Json", "Refusals", "Measurement", "Nc", "Reporting", "Mating", "Freeform", "Jobs", "Cell"],
        ["Hmi.Desktop"] = ["Hmi", "Hmi.Platform"],
    };

    private static readonly string[] TextEndings = [
        ".cs", ".csproj", ".props", ".json", ".md", ".html", ".axaml", ".nc", ".csv", ".yml", ".txt", ".sln", ".sh"];

    [Fact]
    public void References_point_one_way()
    {
        foreach (var file in Directory.EnumerateFiles(Repository.PathTo("src"), "*.csproj", SearchOption.AllDirectories))
        {
            var name = ShortName(file);
            Assert.True(Below.ContainsKey(name), $"{name} has no place in the architecture.");
            var references = XDocument.Load(file)
                .Descendants("ProjectReference")
                .Select(r => ShortName(r.Attribute("Include")!.Value))
                .ToArray();
            Assert.All(references, r => Assert.True(Below[name].Contains(r), $"{name} must not refer to {r}."));
        }
    }

    [Fact]
    public void No_line_has_more_than_140_columns()
    {
        var long140 = from file in Sources().Where(f => f.EndsWith(".cs", StringComparison.Ordinal))
                      from line in LinesOutsideRawTexts(file)
                      where line.Text.Length > MostColumns
                      select $"{file}:{line.Number}";
        Assert.True(!long140.Any(), string.Join('\n', long140));
    }

    // A raw text is another language's: JSON, a program, a page.
    private static IEnumerable<(string Text, int Number)> LinesOutsideRawTexts(string file)
    {
        var isRaw = false;
        var number = 0;
        foreach (var line in File.ReadLines(file))
        {
            number++;
            var marks = RawMark().Count(line);
            if (!isRaw && marks == 0)
                yield return (line, number);
            isRaw ^= marks % 2 == 1;
        }
    }

    [Fact]
    public void No_file_knows_a_place_on_somebody_s_machine()
    {
        // Put together here, or this file would name them itself.
        string[] places = [
            .. new[] { "home", "Users", "root", "work", "mnt" }.Select(f => "/" + f + "/"), "C:" + "\\Users", "C:" + "/Users"];
        foreach (var file in Sources())
        {
            var text = File.ReadAllText(file, Encoding.Latin1);
            Assert.All(
                places,
                p => Assert.False(
                    text.Contains(" " + p, StringComparison.Ordinal)
                        || text.Contains("\"" + p, StringComparison.Ordinal)
                        || text.Contains("`" + p, StringComparison.Ordinal),
                    $"{file} names {p}"));
        }
    }

    [Fact]
    public void What_others_may_have_open_is_read_and_replaced_in_one_place()
    {
        // The platform's font files are the system's, and it refers to none of our projects.
        var others = Sources()
            .Where(f => f.StartsWith(Repository.PathTo("src"), StringComparison.Ordinal) && f.EndsWith(".cs", StringComparison.Ordinal))
            .Where(f => Path.GetFileName(f) != "SharedFile.cs" && !f.Contains("ErrorMatching.Hmi.Platform", StringComparison.Ordinal));
        Assert.All(others, f => Assert.DoesNotMatch(ReadOrReplaced(), File.ReadAllText(f)));
    }

    // A kind of feature is a folder: what is outside of it asks the feature, and never which kind it has.
    [Fact]
    public void No_source_outside_of_its_folder_names_a_kind_of_feature()
    {
        var features = Repository.PathTo("src", "ErrorMatching.Mating", "Features");
        foreach (var kind in Directory.EnumerateDirectories(features))
        {
            var types = Directory.EnumerateFiles(kind, "*.cs").SelectMany(TypesIn).ToArray();
            Assert.Contains(Path.GetFileName(kind) + "Kind", types);
            Assert.Contains(Path.GetFileName(kind) + "Feature", types);
            foreach (var file in Directory.EnumerateFiles(Repository.PathTo("src"), "*.cs", SearchOption.AllDirectories)
                .Where(
                    f => Path.GetDirectoryName(f) != kind
                        && f != Path.Combine(features, "FeatureKinds.cs")
                        && !f.Contains($"{Path.DirectorySeparatorChar}obj{Path.DirectorySeparatorChar}", StringComparison.Ordinal)))
            {
                var words = File.ReadAllText(file).Split(
                    [' ', '.', ',', ';', '(', ')', '<', '>', '[', ']', '{', '}', '?', '"', '\n', '\r'],
                    StringSplitOptions.RemoveEmptyEntries);
                Assert.True(!words.Intersect(types).Any(), $"{file} names {string.Join(", ", words.Intersect(types))}");
            }
        }
    }

    // ControlWays and the dialects name what a control does. A new family is a new row there, and no search through the rooms.
    [Fact]
    public void No_room_of_the_control_asks_for_a_family()
    {
        var rooms = Directory.EnumerateFiles(Repository.PathTo("src", "ErrorMatching.Nc", "Control"), "*.cs").ToArray();
        Assert.NotEmpty(rooms);
        Assert.All(rooms, f => Assert.DoesNotContain("NcSyntax.", File.ReadAllText(f), StringComparison.Ordinal));
    }

    // A reader must not have to ask which of two types a name means.
    [Fact]
    public void No_type_of_one_project_has_the_name_of_another_s()
    {
        var twice = Sources()
            .Where(f => f.StartsWith(Repository.PathTo("src") + Path.DirectorySeparatorChar, StringComparison.Ordinal)
                && f.EndsWith(".cs", StringComparison.Ordinal))
            .SelectMany(f => TypesIn(f).Select(type => (Type: type, Project: ProjectOf(f))))
            .Distinct()
            .GroupBy(t => t.Type, StringComparer.Ordinal)
            .Where(g => g.Count() > 1)
            .Select(g => $"{g.Key} is in {string.Join(" and ", g.Select(t => t.Project).Order(StringComparer.Ordinal))}");
        Assert.Empty(twice.Order(StringComparer.Ordinal));
    }

    [Fact]
    public void Each_project_is_in_the_solution()
    {
        var solution = File.ReadAllText(Repository.PathTo("ErrorMatching.sln"));
        Assert.All(
            Sources().Where(f => f.EndsWith(".csproj", StringComparison.Ordinal)),
            f => Assert.Contains(Path.GetFileName(f), solution, StringComparison.Ordinal));
    }

    [Fact]
    public void Solution_filters_name_projects_that_are_there()
    {
        var filters = Directory.GetFiles(Repository.Root, "*.slnf");
        Assert.Equal(3, filters.Length);
        Assert.All(filters, f =>
        {
            using var filter = JsonDocument.Parse(File.ReadAllText(f));
            var projects = filter.RootElement.GetProperty("solution").GetProperty("projects").EnumerateArray().Select(p => p.GetString()!);
            Assert.All(projects, p => Assert.True(File.Exists(Repository.PathTo(p.Split('\\'))), $"{f} names {p}"));
        });
    }

    // Types inside of others are indented.
    private static IEnumerable<string> TypesIn(string file) =>
        DeclaredType().Matches(File.ReadAllText(file)).Select(m => m.Groups["type"].Value);

    private static string ProjectOf(string source) =>
        Path.GetRelativePath(Repository.PathTo("src"), source).Split(Path.DirectorySeparatorChar)[0];

    private static string ShortName(string project) =>
        Path.GetFileNameWithoutExtension(project.Replace('\\', '/')).Replace("ErrorMatching.", "", StringComparison.Ordinal);

    private static IEnumerable<string> Sources() => Folders(Repository.Root)
        .SelectMany(Directory.EnumerateFiles)
        .Where(f => TextEndings.Contains(Path.GetExtension(f)));

    internal static IEnumerable<string> Folders(string folder) => Directory.EnumerateDirectories(folder)
        .Where(f => Path.GetFileName(f) is not ("artifacts" or "bin" or "obj" or ".git" or "out" or "TestResults"))
        .SelectMany(Folders)
        .Prepend(folder);

    [GeneratedRegex(
        @"^([a-z]+ )*(class|record struct|record|struct|enum|interface|delegate \S+) (?<type>\w+)",
        RegexOptions.ExplicitCapture | RegexOptions.Multiline,
        Timeout.Infinite)]
    private static partial Regex DeclaredType();

    [GeneratedRegex("\"{3,}", RegexOptions.None, Timeout.Infinite)]
    private static partial Regex RawMark();

    [GeneratedRegex(
        @"\bFile\.(Replace|ReadAllBytes|OpenRead|OpenHandle)\b|\bFile\.Move\([^;]*overwrite: true|\bDirectory\.Move\b",
        RegexOptions.ExplicitCapture,
        Timeout.Infinite)]
    private static partial Regex ReadOrReplaced();
}
