namespace ErrorMatching.Cell.Tests;

public sealed class SqliteStoreTests() : StoreTests(new SqliteKind());

public sealed class SqliteStoreSlotTests() : StoreSlotTests(new SqliteKind());

public sealed class SqliteStoreLineTests() : StoreLineTests(new SqliteKind());

public sealed class SqliteStoreHistoryTests() : StoreHistoryTests(new SqliteKind());

public sealed class SqliteStoreMigrationTests() : StoreMigrationTests(new SqliteKind());

public sealed class SqliteStoreThinTests() : StoreThinTests(new SqliteKind());

public sealed class SqliteStoreCheckpointTests() : StoreCheckpointTests(new SqliteKind());
