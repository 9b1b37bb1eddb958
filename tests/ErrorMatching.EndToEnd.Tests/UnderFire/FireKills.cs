using System.Diagnostics;
using System.Text.Json;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>A cell that is killed again and again under load.</summary>
internal static class FireKills
{
    /// <summary>Kills a cell again and again under load, lets it come to an end, and looks at everything.</summary>
    public static async Task Run(FireCell cell, int kills, int seed)
    {
        var token = TestContext.Current.CancellationToken;
        var clock = Stopwatch.StartNew();
        var random = new Random(seed);
        var files = new FireFiles();
        var measured = Enumerable.Range(0, kills * 4).Select(i => files.Next(cell.Slots[i % cell.Slots.Count], i)).ToArray();
        await using var machine = new FireMachine(cell, () => files.FileByProgram);
        var dropped = 0;
        var halves = new HashSet<string>(StringComparer.Ordinal);
        for (var kill = 0; kill < kills; kill++)
        {
            cell.Start();

            // One of four dies anywhere while it starts; the others work when they do, on a slow computer too.
            if (kill % 4 != 0)
            {
                await cell.HasBegun();
            }

            for (var end = random.Next(1, 1200); end > 0;)
            {
                if (dropped < (kill + 1) * 4)
                {
                    cell.Drop(measured[dropped].Name, measured[dropped].Bytes);
                    dropped++;
                }

                var pause = Math.Min(end, random.Next(1, 150));
                await Task.Delay(pause, token);
                end -= pause;
            }

            await cell.Kill(withTools: kill % 2 == 0);
            halves.UnionWith(Directory.EnumerateFiles(cell.Machine, "*.emnew"));
        }

        foreach (var (name, bytes) in measured[dropped..])
        {
            cell.Drop(name, bytes);
        }

        cell.Start();
        await cell.Until(
            () => Task.FromResult(machine.Cut.Count >= measured.Length),
            TimeSpan.FromSeconds(300 + (3 * kills)),
            $"{measured.Length} programs cut");
        await cell.Until(
            async () => (await cell.History()).Count(c => State(c) == "released") == measured.Length,
            TimeSpan.FromMinutes(5),
            "all released");
        await cell.Stop();

        Assert.Empty(machine.Wrong);
        Assert.Equal(
            measured.Select(m => m.Name).Order(StringComparer.Ordinal), machine.Cut.Select(c => c.File).Order(StringComparer.Ordinal));
        var history = await cell.History();
        Assert.Equal(
            measured.Select(m => m.Name).Order(StringComparer.Ordinal),
            history.Where(c => State(c) == "released").Select(c => c.GetProperty("fileName").GetString()).Order(StringComparer.Ordinal));
        Assert.All(history, c => Assert.True(State(c) is "released" or "refused", c.ToString()));
        Assert.Empty(Directory.EnumerateFiles(cell.Incoming));
        Assert.Equal(
            cell.Slots.Select(FireCell.ProgramOf).Order(StringComparer.Ordinal),
            Directory.EnumerateFiles(cell.Machine)
                .Select(f => Path.GetFileName(f))
                .Where(f => !f.EndsWith(".READY", StringComparison.Ordinal))
                .Order(StringComparer.Ordinal));
        await cell.AuditHolds();
        TestContext.Current.TestOutputHelper!.WriteLine(
            $"{kills} kills, {halves.Count} programs cut off while they were written to the machine; {measured.Length} measurements, "
                + $"each cut once; {history.Count} corrections in {clock.Elapsed.TotalSeconds:0} s");
    }

    private static string? State(JsonElement correction) => correction.GetProperty("state").GetString();
}
