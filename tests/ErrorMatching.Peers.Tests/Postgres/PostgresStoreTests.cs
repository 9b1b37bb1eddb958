using ErrorMatching.Cell;
using ErrorMatching.Cell.Tests;

namespace ErrorMatching.Peers.Tests;

/// <summary>The tests of every store, with a real PostgreSQL server.</summary>
[Collection(PostgresTests.Name)]
public sealed class PostgresStoreTests : StoreTests
{
    private readonly PostgresServer _server;

    public PostgresStoreTests(PostgresServer server)
    {
        PostgresServer.IsNeeded();
        _server = server;
    }

    private protected override string TablesSql => "SELECT tablename FROM pg_tables WHERE schemaname = current_schema() ORDER BY tablename";

    protected override StoreSettings NewSettings() => _server.NewDatabase();

    private protected override void RemoveTriggers(CellStore store) => store.Write(t => t.Execute("DROP TRIGGER audit_change ON audit"));
}
