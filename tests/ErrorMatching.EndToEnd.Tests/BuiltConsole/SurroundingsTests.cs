using System.Text.RegularExpressions;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>Results depend on the inputs and on nothing around them.</summary>
[Trait("Runs", "Console")]
public sealed partial class SurroundingsTests
{
    [Theory]
    [InlineData("match samples/complex-mating/job.json")]
    [InlineData("match samples/complex-mating/job.json --json")]
    [InlineData(
        "verify samples/complex-mating/job.json --before samples/complex-mating/counterpart.csv --after "
            + "samples/complex-mating/counterpart-after.csv")]
    [InlineData("nc motion samples/complex-mating/counterpart.nc")]
    [InlineData("nc displace samples/complex-mating/counterpart.nc --blocks N130..N160 --normal -0.02 --out out/d.nc --json")]
    [InlineData("fit polynomial samples/fits/curve.csv --degree auto --json")]
    [InlineData("match samples/fits/line.csv")]
    public async Task Language_and_time_zone_change_nothing(string line)
    {
        using var shop = new Workshop();
        string[] arguments = line.Split(' ');
        var plain = await ConsoleRun.Of(
            shop.Folder, new Dictionary<string, string?> { ["LANG"] = "C", ["LC_ALL"] = "C", ["TZ"] = "UTC" }, arguments);
        var german = await ConsoleRun.Of(
            shop.Folder,
            new Dictionary<string, string?>
            {
                ["LANG"] = "de_DE.UTF-8",
                ["LC_ALL"] = "de_DE.UTF-8",
                ["LANGUAGE"] = "de",
                ["TZ"] = "Asia/Kolkata",
                ["DOTNET_SYSTEM_GLOBALIZATION_INVARIANT"] = null
            },
            arguments);
        Assert.Equal((plain.Exit, Timeless(plain.Output), plain.Error), (german.Exit, Timeless(german.Output), german.Error));
    }

    [Fact]
    public async Task The_same_inputs_give_the_same_program()
    {
        using var shop = new Workshop();
        foreach (var folder in new[] { "a", "b" })
        {
            Assert.Equal(0, (await shop.Run($"match samples/complex-mating/job.json --out {folder}")).Exit);
        }

        Assert.Equal(Workshop.Sha256(shop["a", "counterpart.nc"]), Workshop.Sha256(shop["b", "counterpart.nc"]));
    }

    // The runtime uses no special instruction of the processor then, and glibc chooses other functions than on one with FMA.
    [Theory]
    [InlineData("match samples/complex-mating/job.json --out")]
    [InlineData("surface compensate samples/surface-one/job.json --measured samples/surface-one/measured.csv --out")]
    public async Task A_simpler_processor_gives_the_same_bytes(string line)
    {
        using var shop = new Workshop();
        Assert.Equal(0, (await shop.Run(line + " out")).Exit);
        Directory.Move(shop["out"], shop["expected"]);
        var simple = new Dictionary<string, string?>
        {
            ["DOTNET_EnableHWIntrinsic"] = "0",
            ["GLIBC_TUNABLES"] = "glibc.cpu.hwcaps=-AVX2,-FMA,-AVX2_Usable,-FMA_Usable",
        };
        Assert.Equal(0, (await ConsoleRun.Of(shop.Folder, simple, [.. line.Split(' '), "out"])).Exit);
        string[] files = [.. Directory.EnumerateFiles(shop["out"]).Select(f => Path.GetFileName(f)).Order(StringComparer.Ordinal)];
        Assert.Equal(Directory.EnumerateFiles(shop["expected"]).Select(f => Path.GetFileName(f)).Order(StringComparer.Ordinal), files);
        Assert.Contains("report.json", files);
        Assert.All(files, f => Assert.True(
            Timeless(File.ReadAllText(shop["expected", f])) == Timeless(File.ReadAllText(shop["out", f])), $"{f} differs."));
    }

    [Fact]
    public async Task Relative_paths_of_a_job_start_from_its_folder_and_those_of_the_command_line_from_the_current_one()
    {
        using var shop = new Workshop();
        var run = await ConsoleRun.Of(
            shop["samples", "curve-mating"],
            "match",
            "../complex-mating/job.json",
            "--part",
            "../complex-mating/part.csv",
            "--out",
            "here",
            "--json");
        Assert.Equal((0, ""), (run.Exit, run.Error));
        Assert.True(File.Exists(shop["samples", "curve-mating", "here", "counterpart.nc"]));
    }

    // The one number that a clock gives.
    private static string Timeless(string output) => Calculating().Replace(output, "");

    [GeneratedRegex(
        "\"calculatingS\": [0-9.eE-]+|this calculation took [0-9.]+ s|Calculating: [0-9.]+ s|Calculated in</dt>\\s*<dd>[0-9.]+ s",
        RegexOptions.None,
        1000)]
    private static partial Regex Calculating();
}
