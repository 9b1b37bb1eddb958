using ErrorMatching.Cell;
using ErrorMatching.EndToEnd.Tests;

namespace ErrorMatching.Peers.Tests;

/// <summary>The built console runs a cell that publishes: its process and the broker are killed, and no correction waits.</summary>
public sealed class KilledCellTests
{
    [Fact]
    public async Task Every_step_of_every_correction_is_published_once_by_identity()
    {
        MosquittoPeer.IsNeeded();
        using var broker = new MosquittoPeer();
        using var cell = new FireCell(slots: 2);
        cell.Configure(FormattableString.Invariant($$"""
            "events": {
              "host": "127.0.0.1", "port": {{broker.Port}}, "topic": "{{MosquittoPeer.Topic}}",
              "user": "{{MosquittoPeer.User}}", "passwordFile": "{{broker.PasswordFile}}", "caFile": "{{broker.AuthorityFile}}"
            }
            """));
        var files = new FireFiles();
        await using var machine = new FireMachine(cell, () => files.FileByProgram);
        await using var plant = new PlantSubscriber(broker);
        await plant.IsThere();
        var pieces = Enumerable.Range(0, 6).Select(i => files.Next(cell.Slots[i % 2], i)).ToArray();
        cell.Start();
        await cell.HasBegun();
        Array.ForEach(pieces[..4], p => cell.Drop(p.Name, p.Bytes));
        await PlantSubscriber.Until(() => plant.ById.Count > 3);
        await cell.Kill();
        broker.Kill();

        // The broker is away, and everything goes on.
        cell.Start();
        Array.ForEach(pieces[4..], p => cell.Drop(p.Name, p.Bytes));
        await cell.Until(() => Task.FromResult(machine.Cut.Count >= 6), TimeSpan.FromMinutes(2), "all cut without a broker");

        // All may be cut before the first attempt to reach the broker has failed.
        await cell.Until(
            async () => (await ConsoleRun.Of(cell.Folder, "cell", "status", cell.Configuration, "--json")).Json.GetProperty("problems")
                .EnumerateArray().Any(p => p.GetProperty("code").ValueEquals("broker-away")),
            TimeSpan.FromMinutes(1),
            "status says that the broker is away");
        broker.Start();
        await PlantSubscriber.Until(() => plant.ById.Count >= Steps(cell).Count);
        await cell.Stop();

        Assert.Equal(Steps(cell), plant.ById.Select(PlantSubscriber.Id));
        Assert.Equal(
            pieces.Select(p => p.Name).Order(StringComparer.Ordinal),
            plant.ById.Where(m => m.GetProperty("to").ValueEquals("verified")).Select(m => m.GetProperty("file").GetString()!)
                .Order(StringComparer.Ordinal));
        var said = cell.Said + string.Concat(Directory.GetFiles(cell["logs"]).Select(File.ReadAllText));
        Assert.DoesNotContain(MosquittoPeer.Password.Trim(), said, StringComparison.Ordinal);
    }

    private static IReadOnlyList<string> Steps(FireCell cell)
    {
        using var store = CellStore.OpenToRead(new SqliteSettings(cell["store", "cell.db"]), TimeProvider.System, null);
        return [.. store.AuditEntries(0, int.MaxValue).Where(e => CorrectionRow.StateOrNull(e.What) is not null).Select(e => e.Hash)];
    }
}
