using ErrorMatching.Cell;

namespace ErrorMatching.Peers.Tests;

/// <summary>Whom a broker lets in, and which broker a cell trusts.</summary>
public sealed class BrokerTrustTests
{
    // Who is let in waits for the broker and not for the clock; of one refusal, the end of the time is the reason.
    private static readonly TimeSpan Patience = TimeSpan.FromSeconds(30), Soon = TimeSpan.FromSeconds(10);

    private const string OtherKey = "sha256//47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU=";

    [Fact]
    public async Task Only_the_trusted_broker_gets_the_password()
    {
        MosquittoPeer.IsNeeded();
        using var peer = new MosquittoPeer();
        var right = peer.Settings;
        var pinned = right with { AuthorityFile = null, PinnedKey = peer.PinnedKey };

        await LetsIn(right);
        await LetsIn(pinned);
        await Refuses(BrokerError.WrongServer, "vouches", right with { AuthorityFile = peer.StrangersFile });
        await Refuses(BrokerError.WrongServer, "another name", right with { Host = "localhost" });
        await Refuses(BrokerError.WrongServer, "is pinned", pinned with { PinnedKey = OtherKey });
        await LetsIn(pinned with { Host = "localhost" });
        await Refuses(BrokerError.Login, "NotAuthorized", right with { PasswordFile = peer.WrongPasswordFile });
        await Refuses(BrokerError.Login, "NotAuthorized", right with { User = null, PasswordFile = null });
        await Refuses(BrokerError.Away, "", right with { IsEncrypted = false });
        using var nobody = new ClosedPort();
        await Refuses(BrokerError.Away, "refused", right with { Port = nobody.Number });
        await Refuses(BrokerError.Secret, "no certificate", right with { AuthorityFile = peer.PasswordFile });
        var two = right with { PasswordFile = peer.PasswordFile + ".two" };
        File.WriteAllText(two.PasswordFile, "one\ntwo\n");
        PostgresServer.SetMode(two.PasswordFile, "600");
        await Refuses(BrokerError.Secret, "only line", two);
        await Refuses(BrokerError.Secret, ".none", right with { PasswordFile = peer.PasswordFile + ".none" });
        PostgresServer.SetMode(peer.PasswordFile, "640");
        await Refuses(BrokerError.Secret, "chmod 600", right);
    }

    [Fact]
    public async Task A_topic_that_the_broker_denies_is_a_trouble_and_loses_nothing()
    {
        MosquittoPeer.IsNeeded();
        using var peer = new MosquittoPeer();
        await using var cell = new PublishedCell(peer.Settings with { Topic = "another/topic" });
        cell.Arrive();

        await PlantSubscriber.Until(() => cell.Flow.Troubles.Open.Any(t => t is { Where: "events", Code: "broker-denied" }));

        Assert.Contains("NotAuthorized", cell.Flow.Troubles.Open[0].Message, StringComparison.Ordinal);
        Assert.Equal(cell.Store.AuditHead().Seq - 1, new EventCursor(cell.Store, "Cell 1").Read());
    }

    [Fact]
    public async Task A_check_logs_in_and_leaves_a_running_cell_alone()
    {
        MosquittoPeer.IsNeeded();
        using var peer = new MosquittoPeer();
        await using var plant = new PlantSubscriber(peer);
        await plant.IsThere();
        await using var cell = new PublishedCell(peer.Settings, settle: TimeSpan.FromHours(1));
        cell.Arrive();
        await PlantSubscriber.Until(() => plant.Raw.Count == 1);

        var token = TestContext.Current.CancellationToken;
        var right = await BrokerCheck.OfAsync(peer.Settings, token);
        var wrong = await BrokerCheck.OfAsync(peer.Settings with { PasswordFile = peer.WrongPasswordFile }, token);
        cell.Arrive();
        await PlantSubscriber.Until(() => plant.Raw.Count == 2);

        Assert.Null(right.Problem);
        Assert.Equal("broker-login", wrong.Problem!.Errors[0].Code);
    }

    private static async Task LetsIn(EventSettings broker)
    {
        using var session = await OpenAsync(broker, Patience);
        await session.PingAsync(TestContext.Current.CancellationToken);
    }

    private static async Task Refuses(BrokerError error, string words, EventSettings broker)
    {
        var refused = await Assert.ThrowsAsync<BrokerException>(() => OpenAsync(broker, Soon));
        Assert.Equal(error, refused.Error);
        Assert.Contains(words, refused.Message, StringComparison.Ordinal);
        Assert.DoesNotContain(MosquittoPeer.Password.Trim(), refused.ToString(), StringComparison.Ordinal);
    }

    private static Task<BrokerSession> OpenAsync(EventSettings broker, TimeSpan limit) =>
        BrokerSession.OpenAsync(broker, "test", isResumed: false, limit, TestContext.Current.CancellationToken);
}
