using System.Diagnostics;
using System.Globalization;
using ErrorMatching.Cell;
using ErrorMatching.Testing;

namespace ErrorMatching.Peers.Tests;

/// <summary>Steps are published to a real broker while broker and publisher are killed: who counts by identity gets each exactly once, in
/// order.</summary>
public sealed class BrokerKillTests(ITestOutputHelper output)
{
    private static readonly int Kills = int.Parse(
        Environment.GetEnvironmentVariable("ERRORMATCH_KILLS") ?? "8", CultureInfo.InvariantCulture);

    private static readonly int Waiting = int.Parse(
        Environment.GetEnvironmentVariable("ERRORMATCH_BACKLOG") ?? "500", CultureInfo.InvariantCulture);

    [Fact]
    public async Task Each_step_is_there_once_by_identity_whoever_is_killed()
    {
        MosquittoPeer.IsNeeded();
        using var broker = new MosquittoPeer();
        await using var cell = new PublishedCell(broker.Settings);
        await using var plant = new PlantSubscriber(broker);
        await plant.IsThere();
        var random = new Random(29);
        for (var i = 0; i < Kills; i++)
        {
            // The plant is away in every third round: the broker holds for it what it has acknowledged.
            plant.IsAway = i % 3 == 2;
            var heard = plant.ById.Count;
            cell.Arrive(20);
            await PlantSubscriber.Until(() => plant.IsAway ? cell.Flow.Troubles.Open.Count == 0 : plant.ById.Count > heard);
            cell.Arrive(10);
            await Task.Delay(random.Next(plant.IsAway ? 300 : 30), TestContext.Current.CancellationToken);
            if (random.Next(2) == 0)
            {
                broker.Kill();
                broker.Start();
            }
            else
            {
                await cell.KillAsync();
                cell.Begin();
            }
        }

        plant.IsAway = false;
        await PlantSubscriber.Until(() => plant.ById.Count >= Kills * 30);
        await cell.StopAsync();
        cell.Begin();

        Assert.Equal(Kills * 30, cell.Expected.Count);
        Assert.Equal(cell.Expected, plant.ById.Select(PlantSubscriber.Id));
        output.WriteLine($"{Kills} kills: {plant.Raw.Count - (Kills * 30)} of {plant.Raw.Count} messages came again.");
        Assert.All(
            plant.Raw.GroupBy(PlantSubscriber.Id, StringComparer.Ordinal),
            same => Assert.Single(same.Select(m => m.GetRawText()).Distinct(StringComparer.Ordinal)));
    }

    [Fact]
    public async Task What_waits_while_the_broker_is_away_is_sent_in_order_afterwards()
    {
        MosquittoPeer.IsNeeded();
        using var broker = new MosquittoPeer();
        await using var plant = new PlantSubscriber(broker);
        await plant.IsThere();
        broker.Kill();
        await using var cell = new PublishedCell(broker.Settings);
        cell.Arrive(Waiting);
        await PlantSubscriber.Until(() => cell.Flow.Troubles.Open.Any(t => t is { Where: "events", Code: "broker-away" }));

        broker.Start();
        await PlantSubscriber.Until(() => plant.Raw.Count > 0);
        var begun = Stopwatch.GetTimestamp();
        await PlantSubscriber.Until(() => plant.Raw.Count >= Waiting);
        output.WriteLine($"{Waiting} steps in {Stopwatch.GetElapsedTime(begun).TotalSeconds:0.0} s.");

        Assert.Equal(cell.Expected, plant.ById.Select(PlantSubscriber.Id));
        await PlantSubscriber.Until(() => cell.Flow.Troubles.Open.Count == 0);
    }

    [Fact]
    public async Task Who_stops_in_order_sends_nothing_again_that_the_broker_has_kept_long_enough()
    {
        MosquittoPeer.IsNeeded();
        using var broker = new MosquittoPeer();
        await using var plant = new PlantSubscriber(broker);
        await plant.IsThere();
        await using var cell = new PublishedCell(broker.Settings, settle: TimeSpan.FromMilliseconds(200));
        cell.Arrive(30);
        var cursor = new EventCursor(cell.Store, "Cell 1");
        await PlantSubscriber.Until(() => plant.Raw.Count >= 30 && cursor.Read() == cell.Store.AuditHead().Seq);
        await cell.StopAsync();
        cell.Begin();
        cell.Arrive();
        await PlantSubscriber.Until(() => plant.ById.Count >= 31);

        Assert.Equal(cell.Expected, plant.Raw.Select(PlantSubscriber.Id));
    }

    [Fact]
    public async Task No_step_is_lost_if_the_broker_dies_right_after_an_orderly_stop()
    {
        MosquittoPeer.IsNeeded();

        // The plant is away, and the broker's disk has nothing of what it acknowledges.
        using var broker = new MosquittoPeer(savedEveryS: 3600);
        await using var plant = new PlantSubscriber(broker);
        await plant.IsThere();
        plant.IsAway = true;
        await PlantSubscriber.Until(() => !plant.IsConnected);
        broker.Save();
        await using var cell = new PublishedCell(broker.Settings);
        await using (var other = new PlantSubscriber(broker, "other"))
        {
            await other.IsThere();
            cell.Arrive(19);
            await PlantSubscriber.Until(() => other.ById.Count >= 19);
        }

        await cell.StopAsync();
        broker.Kill();
        broker.Start();
        plant.IsAway = false;
        cell.Begin();
        await PlantSubscriber.Until(() => plant.ById.Count >= 19);

        Assert.Equal(cell.Expected, plant.ById.Select(PlantSubscriber.Id));
    }

    [Fact]
    public async Task What_the_broker_may_have_forgotten_is_sent_again()
    {
        MosquittoPeer.IsNeeded();
        using var broker = new MosquittoPeer();
        await using var plant = new PlantSubscriber(broker);
        await plant.IsThere();
        await using var cell = new PublishedCell(broker.Settings, settle: TimeSpan.FromHours(1));
        cell.Arrive(30);
        await PlantSubscriber.Until(() => plant.Raw.Count >= 30);
        broker.Kill();
        broker.Start();
        await PlantSubscriber.Until(() => plant.Raw.Count >= 60);

        Assert.Equal(cell.Expected, plant.ById.Select(PlantSubscriber.Id));
    }

    [Fact]
    public async Task Cells_of_one_store_publish_their_own_steps()
    {
        MosquittoPeer.IsNeeded();
        using var broker = new MosquittoPeer();
        await using var plant = new PlantSubscriber(broker);
        await plant.IsThere();
        using var folder = new TemporaryFolder();
        using var store = CellStore.Open(new SqliteSettings(folder["shared.db"]), TimeProvider.System);
        await using var first = new PublishedCell(broker.Settings, store);
        await using var second = new PublishedCell(broker.Settings, store, "probe", "Cell 2");
        for (var i = 0; i < 10; i++)
        {
            first.Arrive();
            second.Arrive(2);
        }

        await PlantSubscriber.Until(() => plant.ById.Count >= 30);

        Assert.Equal(30, plant.Raw.Count);
        Assert.All(
            new[] { first, second },
            cell => Assert.Equal(
                cell.Expected, plant.Raw.Where(m => m.GetProperty("cell").ValueEquals(cell.Settings.Name)).Select(PlantSubscriber.Id)));
    }
}
