using ErrorMatching.Testing;

namespace ErrorMatching.Measurement.Tests;

public class ReadmeTests
{
    [Fact]
    public void The_example_of_the_readme_runs_and_means_what_it_says()
    {
        var bytes = "Nr;X;Y\n1;-32,067;76,005\n2;-32,372;58,359\n"u8.ToArray();
        // example
        var format = MeasurementFormat.FromJson("""
            { "delimiter": ";", "decimalComma": true, "columns": { "label": "Nr", "x": "X", "y": "Y" } }
            """);
        var file = MeasurementReader.Read(bytes, "part.csv", format);
        file.Require(LabelRange.Expand("1..2"));
        var point = file["2"]; // (-32.372, 58.359) mm, from line 3
        // example

        Assert.Equal((-32.372, 58.359, 3), (point.Position.X, point.Position.Y, point.Line));
        Assert.Contains(
            Example(), File.ReadAllText(Repository.PathTo("src", "ErrorMatching.Measurement", "README.md")), StringComparison.Ordinal);
    }

    private static string Example()
    {
        var source = File.ReadAllLines(Repository.PathTo("tests", "ErrorMatching.Measurement.Tests", "ReadmeTests.cs"));
        var inside = source.SkipWhile(l => l.Trim() != "// example").Skip(1).TakeWhile(l => l.Trim() != "// example").ToArray();
        var indent = inside.Min(l => l.Length - l.TrimStart().Length);
        return string.Join('\n', inside.Select(l => l[indent..])) + "\n";
    }
}
