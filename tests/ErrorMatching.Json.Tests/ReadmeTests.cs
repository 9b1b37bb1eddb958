using ErrorMatching.Testing;

namespace ErrorMatching.Json.Tests;

public sealed class ReadmeTests
{
    [Fact]
    public void The_example_of_the_readme_runs()
    {
        // example
        var schema = JsonSchema.Parse(
            """{ "type": "object", "properties": { "gain": { "exclusiveMinimum": 0, "maximum": 2 } }, "additionalProperties": false }"""u8,
            "schema.json");
        var document = JsonInput.Read("""
            {
              "gian": 1.0, // mistyped
            }
            """u8, "job.json");
        var problem = schema.Check(document)[0].ToString();
        // example

        var readme = File.ReadAllText(Repository.PathTo("src", "ErrorMatching.Json", "README.md"));
        Assert.Contains($"`{problem}`", readme, StringComparison.Ordinal);
        Assert.Contains(Example(), readme, StringComparison.Ordinal);
    }

    private static string Example()
    {
        var source = File.ReadAllText(Repository.PathTo("tests", "ErrorMatching.Json.Tests", "ReadmeTests.cs"));
        var lines = source.Split("        // example\n")[1].Split('\n');
        return string.Join('\n', lines.Select(l => l.Length > 8 ? l[8..] : ""));
    }
}
