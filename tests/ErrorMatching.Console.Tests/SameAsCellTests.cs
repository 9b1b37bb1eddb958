using System.Text.Json.Nodes;
using ErrorMatching.Cell;
using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

/// <summary>What the console writes and what a cell computes are one thing.</summary>
public sealed class SameAsCellTests
{
    // What the cell leaves out or names otherwise: where files are, and how long it took.
    private static readonly string[] OfTheirOwn = ["file", "calculatingS"];

    [Theory]
    [InlineData("complex-mating")]
    [InlineData("curve-mating")]
    [InlineData("circle-mating")]
    [InlineData("slot-mating")]
    public void A_match_is_that_of_the_cell(string sample)
    {
        using var folder = new TemporaryFolder();
        Assert.Equal(0, Shell.Run("match", Job(sample), "--out", folder.Path).Exit);
        var computed = Compute(sample, "part", "part.csv");
        Assert.Equal(File.ReadAllBytes(folder["counterpart.nc"]), computed.Program.ToArray());
        Assert.Equal("counterpart.nc", computed.ProgramName);
        AssertSameReport(File.ReadAllBytes(folder["report.json"]), computed);
    }

    [Fact]
    public void A_finishing_program_is_that_of_the_cell()
    {
        using var folder = new TemporaryFolder();
        Assert.Equal(
            0,
            Shell.Run(
                "surface",
                "compensate",
                Job("surface-one"),
                "--measured",
                Repository.PathTo("samples", "surface-one", "measured.csv"),
                "--out",
                folder.Path).Exit);
        var computed = Compute("surface-one", "surface", "measured.csv");
        Assert.Equal(File.ReadAllBytes(folder["finishing.nc"]), computed.Program.ToArray());
        AssertSameReport(File.ReadAllBytes(folder["report.json"]), computed);
    }

    [Fact]
    public void A_displaced_program_is_that_of_the_cell()
    {
        using var folder = new TemporaryFolder();
        var (measured, cam) = (
            Repository.PathTo("samples", "surface-one", "measured.csv"), Repository.PathTo("samples", "surface-one", "cam.nc"));
        var (exit, json, _) = Shell.Run(
            "surface", "displace", Job("surface-one"), "--measured", measured, "--program", cam, "--out", folder.Path, "--json");
        Assert.Equal(0, exit);
        var computed = Compute("surface-one", "surface", "measured.csv", cam);
        Assert.Equal(File.ReadAllBytes(folder["cam.nc"]), computed.Program.ToArray());
        AssertSameReport(System.Text.Encoding.UTF8.GetBytes(json), computed);
    }

    [Fact]
    public void A_refusal_has_the_code_of_the_cell()
    {
        using var folder = new TemporaryFolder();
        var (wrong, fewer) = (
            Repository.PathTo("samples", "complex-mating", "counterpart.nc"), folder.File("part.csv", "point,x_mm,y_mm\n1,2,3\n"));
        foreach (var file in new[] { wrong, fewer })
        {
            var error = Shell.Error(1, "match", Job("complex-mating"), "--part", file);
            var refused = Assert.IsType<RefusedComputation>(
                new CorrectionComputer(NoLimits).Compute(
                    Request("complex-mating", "part", new(file, File.ReadAllBytes(file))), TestContext.Current.CancellationToken));
            Assert.Equal((error.Text("code"), error.Text("message")), (refused.Code, refused.Reason.Sentence));
        }
    }

    private static PolicySettings NoLimits => new(Automatic: true, LimitMm: null, SumLimitMm: null, Gain: null);

    private static ComputedProgram Compute(string sample, string piece, string measurement, string? program = null)
    {
        var request = Request(sample, piece, new(measurement, File.ReadAllBytes(Repository.PathTo("samples", sample, measurement))));
        return Assert.IsType<ComputedProgram>(
            new CorrectionComputer(NoLimits).Compute(
                request with { Job = request.Job with { Program = program } }, TestContext.Current.CancellationToken));
    }

    private static CorrectionRequest Request(string sample, string piece, StoredFile measurement) => new()
    {
        Job = new()
        {
            Name = sample,
            File = Job(sample),
            Gauges = ["gauge"],
            Recognize = new(".*", null, null),
            Machine = "mill",
            Slot = "1",
            InOrderOfSerial = false,
            Accumulates = false,
        },
        Piece = piece,
        Measurement = measurement,
    };

    private static void AssertSameReport(byte[] console, ComputedProgram computed)
    {
        var (one, other) = (JsonNode.Parse(console)!, JsonNode.Parse(computed.Report.Span)!);
        Strip(one);
        Strip(other);
        Assert.Equal(one.ToJsonString(), other.ToJsonString());
        Assert.True(computed.Page.Length > 0);
    }

    private static void Strip(JsonNode node)
    {
        if (node is JsonObject item)
        {
            foreach (var name in OfTheirOwn)
            {
                item.Remove(name);
            }
        }

        IEnumerable<JsonNode?> inside = node switch { JsonObject o => o.Select(m => m.Value), JsonArray a => a, _ => [] };
        foreach (var below in inside.OfType<JsonNode>())
        {
            Strip(below);
        }
    }

    private static string Job(string sample) => Repository.PathTo("samples", sample, "job.json");
}
