using System.Diagnostics;
using ErrorMatching.Testing;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>The programs in <c>examples/</c> run as built and do what their README says.</summary>
public sealed class ExampleTests
{
    [Fact]
    public async Task The_main_job_in_ten_lines_writes_the_console_s_program()
    {
        using var shop = new Workshop();
        var run = await RunAsync("MainJob", shop.Folder, "samples/complex-mating/job.json", "mine");
        Assert.Equal(("The proof holds: counterpart.nc\n", 0), run);
        var console = await shop.Run("match", "samples/complex-mating/job.json", "--out", "out");
        Assert.Equal(0, console.Exit);
        Assert.Equal(File.ReadAllBytes(shop["out", "counterpart.nc"]), File.ReadAllBytes(shop["mine", "counterpart.nc"]));
        Assert.True(File.Exists(shop["mine", "report.html"]));
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
        Assert.Equal(["MainJob", "OwnDialect", "OwnGaugeFormat", "OwnTransport"], examples);
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
