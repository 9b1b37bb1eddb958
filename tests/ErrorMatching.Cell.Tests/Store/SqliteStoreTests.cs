namespace ErrorMatching.Cell.Tests;

public sealed class SqliteStoreTests : StoreTests
{
    private readonly string _folder = Directory.CreateTempSubdirectory("errormatch-store-").FullName;

    protected override StoreSettings Settings => new SqliteSettings(Path.Combine(_folder, "cell.db"));

    protected override void Dispose(bool disposing)
    {
        base.Dispose(disposing);
        Directory.Delete(_folder, recursive: true);
    }
}
