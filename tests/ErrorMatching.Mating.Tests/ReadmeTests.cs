using System.Text;
using ErrorMatching.Measurement;
using ErrorMatching.Testing;

namespace ErrorMatching.Mating.Tests;

/// <summary>The package's README: its example is the code between the markers below, and its result is what the example gives.</summary>
public sealed class ReadmeTests
{
    [Fact]
    public void The_example_of_the_readme_runs_and_means_what_it_says()
    {
        // example
        var job = MatingJob.Parse("""
            {
              "kind": "mating", "name": "Cover",
              "part": { "theoretical": "theoretical.csv", "measured": "part.csv" },
              "gauge": { "format": "points", "uncertaintyMm": 0.002 },
              "features": [{ "name": "L1", "kind": "line", "points": ["1", "2"], "blocks": ["N50"], "toleranceMm": [-0.03, 0.03] }],
              "counterpart": { "program": "cover.nc", "dialect": "fanuc", "toolDiameterMm": 6 }
            }
            """u8, "job.json");
        var theoretical = "point,x_mm,y_mm\n1,10,0\n2,40,0\n"u8.ToArray();
        var part = "point,x_mm,y_mm\n1,10.003,0.098\n2,39.998,0.102\n"u8.ToArray();
        var program = """
            N20 G0 X0. Y-20.
            N40 G1 X0. Y-3. F300
            N50 X50.
            N60 Y-20.
            N70 M30
            """u8.ToArray();

        var outcome = Matcher.Match(new(
            job,
            MeasurementReader.Read(theoretical, "theoretical.csv", MeasurementFormat.Points),
            MeasurementReader.Read(part, "part.csv", job.Gauge.Format),
            Counterpart: null,
            "cover.nc",
            program));
        foreach (var refusal in outcome.Refusals)
        {
            Console.WriteLine($"{refusal.Code}: {refusal.Message}"); // why there is no program
        }

        var result = outcome.Result!;
        var holds = result.Proof.Holds; // true
        var cut = result.Program; // the bytes to cut
        var report = MatchReporter.Report(result, "out/cover.nc", calculatingS: 0);
        // example

        Assert.True(holds);
        Assert.Equal(2, report.KeyPoints.Count);
        Assert.Contains("```text\n" + Encoding.ASCII.GetString(cut.Span) + "\n```", ReadMe(), StringComparison.Ordinal);
    }

    [Fact]
    public void The_example_of_the_readme_is_the_one_that_runs()
    {
        var source = File.ReadAllLines(Repository.PathTo("tests", "ErrorMatching.Mating.Tests", "ReadmeTests.cs"));
        var inside = source.SkipWhile(l => l.Trim() != "// example").Skip(1).TakeWhile(l => l.Trim() != "// example").ToArray();

        Assert.Contains(
            "```csharp\n" + string.Join('\n', inside.Select(l => l.Length > 8 ? l[8..] : l)) + "\n```", ReadMe(), StringComparison.Ordinal);
    }

    private static string ReadMe() => File.ReadAllText(Repository.PathTo("src", "ErrorMatching.Mating", "README.md"));
}
