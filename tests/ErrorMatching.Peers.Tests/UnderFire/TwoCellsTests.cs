using ErrorMatching.EndToEnd.Tests;

namespace ErrorMatching.Peers.Tests;

/// <summary>Two cells with the same slots on one PostgreSQL server: they never send to one slot at once, whichever of them dies.</summary>
[Collection(PostgresTests.Name)]
public sealed class TwoCellsTests(PostgresServer server)
{
    [Fact]
    public async Task Two_cells_never_send_to_one_slot_at_once()
    {
        PostgresServer.IsNeeded();
        var token = TestContext.Current.CancellationToken;
        var settings = server.NewDatabase();
        var store = server.StoreOf(settings);
        using var first = new FireCell(slots: 3, store, name: "First");
        using var second = new FireCell(
            slots: 3,
            store,
            transport: $$"""{ "kind": "folder", "folder": "{{first.Machine}}" }""",
            machine: first.Machine,
            name: "Second",
            keys: first["keys"]);
        var files = new FireFiles();
        await using var machine = new FireMachine(first, () => files.FileByProgram);
        using var writers = new SlotWriters(first.Machine);
        var pieces = Enumerable.Range(0, 24).Select(i => files.Next(first.Slots[i % 3], i)).ToArray();
        first.Start();
        second.Start();
        for (var i = 0; i < pieces.Length; i++)
        {
            (i % 2 == 0 ? first : second).Drop(pieces[i].Name, pieces[i].Bytes);
            if (i == 30)
            {
                await second.Kill();
                second.Start();
            }

            await Task.Delay(20, token);
        }

        await first.Until(() => Task.FromResult(machine.Cut.Count >= pieces.Length), TimeSpan.FromMinutes(5), "all cut");
        await first.Until(
            async () => (await first.History()).Count(c => c.GetProperty("state").GetString() == "released") == pieces.Length,
            TimeSpan.FromMinutes(5),
            "all released");
        await first.Stop();
        await second.Stop();
        await first.Until(() => Task.FromResult(writers.Seen >= pieces.Length), TimeSpan.FromMinutes(2), "a transfer seen for each piece");

        Assert.Empty(machine.Wrong);
        Assert.Empty(writers.AtOnce);
        Assert.Equal(
            pieces.Select(p => p.Name).Order(StringComparer.Ordinal), machine.Cut.Select(c => c.File).Order(StringComparer.Ordinal));
        await first.AuditHolds();
    }
}
