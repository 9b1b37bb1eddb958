using System.Data.Common;

namespace ErrorMatching.Cell;

/// <summary>A user's row in the store.</summary>
internal sealed record Person(string Name, Role Role, string Password, bool IsDisabled, DateTimeOffset AddedAt, DateTimeOffset PasswordAt)
{
    private const string Select = "SELECT name, role, password, is_disabled, added_at, password_at FROM person";

    /// <summary>The user of a name, however its letters are written; null if there is none.</summary>
    public static Person? Find(StoreTransaction transaction, string name) =>
        transaction.Query(Select + " WHERE name_key = @Key", Read, new { Key = UserName.Key(name) }) is [var person] ? person : null;

    /// <summary>All users, in the order of their names.</summary>
    public static IReadOnlyList<Person> All(StoreTransaction transaction) =>
        [.. transaction.Query(Select, Read).OrderBy(p => UserName.Key(p.Name), StringComparer.Ordinal)];

    /// <summary>Keeps a new user.</summary>
    public void Insert(StoreTransaction transaction) => transaction.Execute(
        "INSERT INTO person (name_key, name, role, password, is_disabled, added_at, password_at) VALUES (@Key, @Name, @Role, @Password, @IsDisabled, @AddedAt, @PasswordAt)", Columns);

    /// <summary>Keeps what changed of a user.</summary>
    public void Update(StoreTransaction transaction) => transaction.Execute(
        "UPDATE person SET role = @Role, password = @Password, is_disabled = @IsDisabled, password_at = @PasswordAt WHERE name_key = @Key", Columns);

    private object Columns => new
    {
        Key = UserName.Key(Name),
        Name,
        Role = Role.ToString(),
        Password,
        IsDisabled = IsDisabled ? 1 : 0,
        AddedAt = StoredTime.Of(AddedAt),
        PasswordAt = StoredTime.Of(PasswordAt),
    };

    private static Person Read(DbDataReader row) => new(
        row.GetString(0), Enum.Parse<Role>(row.GetString(1)), row.GetString(2), row.GetInt32(3) != 0, StoredTime.From(row.GetInt64(4)), StoredTime.From(row.GetInt64(5)));
}
