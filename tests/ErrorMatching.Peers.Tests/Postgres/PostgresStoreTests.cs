using ErrorMatching.Cell.Tests;

namespace ErrorMatching.Peers.Tests;

/// <summary>The tests of every store, with a real PostgreSQL server.</summary>
[Collection(PostgresTests.Name)]
public sealed class PostgresStoreTests(PostgresServer server) : StoreTests(new PostgresKind(server));

/// <inheritdoc cref="PostgresStoreTests"/>
[Collection(PostgresTests.Name)]
public sealed class PostgresStoreSlotTests(PostgresServer server) : StoreSlotTests(new PostgresKind(server));

/// <inheritdoc cref="PostgresStoreTests"/>
[Collection(PostgresTests.Name)]
public sealed class PostgresStoreLineTests(PostgresServer server) : StoreLineTests(new PostgresKind(server));

/// <inheritdoc cref="PostgresStoreTests"/>
[Collection(PostgresTests.Name)]
public sealed class PostgresStoreHistoryTests(PostgresServer server) : StoreHistoryTests(new PostgresKind(server));

/// <inheritdoc cref="PostgresStoreTests"/>
[Collection(PostgresTests.Name)]
public sealed class PostgresStoreMigrationTests(PostgresServer server) : StoreMigrationTests(new PostgresKind(server));

/// <inheritdoc cref="PostgresStoreTests"/>
[Collection(PostgresTests.Name)]
public sealed class PostgresStoreThinTests(PostgresServer server) : StoreThinTests(new PostgresKind(server));

/// <inheritdoc cref="PostgresStoreTests"/>
[Collection(PostgresTests.Name)]
public sealed class PostgresStoreCheckpointTests(PostgresServer server) : StoreCheckpointTests(new PostgresKind(server));
