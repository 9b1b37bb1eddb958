namespace ErrorMatching.Cell;

/// <summary>Where the cell stores its data: a <see cref="SqliteSettings"/> or a <see cref="PostgresSettings"/>.</summary>
public abstract record StoreSettings
{
    /// <summary>The folder of the archives as configured; null if it is not.</summary>
    public string? Archives { get; init; }

    /// <summary>The folder of the archives: as configured, or next to the store's file. Null if there is neither.</summary>
    public string? ArchiveFolder => Archives ?? (this is SqliteSettings { File: var file } ? file + ".archives" : null);

    /// <summary>True if other cells may keep their corrections in the same tables.</summary>
    public abstract bool IsShared { get; }
}

/// <summary>An embedded store for one cell.</summary>
/// <param name="File">The database file.</param>
public sealed record SqliteSettings(string File) : StoreSettings
{
    /// <inheritdoc/>
    public override bool IsShared => false;
}

/// <summary>A store on a server, for several cells.</summary>
/// <param name="Host">Name or address of the server, or the folder of its socket.</param>
/// <param name="Port">Its port.</param>
/// <param name="Database">The database.</param>
/// <param name="User">The database user.</param>
/// <param name="PasswordFile">A password file in PostgreSQL's <c>.pgpass</c> format that only its owner may read; null if the server trusts
/// the connection.</param>
public sealed record PostgresSettings(string Host, int Port, string Database, string User, string? PasswordFile) : StoreSettings
{
    /// <summary>The schema of the database that belongs to this cell alone, with an audit trail of its own; null if the cell shares the
    /// user's default schema with others.</summary>
    public string? Schema { get; init; }

    /// <inheritdoc/>
    public override bool IsShared => Schema is null;
}
