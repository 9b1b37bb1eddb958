namespace ErrorMatching.Cell;

/// <summary>An embedded store of one cell.</summary>
/// <param name="File">The database's file.</param>
public sealed record SqliteSettings(string File) : StoreSettings;
