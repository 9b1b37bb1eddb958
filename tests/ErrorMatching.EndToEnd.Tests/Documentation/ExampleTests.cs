using System.Diagnostics;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>The programs in <c>examples/</c> run as built and do what their README says.</summary>
public sealed class ExampleTests
{
    [Fact]
    public async Task The_main_job_writes_the_console_s_program_and_says_its_verdict()
    {
        using var shop = new Workshop();
        var run = await RunAsync("MainJob", shop.Folder, "samples/complex-mating/job.json", "mine");
        var console = await shop.Run("match", "samples/complex-mating/job.json", "--out", "out");
        Assert.Equal(0, console.Exit);
        Assert.Equal((console.Output.Split('\n')[0] + "\n", 0), run);
        Assert.Equal(File.ReadAllBytes(shop["out", "counterpart.nc"]), File.ReadAllBytes(shop["mine", "counterpart.nc"]));
        Assert.True(File.Exists(shop["mine", "report.html"]));
    }

    [Fact]
    public async Task The_main_job_obeys_the_verdict_and_says_what_is_wrong()
    {
        using var shop = new Workshop();
        var withoutIt = await RunAsync("MainJob", shop.Folder, "none.json", "mine");
        Assert.Equal(1, withoutIt.Exit);
        Assert.Contains("none.json", withoutIt.Output, StringComparison.Ordinal);

        // A chip at point 9.
        var part = shop["samples", "complex-mating", "part.csv"];
        File.WriteAllText(part, File.ReadAllText(part).Replace("9,-36.827", "9,-36.527", StringComparison.Ordinal));
        var run = await RunAsync("MainJob", shop.Folder, "samples/complex-mating/job.json", "mine");
        Assert.Equal(2, run.Exit);
        Assert.Contains("Do not cut it before", run.Output, StringComparison.Ordinal);
        Assert.True(File.Exists(shop["mine", "report.html"]));
        Assert.False(File.Exists(shop["mine", "counterpart.nc"]));
    }

    [Fact]
    public async Task The_motions_of_a_program_are_listed()
    {
        using var shop = new Workshop();
        var program = shop["program.nc"];
        File.WriteAllText(program, "N10 G21 G90 G17 G0 X0. Y0.\nN20 G1 X10. F300\nN30 G2 X20. Y-10. I0. J-10.\nN40 G999\n");
        var (output, exit) = await RunAsync("ListMotions", shop.Folder, program, "fanuc");
        Assert.Equal(0, exit);
        Assert.Contains("N20: line to X10 Y0, 10 mm\nN30: arc to X20 Y-10, 15.708 mm\n", output, StringComparison.Ordinal);
        Assert.Contains("N40: ", output, StringComparison.Ordinal);
        Assert.Equal(1, (await RunAsync("ListMotions", shop.Folder, program, "fanoc")).Exit);
    }

    [Fact]
    public async Task A_dialect_of_one_s_own_knows_the_code_that_the_one_below_does_not() => Assert.Equal(
        ("fanuc: 3 motions, 1 problems\nour-mill: 3 motions, 0 problems\n", 0),
        await RunAsync("OwnDialect", Repository.Root));

    [Fact]
    public async Task A_format_of_one_s_own_reads_decimal_commas() => Assert.Equal(
        ("1: 10.003 0.098\n2: 39.998 0.102\n", 0),
        await RunAsync("OwnGaugeFormat", Repository.Root));

    [Fact]
    public async Task A_transport_of_one_s_own_overwrites_no_change_at_the_machine()
    {
        var (output, exit) = await RunAsync("OwnTransport", Repository.Root);
        Assert.Equal(0, exit);
        Assert.Matches(@"^sent: O1\.NC\nnot sent: O1\.NC at mill-2 changed", output);
    }

    [Fact]
    public void Each_example_is_named_in_the_README_and_tested_here()
    {
        var readme = File.ReadAllText(Repository.PathTo("examples", "README.md"));
        var examples = Directory.GetDirectories(Repository.PathTo("examples")).Select(Path.GetFileName).Order(StringComparer.Ordinal);
        Assert.Equal(["ListMotions", "MainJob", "OwnDialect", "OwnGaugeFormat", "OwnTransport"], examples);
        Assert.All(examples, e => Assert.Contains($"dotnet run --project examples/{e}", readme, StringComparison.Ordinal));
    }

    private static async Task<(string Output, int Exit)> RunAsync(string example, string folder, params string[] arguments)
    {
        var configuration = new DirectoryInfo(AppContext.BaseDirectory.TrimEnd(Path.DirectorySeparatorChar));
        var file = Path.Combine(
            configuration.Parent!.Parent!.FullName, example, configuration.Name, OperatingSystem.IsWindows() ? example + ".exe" : example);
        using var process = Process.Start(
            new ProcessStartInfo(file, arguments)
            {
                UseShellExecute = false,
                WorkingDirectory = folder,
                RedirectStandardOutput = true,
                RedirectStandardError = true,
            })!;
        var error = process.StandardError.ReadToEndAsync(TestContext.Current.CancellationToken);
        var output = await process.StandardOutput.ReadToEndAsync(TestContext.Current.CancellationToken);
        await process.WaitForExitAsync(TestContext.Current.CancellationToken);
        return ((output + await error).ReplaceLineEndings("\n"), process.ExitCode);
    }
}
