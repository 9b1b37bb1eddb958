using System.Text.Json;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>The improvements that Wang, Tu and Gunawan (Sensors 2021, 21, 7660) publish,
/// from the samples through the built console.</summary>
[Trait("Runs", "Console")]
public sealed class VerifyTests
{
    [Theory]
    [InlineData("L1-L2", "angle", 0.594, 0.113, 81)]
    [InlineData("L2L3", "angle", 0.930, 0.118, 87)]
    [InlineData("C1 in x", "deviation-x", 0.137, 0.029, 79)]
    public async Task The_complex_mating_improves_as_published(string name, string quantity, double before, double after, int percent)
    {
        var report = await Verify("complex-mating");
        var feature = Assert.Single(
            report.GetProperty("features").EnumerateArray(),
            f => f.GetProperty("name").GetString() == name && f.GetProperty("quantity").GetString() == quantity);
        var wanted = feature.GetProperty("wanted").GetDouble();
        Assert.Equal(before, Math.Abs(feature.GetProperty("before").GetDouble() - wanted), 0.0006);
        Assert.Equal(after, Math.Abs(feature.GetProperty("after").GetDouble() - wanted), 0.0006);
        Assert.Equal(percent, Math.Round(feature.GetProperty("improvementPercent").GetDouble()));
    }

    [Fact]
    public async Task The_corner_of_the_complex_mating_is_as_far_off_as_published()
    {
        var corner = Assert.Single(
            (await Verify("complex-mating")).GetProperty("points").EnumerateArray(), p => p.GetProperty("point").GetString() == "4");
        Assert.Equal(0.371, corner.GetProperty("before").GetProperty("dx").GetDouble(), 1e-9);
        Assert.Equal(0.391, corner.GetProperty("after").GetProperty("dx").GetDouble(), 1e-9);
    }

    [Fact]
    public async Task The_curve_mating_is_left_with_the_published_error()
    {
        var curve = Assert.Single(
            (await Verify("curve-mating")).GetProperty("features").EnumerateArray(),
            f => f.GetProperty("quantity").GetString() == "deviation-x");
        Assert.Equal(0.320, curve.GetProperty("before").GetDouble(), 1e-9);
        Assert.Equal(0.048, curve.GetProperty("after").GetDouble(), 1e-9);
    }

    [Fact]
    public async Task The_largest_errors_are_those_of_the_points()
    {
        var report = await Verify("complex-mating");
        foreach (var side in new[] { "before", "after" })
        {
            var largest = report.GetProperty("points")
                .EnumerateArray()
                .Max(p => Math.Abs(p.GetProperty(side).GetProperty("normalMm").GetDouble()));
            Assert.Equal(largest, report.GetProperty(side == "before" ? "maxBeforeMm" : "maxAfterMm").GetDouble());
        }
    }

    [Fact]
    public async Task The_document_is_written_as_it_is_printed()
    {
        using var shop = new Workshop();
        var run = await shop.Run($"{Line("complex-mating")} --out out --json");
        Assert.Equal(0, run.Exit);
        Assert.Equal(run.Output, File.ReadAllText(shop["out", "verify.json"]));
        Assert.StartsWith("<!DOCTYPE html>", File.ReadAllText(shop["out", "verify.html"]), StringComparison.OrdinalIgnoreCase);
    }

    [Theory]
    [InlineData("out/verify.qif")]
    [InlineData("out/verify.dfq")]
    public async Task What_is_written_for_other_systems_is_read_as_the_counterpart_that_was_measured(string file)
    {
        using var shop = new Workshop();
        var first = await shop.Run($"{Line("complex-mating")} --out out --json");
        var again = await shop.Run($"{Line("complex-mating").Split(" --after ")[0]} --after {file} --json");
        Assert.Equal((0, 0), (first.Exit, again.Exit));
        Assert.Equal(
            first.Json.GetProperty("points").EnumerateArray().Select(p => p.GetProperty("after").GetProperty("normalMm").GetDouble()),
            again.Json.GetProperty("points").EnumerateArray().Select(p => p.GetProperty("after").GetProperty("normalMm").GetDouble()),
            (a, b) => Math.Abs(a - b) < 2e-6);
        Assert.Equal(first.Json.GetProperty("maxAfterMm").GetDouble(), again.Json.GetProperty("maxAfterMm").GetDouble(), 2e-6);
    }

    [Theory]
    [InlineData("out/evaluation.qif")]
    [InlineData("out/evaluation.dfq")]
    public async Task What_is_written_of_a_surface_is_read_as_the_piece_that_was_measured(string file)
    {
        using var shop = new Workshop();
        const string evaluate = "surface evaluate samples/surface-one/job.json --measured";
        var first = await shop.Run($"{evaluate} samples/surface-one/after.csv --out out --json");
        var again = await shop.Run($"{evaluate} {file} --json");
        Assert.Equal((0, 0), (first.Exit, again.Exit));
        foreach (var figure in new[] { "meanUm", "standardDeviationUm", "profileIsoUm", "profileRangeUm" })
        {
            Assert.Equal(first.Json.GetProperty(figure).GetDouble(), again.Json.GetProperty(figure).GetDouble(), 0.003);
        }
    }

    [Fact]
    public async Task Each_of_several_pieces_has_its_own_files_for_other_systems()
    {
        using var shop = new Workshop();
        var run = await shop.Run(
            "surface evaluate samples/surface-one/job.json --out out "
                + "--measured samples/surface-one/after.csv samples/surface-one/measured.csv");
        Assert.Equal(0, run.Exit);
        Assert.Equal(
            ["evaluation-1.dfq", "evaluation-1.qif", "evaluation-2.dfq", "evaluation-2.qif", "evaluation.html", "evaluation.json"],
            Directory.GetFiles(shop["out"]).Select(f => Path.GetFileName(f)).Order(StringComparer.Ordinal));
    }

    private static string Line(string sample) =>
        $"verify samples/{sample}/job.json --before samples/{sample}/counterpart.csv --after samples/{sample}/counterpart-after.csv";

    private static async Task<JsonElement> Verify(string sample)
    {
        using var shop = new Workshop();
        var run = await shop.Run(Line(sample) + " --json");
        Assert.Equal((0, ""), (run.Exit, run.Error));
        Assert.Equal("errormatch/verify/1", run.Json.GetProperty("schema").GetString());
        return run.Json;
    }
}
