using System.Text.RegularExpressions;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>Folders of a project point one way, as ARCHITECTURE.md draws them.</summary>
/// <remarks>
/// The name of a type that occurs in a file is an arrow to the folder that declares the type. Comments and texts do not count, nor do
/// members: what follows a point, constants, and what an enumeration lists. Any other property that has a type's name counts where the two
/// are in different folders. In a view, names with the prefix of our namespace count.
/// </remarks>
public sealed partial class FolderTests
{
    // Each folder may use those before it. "" is the project's own folder.
    internal static readonly Dictionary<string, string[]> Orders = new(StringComparer.Ordinal)
    {
        ["Json"] = ["Files", "Document", "Schema"],
        ["Geometry"] = ["", "Numbers", "Plane", "Space", "Splines", "Fits", "Alignments", "Tolerances"],
        ["Reporting"] = ["Statements", "Document", "Page", "Drawings"],
        ["Measurement"] = ["", "Tables", "Formats", "Reading", "Sources", "Lots", "LotReports", "Writing"],
        ["Nc"] =
        [
            "", "Text", "Dialects", "Motion", "Expressions", "Flow", "Control", "Running", "Compensation", "Offsets",
            "Wishes", "Rewriting", "Proof",
            "Certificates", "Comparison",
        ],
        ["Mating"] =
        [
            "", "Tolerances", "Measuring", "Cutting", "Displacing", "Features", "Job", "Mapping", "Aligning", "Lots", "Deciding",
            "Estimating", "Trusting", "Choosing", "Pairing", "Matching", "Planning", "Verifying", "Reporting",
        ],
        ["Freeform"] =
        [
            "", "Surfaces", "Fields", "Fitting", "Exchange", "Job", "Planning", "Templates", "Probing", "ToolPaths",
            "Judging", "Evaluating", "Lots", "Compensating", "Displacing", "Reporting",
        ],
        ["Jobs"] = ["Errors", "Reading", "Writing", "Running", "Editing", "Outlines", "Planning"],
        ["Cell"] =
        [
            "Disk", "Rights", "States", "Reading", "Activity", "Transport", "Events", "Configuration", "Machines", "Trail", "Contents",
            "Database", "Archives", "Replay", "Store", "Publishing", "Arriving", "Computing", "Keys", "Evidence", "People", "Running",
            "Alarms", "Checking", "Editing",
        ],
        ["Console"] = ["Output", "Outcomes", "Verbs", ""],
        ["Hmi"] =
        [
            "Observing", "Texts", "Styles", "Controls", "Choosing", "Stored", "Demonstration", "Plots", "Drawings", "Programs",
            "Preferring", "Station", "Editing", "Typing", "Shell", "Screens", "",
        ],
        ["Hmi/Screens"] =
        [
            "Freeform", "Compensation", "Verification", "Overview", "Login", "Messages", "History", "Setup", "Points", "System", "Settings",
        ],
        ["Hmi.Platform"] = ["Text", "Drawing", "Windows", "X11", "Win32", ""],
    };

    public static TheoryData<string> Projects => [.. Orders.Keys.Order(StringComparer.Ordinal)];

    [Theory]
    [MemberData(nameof(Projects))]
    public void Folders_point_one_way(string project)
    {
        var root = Repository.PathTo("src", "ErrorMatching." + project);
        var files = Directory.EnumerateFiles(root, "*.cs", SearchOption.AllDirectories)
            .Where(f => !f.Contains(Path.DirectorySeparatorChar + "obj" + Path.DirectorySeparatorChar, StringComparison.Ordinal))
            .Select(f => (Path: f, Folder: FolderOf(root, f), Source: Quoted().Replace(File.ReadAllText(f), "")))
            .ToArray();
        var order = Orders[project];
        Assert.Equal(order.Order(StringComparer.Ordinal), files.Select(f => f.Folder).Distinct().Order(StringComparer.Ordinal));

        var rooms = files.SelectMany(f => Declared().Matches(f.Source).Select(m => (Type: m.Groups["type"].Value, f.Folder)))
            .Where(t => t.Type != "Program")
            .GroupBy(t => t.Type, StringComparer.Ordinal)
            .ToDictionary(g => g.Key, g => g.First().Folder, StringComparer.Ordinal);
        Assert.True(rooms.Count >= files.Length / 2, $"Only {rooms.Count} types were found in {files.Length} files.");
        var users = files.Select(f => (f.Path, f.Folder, Names: Names().Matches(Members().Replace(f.Source, "")).Select(m => m.Value)))
            .Concat(Directory.EnumerateFiles(root, "*.axaml", SearchOption.AllDirectories)
                .Select(f => (
                    Path: f, Folder: FolderOf(root, f), Names: Own().Matches(File.ReadAllText(f)).Select(m => m.Groups["name"].Value))));
        var wrong = from user in users
                    let rank = Array.IndexOf(order, user.Folder)
                    from name in user.Names.Distinct(StringComparer.Ordinal)
                    where rooms.TryGetValue(name, out var room) && Array.IndexOf(order, room) > rank
                    select $"{Path.GetRelativePath(root, user.Path)} uses {name} in {rooms[name]}";
        Assert.Empty(wrong.Order(StringComparer.Ordinal));
    }

    private static string FolderOf(string root, string file) =>
        Path.GetRelativePath(root, file).Split(Path.DirectorySeparatorChar) is [var folder, _, ..] ? folder : "";

    [GeneratedRegex("\"\"\"[\\s\\S]*?\"\"\"|//[^\\n]*|\"(\\\\.|[^\"\\\\\\n])*\"", RegexOptions.ExplicitCapture, Timeout.Infinite)]
    private static partial Regex Quoted();

    // Types inside of others are indented.
    [GeneratedRegex(
        @"^([a-z]+ )*(class|record struct|record|struct|enum|interface|delegate \S+) (?<type>\w+)",
        RegexOptions.ExplicitCapture | RegexOptions.Multiline,
        Timeout.Infinite)]
    private static partial Regex Declared();

    [GeneratedRegex(@"const string \w+|^ +[A-Z]\w+( = \w+)?,\r?$", RegexOptions.ExplicitCapture | RegexOptions.Multiline, Timeout.Infinite)]
    private static partial Regex Members();

    [GeneratedRegex(@"(?<![.\w])[A-Z]\w+\b", RegexOptions.None, Timeout.Infinite)]
    private static partial Regex Names();

    // The prefix of our own namespace. A selector (l|Name) is no use: the styles name what they style.
    [GeneratedRegex(@"\bl:(?<name>[A-Z]\w+)", RegexOptions.ExplicitCapture, Timeout.Infinite)]
    private static partial Regex Own();
}
