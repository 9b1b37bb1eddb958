using System.Diagnostics;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>The sample as its README runs it: the built console, a file that is dropped, a folder as the machine, and a signal.</summary>
[Trait("Runs", "Console")]
public sealed class SampleCellTests
{
    private const string Config = "samples/cell/cell.json";
    private const string Program = "samples/cell/machine/counterpart.nc";

    [Fact]
    public async Task A_dropped_part_becomes_the_machines_program_and_a_signal_ends_the_cell()
    {
        using var shop = new Workshop();
        using var cell = new RunningConsole(shop, Config);
        Drop(shop);
        await Until(() => File.Exists(shop[Program]));
        await Until(() => Status(shop).Contains("\"state\": \"verified\"", StringComparison.Ordinal));

        // What match writes for the same inputs is what the machine gets.
        Assert.Equal(0, (await shop.Run("match samples/complex-mating/job.json --out out")).Exit);
        Assert.Equal(File.ReadAllBytes(shop["out/counterpart.nc"]), File.ReadAllBytes(shop[Program]));

        File.WriteAllText(shop["samples/cell/machine/A.READY"], "");
        await Until(() => !File.Exists(shop["samples/cell/machine/A.READY"]));
        Assert.Contains("\"released\"", (await shop.Run($"cell history {Config} --json")).Output, StringComparison.Ordinal);
        Assert.Equal(0, await cell.EndAsync());
        if (ConsoleRun.HasSignals)
        {
            // What was killed is missed only when it has been silent for a while.
            Assert.Equal(3, (await shop.Run("cell status " + Config)).Exit);
        }

        // Who approves within what is part of the evidence.
        var trail = (await shop.Run("audit export " + Config)).Output;
        var configuration = Workshop.Sha256(shop[Config]);
        Assert.Contains(
            $"\"cell\",\"started\",\"Sample cell\",\"configuration {configuration}; policy automatic, limit 0.5 mm, sum none of its own, "
                + $"gain the job's\"",
            trail,
            StringComparison.Ordinal);
        Assert.Equal(
            ConsoleRun.HasSignals,
            trail.Contains("\"cell\",\"stopped\",\"Sample cell\",\"told to stop\"", StringComparison.Ordinal));
    }

    [Fact]
    public async Task A_cell_that_is_killed_goes_on_where_it_was()
    {
        using var shop = new Workshop();
        using (var killed = new RunningConsole(shop, Config))
        {
            await Until(() => Status(shop).Contains("\"running\": true", StringComparison.Ordinal));
            Drop(shop);
            await Until(() => Status(shop).Contains("part-0001.csv", StringComparison.Ordinal));
            await killed.KillAsync();
        }

        using var cell = new RunningConsole(shop, Config);
        await Until(() => Status(shop).Contains("\"state\": \"verified\"", StringComparison.Ordinal));
        Assert.Equal(0, (await shop.Run("match samples/complex-mating/job.json --out out")).Exit);
        Assert.Equal(File.ReadAllBytes(shop["out/counterpart.nc"]), File.ReadAllBytes(shop[Program]));
        Assert.Equal(0, (await shop.Run("audit verify " + Config)).Exit);
        Assert.Equal(0, await cell.EndAsync());
    }

    // Under its name only when it is whole: a copy may take longer than the gauge's files are to rest.
    private static void Drop(Workshop shop)
    {
        File.Copy(shop["samples/complex-mating/part.csv"], shop["samples/cell/copied"]);
        File.Move(shop["samples/cell/copied"], shop["samples/cell/incoming/part-0001.csv"]);
    }

    private static string Status(Workshop shop) => shop.Run($"cell status {Config} --json").GetAwaiter().GetResult().Output;

    /// <summary>Waits until something holds, for at most two minutes.</summary>
    internal static async Task Until(Func<bool> holds)
    {
        var began = Stopwatch.GetTimestamp();
        while (!holds())
        {
            Assert.True(Stopwatch.GetElapsedTime(began) < TimeSpan.FromMinutes(2), "It did not come about within 2 min.");
            await Task.Delay(100, TestContext.Current.CancellationToken);
        }
    }
}
