namespace ErrorMatching.Cell;

/// <summary>An embedded store for one cell.</summary>
/// <param name="File">The database file.</param>
public sealed record SqliteSettings(string File) : StoreSettings;
