using System.Globalization;
using System.Text;
using ErrorMatching.Nc;
using ErrorMatching.Testing;

namespace ErrorMatching.Freeform.Tests;

/// <summary>The package's README: its example is the code between the markers below.</summary>
public sealed class ReadmeTests
{
    [Fact]
    public void The_example_of_the_readme_runs_and_means_what_it_says()
    {
        // example
        var job = FreeformJob.Parse("""
            {
              "kind": "freeform", "name": "Saddle", "surface": "saddle.csv",
              "tool": { "kind": "ball", "diameterMm": 6 }, "spindleRpm": 10000, "feedMmPerMin": 1200,
              "measuring": { "curves": 5, "pointsPerCurve": 6, "stylusDiameterMm": 6, "dialect": "siemens-840d", "measuredAfter": "finishing" },
              "toolpath": { "dialect": "siemens-840d" }
            }
            """u8, "job.json");
        var grid = new StringBuilder("i,j,x,y,z\n");
        for (var k = 0; k < 25; k++)
        {
            var (x, y) = (k % 5 * 5, k / 5 * 5);
            grid.Append(CultureInfo.InvariantCulture, $"{k % 5},{k / 5},{x},{y},{20 + ((x - 10) * (y - 10) / 100.0)}\n");
        }

        var surface = SurfaceReader.Read(Encoding.UTF8.GetBytes(grid.ToString()), "saddle.csv", entity: null, outsideIsUp: true);
        var plan = MeasuringPlanner.Plan(surface, job.Measuring);

        // Everywhere 20 µm are left, as if the tool were worn.
        var table = new StringBuilder("point,x,y,z\n");
        foreach (var point in plan.Points)
        {
            var at = point.Position + (point.Normal * 0.02);
            table.Append(CultureInfo.InvariantCulture, $"{point.Number},{at.X},{at.Y},{at.Z}\n");
        }

        var measured = MeasuredSurfaceReader.Read(Encoding.UTF8.GetBytes(table.ToString()), "measured.csv", plan, job.Measuring);
        var outcome = Compensator.Compensate(new(job, surface, plan, [measured]));
        foreach (var refusal in outcome.Refusals)
        {
            Console.WriteLine($"{refusal.Code}: {refusal.Message}"); // why there is no surface
        }

        var result = outcome.Result!;
        var control = NcDialects.Named(job.Toolpath.Dialect);
        var path = ToolPathPlanner.Plan(result.Surface, job.Tool, job.Toolpath, stockMm: 0, control).Path!;
        var program = FinishingProgram.Write(path, job, control); // the bytes to cut
        var scallop = path.Certificate.ScallopMm; // at most 0.001
        // example

        Assert.Equal(0.02, result.Before.MeanMm, 9);
        Assert.Equal(0.02, result.LargestMoveMm, 6);
        Assert.Equal(0, result.Mirror.Statistics.MeanMm, 9);
        Assert.InRange(scallop, 0.0005, 0.001);
        Assert.Null(NcInterpreter.Run(NcProgram.Read(program, control.Syntax), control).Refusal);
    }

    [Fact]
    public void The_example_of_the_readme_is_the_one_that_runs()
    {
        var source = File.ReadAllLines(Repository.PathTo("tests", "ErrorMatching.Freeform.Tests", "ReadmeTests.cs"));
        var inside = source.SkipWhile(l => l.Trim() != "// example").Skip(1).TakeWhile(l => l.Trim() != "// example").ToArray();

        Assert.Contains(
            "```csharp\n" + string.Join('\n', inside.Select(l => l.Length > 8 ? l[8..] : l)) + "\n```",
            File.ReadAllText(Repository.PathTo("src", "ErrorMatching.Freeform", "README.md")),
            StringComparison.Ordinal);
    }
}
