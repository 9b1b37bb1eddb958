using System.Text.Json;
using ErrorMatching.Testing;

namespace ErrorMatching.Cell.Tests;

/// <summary>A kind of way to a machine is a folder and a line of registration; nothing else decides by kind.</summary>
public sealed class TransportKindTests
{
    [Fact]
    public void The_schema_names_the_kinds_that_are_read()
    {
        using var schema = JsonDocument.Parse(File.ReadAllText(Path.Combine(Sources, "Configuration", "cell.schema.json")));
        var named = schema.RootElement.GetProperty("properties").GetProperty("machines").GetProperty("items").GetProperty("properties")
            .GetProperty("transport").GetProperty("oneOf").EnumerateArray()
            .Select(k => k.GetProperty("properties").GetProperty("kind").GetProperty("const").GetString());
        Assert.Equal(TransportKinds.Names, named.Order(StringComparer.Ordinal));
    }

    [Fact]
    public void Only_a_kind_s_own_folder_and_the_registration_name_it()
    {
        var kinds = typeof(TransportSettings).Assembly.GetTypes()
            .Where(t => t.BaseType == typeof(TransportSettings))
            .Select(t => t.Name)
            .ToArray();
        Assert.Equal(TransportKinds.Names.Count(), kinds.Length);
        var others = new[] { "ErrorMatching.Cell", "ErrorMatching.Console", "ErrorMatching.Hmi" }
            .SelectMany(p => Directory.EnumerateFiles(Repository.PathTo("src", p), "*.cs", SearchOption.AllDirectories))
            .Where(f => Path.GetFileName(f) != "TransportKinds.cs" && !kinds.Any(k => f.StartsWith(FolderOf(k), StringComparison.Ordinal)));
        Assert.All(others, f => Assert.DoesNotMatch($@"\b({string.Join('|', kinds)})\b", File.ReadAllText(f)));
    }

    private static string Sources => Repository.PathTo("src", "ErrorMatching.Cell");

    private static string FolderOf(string kind) =>
        Path.Combine(Sources, "Transport", kind.Replace("Settings", "", StringComparison.Ordinal)) + Path.DirectorySeparatorChar;
}
