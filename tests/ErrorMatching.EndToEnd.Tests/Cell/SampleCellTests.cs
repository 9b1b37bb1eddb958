using System.Diagnostics;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>The sample as its README runs it: the built console, a file that is dropped, a folder as the machine, and a signal.</summary>
public sealed class SampleCellTests
{
    private const string Config = "samples/cell/cell.json";
    private const string Program = "samples/cell/machine/counterpart.nc";

    [Fact]
    public async Task A_dropped_part_becomes_the_machines_program_and_a_signal_ends_the_cell()
    {
        using var shop = new Workshop();
        using var cell = Start(shop);
        File.Copy(shop["samples/complex-mating/part.csv"], shop["samples/cell/incoming/part-0001.csv"]);
        await Until(() => File.Exists(shop[Program]));
        await Until(() => Status(shop).Contains("\"state\": \"verified\"", StringComparison.Ordinal));

        // What match writes for the same inputs is what the machine gets.
        Assert.Equal(0, (await shop.Run("match samples/complex-mating/job.json --out out")).Exit);
        Assert.Equal(File.ReadAllBytes(shop["out/counterpart.nc"]), File.ReadAllBytes(shop[Program]));

        File.WriteAllText(shop["samples/cell/machine/A.READY"], "");
        await Until(() => !File.Exists(shop["samples/cell/machine/A.READY"]));
        Assert.Contains("\"released\"", (await shop.Run($"cell history {Config} --json")).Output, StringComparison.Ordinal);
        Assert.Equal(0, await End(cell));
        Assert.Equal(3, (await shop.Run("cell status " + Config)).Exit);
    }

    [Fact]
    public async Task A_cell_that_is_killed_goes_on_where_it_was()
    {
        using var shop = new Workshop();
        using (var killed = Start(shop))
        {
            await Until(() => Status(shop).Contains("\"running\": true", StringComparison.Ordinal));
            File.Copy(shop["samples/complex-mating/part.csv"], shop["samples/cell/incoming/part-0001.csv"]);
            await Until(() => Status(shop).Contains("part-0001.csv", StringComparison.Ordinal));
            killed.Kill();
            await killed.WaitForExitAsync(TestContext.Current.CancellationToken);
        }

        using var cell = Start(shop);
        await Until(() => Status(shop).Contains("\"state\": \"verified\"", StringComparison.Ordinal));
        Assert.Equal(0, (await shop.Run("match samples/complex-mating/job.json --out out")).Exit);
        Assert.Equal(File.ReadAllBytes(shop["out/counterpart.nc"]), File.ReadAllBytes(shop[Program]));
        Assert.Equal(0, (await shop.Run("audit verify " + Config)).Exit);
        Assert.Equal(0, await End(cell));
    }

    private static Process Start(Workshop shop)
    {
        var start = new ProcessStartInfo(ConsoleRun.Executable, ["cell", "run", Config]) { UseShellExecute = false, WorkingDirectory = shop.Folder, RedirectStandardError = true, RedirectStandardOutput = true };
        var process = Process.Start(start)!;
        process.BeginErrorReadLine();
        process.BeginOutputReadLine();
        return process;
    }

    // Windows has no such signal: there the process just ends.
    private static async Task<int> End(Process cell)
    {
        if (OperatingSystem.IsWindows())
        {
            cell.Kill();
            await cell.WaitForExitAsync(TestContext.Current.CancellationToken);
            return 0;
        }

        return await FireStop.Of(cell);
    }

    private static string Status(Workshop shop) => shop.Run($"cell status {Config} --json").GetAwaiter().GetResult().Output;

    private static async Task Until(Func<bool> holds)
    {
        var since = Stopwatch.StartNew();
        while (!holds())
        {
            Assert.True(since.Elapsed < TimeSpan.FromMinutes(3), "It did not come about within 3 minutes.");
            await Task.Delay(100);
        }
    }
}
