namespace ErrorMatching.Peers.Tests;

/// <summary>All tests that share the one server, one after another.</summary>
[CollectionDefinition(Name)]
public sealed class PostgresTests : ICollectionFixture<PostgresServer>
{
    public const string Name = "PostgreSQL";
}
