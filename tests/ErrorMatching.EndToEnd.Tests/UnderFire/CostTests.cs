using System.Diagnostics;
using System.Globalization;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>What a correction costs the processors, from the dropped file to the released program: the sample's cell, piece by
/// piece.</summary>
/// <remarks>It prints figures and judges none: <c>tests/fire cost 200</c>.</remarks>
[Trait("Runs", "Console")]
public sealed class CostTests
{
    private const string Cell = "samples/cell/";

    [Fact]
    public async Task A_correction_costs_so_much_processor_time()
    {
        var asked = Environment.GetEnvironmentVariable("ERRORMATCH_COST");
        Assert.SkipWhen(asked is null, "Figures are measured by tests/fire cost.");
        var pieces = int.Parse(asked!, CultureInfo.InvariantCulture);
        using var shop = new Workshop();
        using var cell = new RunningConsole(shop, Cell + "cell.json");
        var lines = File.ReadAllLines(shop["samples/complex-mating/part.csv"]);
        var (random, told) = (new Random(42), new List<(TimeSpan Used, long At)>());
        await SampleCellTests.Until(() => File.Exists(shop[Cell + "run/cell.db"]));
        for (var piece = 0; piece <= pieces; piece++)
        {
            told.Add((cell.ProcessorTime, Stopwatch.GetTimestamp()));
            if (piece == pieces) break;

            // No two files are alike: the same content twice is one measurement.
            var file = lines.Select((line, i) => i == 0 ? line : string.Join(
                ',',
                line.Split(',').Select((cell, column) => column == 0
                    ? cell
                    : (double.Parse(cell, CultureInfo.InvariantCulture) + 0.001 * (random.NextDouble() - 0.5))
                        .ToString("0.0000", CultureInfo.InvariantCulture))));
            File.WriteAllLines(shop[Cell + "copied"], file);
            var before = Program();
            File.Move(shop[Cell + "copied"], shop[$"{Cell}incoming/part-{piece + 1000}.csv"]);
            await SampleCellTests.Until(() => Program() is { } now && now != before);
            var ready = shop[Cell + "machine/A.READY"];
            File.WriteAllText(ready, "");
            await SampleCellTests.Until(() => !File.Exists(ready));
        }

        // What it uses while nothing comes.
        await Task.Delay(TimeSpan.FromSeconds(10), TestContext.Current.CancellationToken);
        var idle = (cell.ProcessorTime - told[^1].Used) / Stopwatch.GetElapsedTime(told[^1].At);
        foreach (var (from, to) in new[] { (0, 20), (20, 50), (50, pieces) }.Where(r => r.Item2 <= pieces && r.Item1 < r.Item2))
        {
            var used = (told[to].Used - told[from].Used) / (to - from);
            var anyway = idle * Stopwatch.GetElapsedTime(told[from].At, told[to].At) / (to - from);
            TestContext.Current.TestOutputHelper!.WriteLine(string.Create(
                CultureInfo.InvariantCulture,
                $"pieces {from + 1} to {to}: {used.TotalMilliseconds:0} ms each; idle: {anyway.TotalMilliseconds:0} ms in that time"));
        }

        TestContext.Current.TestOutputHelper!.WriteLine(
            string.Create(CultureInfo.InvariantCulture, $"idle: {idle:P1} of a core, {cell.Memory / 1e6:0} MB"));
        Assert.Equal(pieces + 1, told.Count);

        string? Program() => File.Exists(shop[Cell + "machine/counterpart.nc"])
            ? Workshop.Sha256(shop[Cell + "machine/counterpart.nc"])
            : null;
    }
}
