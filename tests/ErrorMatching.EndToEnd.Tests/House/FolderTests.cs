using System.Text.RegularExpressions;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>Folders of a project point one way, as ARCHITECTURE.md draws them.</summary>
/// <remarks>
/// A file is named after its one type, so a name that occurs in a file is an arrow to the folder of that file. Comments and texts do not
/// count. A property that has a type's name counts where the two are in different folders.
/// </remarks>
public sealed partial class FolderTests
{
    // Each folder may use those before it. "" is the project's own folder.
    private static readonly Dictionary<string, string[]> Orders = new(StringComparer.Ordinal)
    {
        ["Json"] = ["Document", "Schema"],
        ["Geometry"] = ["", "Numbers", "Plane", "Space", "Splines", "Fits", "Alignments"],
        ["Reporting"] = ["Document", "Page", "Drawings"],
        ["Measurement"] = ["", "Tables", "Formats", "Reading", "Sources"],
        ["Freeform"] =
        [
            "", "Surfaces", "Fields", "Fitting", "Exchange", "Job", "Planning", "Templates", "Probing", "ToolPaths",
            "Evaluating", "Compensating", "Displacing", "Reporting",
        ],
        ["Console"] = ["Output", "Outcomes", "Verbs", ""],
        ["Hmi.Cairo"] = ["Native", "Text", "Drawing", "Windows", "OffScreen", "X11", ""],
    };

    public static TheoryData<string> Projects => [.. Orders.Keys.Order(StringComparer.Ordinal)];

    [Theory]
    [MemberData(nameof(Projects))]
    public void Folders_point_one_way(string project)
    {
        var root = Repository.PathTo("src", "ErrorMatching." + project);
        var files = Directory.EnumerateFiles(root, "*.cs", SearchOption.AllDirectories)
            .Where(f => !f.Contains(Path.DirectorySeparatorChar + "obj" + Path.DirectorySeparatorChar, StringComparison.Ordinal))
            .Select(f => (Path: f, Folder: FolderOf(root, f), Type: Path.GetFileName(f).Split('.')[0]))
            .ToArray();
        var order = Orders[project];
        Assert.Equal(order.Order(StringComparer.Ordinal), files.Select(f => f.Folder).Distinct().Order(StringComparer.Ordinal));

        var rooms = files.Where(f => f.Type != "Program").GroupBy(f => f.Type).ToDictionary(g => g.Key, g => g.First().Folder);
        var wrong = from file in files
                    let rank = Array.IndexOf(order, file.Folder)
                    from name in NamesIn(File.ReadAllText(file.Path))
                    where rooms.TryGetValue(name, out var room) && Array.IndexOf(order, room) > rank
                    select $"{Path.GetRelativePath(root, file.Path)} uses {name} in {rooms[name]}";
        Assert.Empty(wrong.Order(StringComparer.Ordinal));
    }

    private static string FolderOf(string root, string file) =>
        Path.GetRelativePath(root, file).Split(Path.DirectorySeparatorChar) is [var folder, _, ..] ? folder : "";

    private static IEnumerable<string> NamesIn(string source) =>
        Names().Matches(Quoted().Replace(source, "")).Select(m => m.Value).Distinct(StringComparer.Ordinal);

    [GeneratedRegex("\"\"\"[\\s\\S]*?\"\"\"|//[^\\n]*|\"(\\\\.|[^\"\\\\\\n])*\"", RegexOptions.ExplicitCapture, Timeout.Infinite)]
    private static partial Regex Quoted();

    [GeneratedRegex(@"\b[A-Z]\w+\b", RegexOptions.None, Timeout.Infinite)]
    private static partial Regex Names();
}
