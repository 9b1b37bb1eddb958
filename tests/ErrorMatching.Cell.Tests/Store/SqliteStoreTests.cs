namespace ErrorMatching.Cell.Tests;

public sealed class SqliteStoreTests : StoreTests
{
    private readonly string _folder = Directory.CreateTempSubdirectory("errormatch-store-").FullName;

    protected override StoreSettings Settings => new SqliteSettings(Path.Combine(_folder, "cell.db"));

    private protected override void RemoveTriggers(CellStore store) => store.Write(t => t.Execute("DROP TRIGGER audit_update; DROP TRIGGER audit_delete"));

    protected override void Dispose(bool disposing)
    {
        base.Dispose(disposing);
        Directory.Delete(_folder, recursive: true);
    }
}
