using System.Text;
using System.Text.Json;
using System.Text.RegularExpressions;
using ErrorMatching.Testing;

namespace ErrorMatching.Cell.Tests;

public sealed partial class ConfigurationPageTests
{
    private const string Begin = "<!-- keys -->\n";
    private const string End = "<!-- /keys -->\n";
    private static readonly string File = Repository.PathTo("docs", "configure-a-cell.md");

    /// <summary>UPDATE_DOCS=1 writes the table.</summary>
    [Fact]
    public void The_table_of_keys_is_the_schemas()
    {
        var page = System.IO.File.ReadAllText(File);
        var (from, to) = (page.IndexOf(Begin, StringComparison.Ordinal) + Begin.Length, page.IndexOf(End, StringComparison.Ordinal));
        if (Environment.GetEnvironmentVariable("UPDATE_DOCS") == "1")
        {
            System.IO.File.WriteAllText(File, page[..from] + Table() + page[to..]);
            return;
        }

        Assert.Equal(Table(), page[from..to]);
    }

    [Fact]
    public void Each_key_has_a_description_and_a_default_or_an_example()
    {
        using var schema = JsonDocument.Parse(CellTemplate.Schema);
        var rows = Keys(schema.RootElement, schema.RootElement, "").ToArray();
        Assert.True(rows.Length > 50);
        Assert.All(rows, r => Assert.True(r.Meaning.Length > 0, $"{r.Key} has no description"));
        Assert.All(
            rows.Where(r => r.IsValue),
            r => Assert.True(r.Default.Length + r.Example.Length > 0, $"{r.Key} has neither default nor example"));
    }

    [Fact]
    public void Each_code_of_a_configuration_is_explained()
    {
        var page = System.IO.File.ReadAllText(File);
        string[] folders = ["Reading", "Configuration"];
        var sources = folders.SelectMany(f => Directory.GetFiles(Repository.PathTo("src", "ErrorMatching.Cell", f), "*.cs"))
            .Select(System.IO.File.ReadAllText);
        var codes = sources.SelectMany(s => Code().Matches(s))
            .Select(m => m.Groups["code"].Value)
            .Distinct(StringComparer.Ordinal)
            .ToArray();
        Assert.True(codes.Length > 35, $"{codes.Length} codes were found");
        Assert.All(codes, c => Assert.Contains($"`{c}`", page, StringComparison.Ordinal));
    }

    private static string Table()
    {
        using var schema = JsonDocument.Parse(CellTemplate.Schema);
        var table = new StringBuilder("| key | meaning | default | example |\n|---|---|---|---|\n");
        foreach (var (key, meaning, usual, example, _) in Keys(schema.RootElement, schema.RootElement, ""))
        {
            table.Append("| ")
                .Append(key)
                .Append(" | ")
                .Append(meaning)
                .Append(" | ")
                .Append(usual)
                .Append(" | ")
                .Append(example)
                .Append(" |\n");
        }

        return table.ToString();
    }

    private static IEnumerable<(string Key, string Meaning, string Default, string Example, bool IsValue)> Keys(
        JsonElement root, JsonElement rule, string path, string kind = "")
    {
        foreach (var alternative in new[]
        {
            "oneOf",
            "anyOf"
        }.Where(k => rule.TryGetProperty(k, out _)).SelectMany(k => rule.GetProperty(k).EnumerateArray()))
        {
            var only = alternative.TryGetProperty("properties", out var members) && members.TryGetProperty("kind", out var named)
                ? $" ({named.GetProperty("const").GetString()})"
                : "";
            foreach (var key in Keys(root, alternative, path, only))
            {
                yield return key;
            }
        }

        if (rule.TryGetProperty("items", out var items))
        {
            foreach (var key in Keys(root, Resolved(root, items), path + "[]"))
            {
                yield return key;
            }
        }

        foreach (var property in rule.TryGetProperty("properties", out var properties)
            ? properties.EnumerateObject().Where(p => p.Name != "$schema")
            : [])
        {
            var target = Resolved(root, property.Value);
            var name = path.Length == 0 ? property.Name : path + "." + property.Name;
            var required = rule.TryGetProperty("required", out var needed)
                && needed.EnumerateArray().Any(n => n.GetString() == property.Name)
                ? "needed"
                : "";
            var inside = Keys(root, target, name).ToArray();
            var usual = Text(property.Value, target, "default");
            yield return (
                $"`{name}`{kind}",
                Words(property.Value, target),
                usual.Length > 0 ? usual : required,
                Example(property.Value, target),
                inside.Length == 0);
            foreach (var key in inside)
            {
                yield return key;
            }
        }
    }

    private static JsonElement Resolved(JsonElement root, JsonElement rule) =>
        rule.TryGetProperty("$ref", out var reference)
            ? root.GetProperty("$defs").GetProperty(reference.GetString()!.Split('/')[^1])
            : rule;

    private static string Words(JsonElement rule, JsonElement target) =>
        (
            rule.TryGetProperty("description", out var words) || target.TryGetProperty("description", out words) ? words.GetString()! : "")
            .Replace("|", "\\|", StringComparison.Ordinal);

    private static string Text(JsonElement rule, JsonElement target, string name) =>
        rule.TryGetProperty(name, out var value) || target.TryGetProperty(name, out value) ? Code(value) : "";

    private static string Example(JsonElement rule, JsonElement target)
    {
        if (rule.TryGetProperty("examples", out var examples) || target.TryGetProperty("examples", out examples))
        {
            return Code(examples[0]);
        }

        return target.TryGetProperty("enum", out var words)
            ? string.Join(", ", words.EnumerateArray().Select(Code))
            : target.TryGetProperty("const", out var only)
            ? Code(only)
            : "";
    }

    private static string Code(JsonElement value) => $"`{value.GetRawText().Replace("|", "\\|", StringComparison.Ordinal)}`";

    [GeneratedRegex(
        """(?:Refuse|Warn|RefuseTwins|Unreadable)\((?:[^;]*?,)?\s*"(?<code>[a-z]+(?:-[a-z0-9]+)+)",""", RegexOptions.ExplicitCapture, 5000)]
    private static partial Regex Code();
}
