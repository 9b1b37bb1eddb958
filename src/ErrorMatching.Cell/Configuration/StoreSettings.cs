namespace ErrorMatching.Cell;

/// <summary>Where the cell stores its data: a <see cref="SqliteSettings"/> or a <see cref="PostgresSettings"/>.</summary>
public abstract record StoreSettings;
