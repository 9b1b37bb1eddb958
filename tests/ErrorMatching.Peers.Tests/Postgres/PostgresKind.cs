using ErrorMatching.Cell;
using ErrorMatching.Cell.Tests;

namespace ErrorMatching.Peers.Tests;

/// <summary>Stores on a PostgreSQL server.</summary>
internal sealed class PostgresKind : StoreKind
{
    private readonly PostgresServer _server;

    public PostgresKind(PostgresServer server)
    {
        PostgresServer.IsNeeded();
        _server = server;
    }

    public override bool IsShared => true;

    public override string TablesSql => "SELECT tablename FROM pg_tables WHERE schemaname = current_schema() ORDER BY tablename";

    public override string RemoveTriggersSql => "DROP TRIGGER audit_change ON audit";

    public override StoreSettings NewSettings() => _server.NewDatabase();
}
