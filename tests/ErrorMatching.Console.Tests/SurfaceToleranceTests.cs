using System.Text.Json;
using ErrorMatching.Testing;

namespace ErrorMatching.Console.Tests;

/// <summary>Verdicts on surfaces by the job's profile tolerance, as the console prints them. The sample's profile is 50.6 um before and
/// 4.49 um after: twice the largest error that its files of points show.</summary>
public sealed class SurfaceToleranceTests
{
    private const string Stated = "\"profileToleranceMm\": 0.02,";

    [Theory]
    [InlineData("0.0044", 2, "Out of tolerance: profile 4.49 of 4.4 µm; ")]
    [InlineData("0.0046", 0, "In tolerance: profile 4.49 of 4.6 µm at 70 points")]
    public void Only_pieces_in_tolerance_pass_where_that_is_required(string width, int exit, string start)
    {
        using var folder = new TemporaryFolder();
        var job = Job(folder, width);
        var result = Evaluate(job, "--require-in-tolerance", "--out", folder["out"]);
        Assert.Equal(exit, result.Exit);
        Assert.StartsWith(start, result.Output, StringComparison.Ordinal);
        Assert.Equal(exit == 2, result.Error.Contains("after.csv: Out of tolerance: profile 4.49 of 4.4 µm", StringComparison.Ordinal));

        // The evaluation says why, so it is there all the same; nothing else is.
        string[] written = [.. Directory.GetFiles(folder["out"]).Select(f => Path.GetFileName(f))];
        Assert.Contains("evaluation.html", written);
        Assert.Contains("evaluation.json", written);
        Assert.All(written, f => Assert.StartsWith("evaluation.", f, StringComparison.Ordinal));
        Assert.Equal(0, Evaluate(job).Exit);
    }

    [Fact]
    public void Out_of_tolerance_is_one_document_with_the_evaluation_and_the_errors()
    {
        using var folder = new TemporaryFolder();
        var result = Evaluate(Job(folder, "0.0044"), "--require-in-tolerance", "--json");
        using var json = JsonDocument.Parse(result.Output);
        var root = json.RootElement;
        Assert.Equal((2, 2), (result.Exit, root.GetProperty("exit").GetInt32()));
        Assert.Equal("errormatch/surface-evaluate/1", root.GetProperty("schema").GetString());
        Assert.Equal("out-of-tolerance", root.GetProperty("errors")[0].GetProperty("code").GetString());
        Assert.Equal(70, root.GetProperty("count").GetInt32());
        Assert.False(root.GetProperty("verdict").GetProperty("inTolerance").GetBoolean());
        using var passed = JsonDocument.Parse(Evaluate(Job(folder, "0.0046"), "--require-in-tolerance", "--json").Output);
        Assert.False(passed.RootElement.TryGetProperty("exit", out _));
    }

    [Fact]
    public void Without_a_tolerance_none_can_be_required()
    {
        using var folder = new TemporaryFolder();
        var result = Evaluate(Job(folder, null), "--require-in-tolerance", "--json", "--out", folder["out"]);
        using var json = JsonDocument.Parse(result.Output);
        Assert.Equal(1, result.Exit);
        Assert.Equal("tolerance-missing", json.RootElement.GetProperty("errors")[0].GetProperty("code").GetString());
        Assert.False(Directory.Exists(folder["out"]));
        Assert.StartsWith("Not judged: the job states no profile tolerance", Evaluate(Job(folder, null)).Output, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("0.06", "Expected in tolerance: profile ", "As measured: in tolerance, profile 50.60 µm. Cut it.")]
    [InlineData("0.05", "Expected in tolerance: profile ", "As measured: out of tolerance, profile 50.60 µm. Cut it.")]
    [InlineData("0.004", "Not sure to be in tolerance: profile ", "As measured: out of tolerance, profile 50.60 µm.")]
    [InlineData(null, "Not judged: the job states no profile tolerance", "Profile as measured 50.60 µm")]
    public void A_compensation_begins_with_its_verdict(string? width, string start, string contained)
    {
        using var folder = new TemporaryFolder();
        string[] arguments = [Job(folder, width), "--measured", Repository.PathTo("samples", "surface-one", "measured.csv")];
        var compensated = Shell.Run(["surface", "compensate", .. arguments]);
        var displaced = Shell.Run(
            ["surface", "displace", .. arguments, "--program", Repository.PathTo("samples", "surface-one", "cam.nc")]);
        Assert.Equal(width == "0.004" ? (2, 2) : (0, 0), (compensated.Exit, displaced.Exit));
        var line = compensated.Output.Split('\n')[0];
        Assert.StartsWith(start, line, StringComparison.Ordinal);
        Assert.Contains(contained, line, StringComparison.Ordinal);
        Assert.Equal(line, displaced.Output.Split('\n')[0]);
    }

    private static (int Exit, string Output, string Error) Evaluate(string job, params string[] more) => Shell.Run([
        "surface", "evaluate", job, "--measured", Repository.PathTo("samples", "surface-one", "after.csv"), .. more]);

    private static string Job(TemporaryFolder folder, string? width)
    {
        var surface = Repository.PathTo("samples", "surface-one", "surface.igs").Replace('\\', '/');
        var text = File.ReadAllText(Repository.PathTo("samples", "surface-one", "job.json"))
            .Replace("surface.igs", surface, StringComparison.Ordinal);
        Assert.Contains(Stated, text, StringComparison.Ordinal);
        return folder.File(
            $"job{width}.json",
            text.Replace(Stated, width is null ? "" : $"\"profileToleranceMm\": {width},", StringComparison.Ordinal));
    }
}
