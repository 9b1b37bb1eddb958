namespace ErrorMatching.Cell.Tests;

/// <summary>Stores in files of their own.</summary>
internal sealed class SqliteKind : StoreKind
{
    private readonly string _folder = Directory.CreateTempSubdirectory("errormatch-store-").FullName;

    public override bool IsShared => false;

    public override string TablesSql =>
        "SELECT name FROM sqlite_master WHERE type = 'table' AND name NOT LIKE 'sqlite_%' ORDER BY name";

    public override string RemoveTriggersSql => "DROP TRIGGER audit_update; DROP TRIGGER audit_delete";

    public override StoreSettings NewSettings() => new SqliteSettings(Path.Combine(_folder, $"{Guid.NewGuid():N}.db"));

    protected override void Dispose(bool disposing)
    {
        Directory.Delete(_folder, recursive: true);
        base.Dispose(disposing);
    }
}
