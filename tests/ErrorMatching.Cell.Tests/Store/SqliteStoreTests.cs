namespace ErrorMatching.Cell.Tests;

public sealed class SqliteStoreTests : StoreTests
{
    private readonly string _folder = Directory.CreateTempSubdirectory("errormatch-store-").FullName;

    protected override StoreSettings NewSettings() => new SqliteSettings(Path.Combine(_folder, $"{Guid.NewGuid():N}.db"));

    private protected override string TablesSql =>
        "SELECT name FROM sqlite_master WHERE type = 'table' AND name NOT LIKE 'sqlite_%' ORDER BY name";

    private protected override void RemoveTriggers(CellStore store) =>
        store.Write(t => t.Execute("DROP TRIGGER audit_update; DROP TRIGGER audit_delete"));

    private protected override CellStore SecondCell(CellStore first) => first;

    protected override void Dispose(bool disposing)
    {
        base.Dispose(disposing);
        Directory.Delete(_folder, recursive: true);
    }
}
