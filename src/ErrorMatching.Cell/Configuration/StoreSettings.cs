namespace ErrorMatching.Cell;

/// <summary>Where everything is kept: a <see cref="SqliteSettings"/> or a <see cref="PostgresSettings"/>.</summary>
public abstract record StoreSettings;
