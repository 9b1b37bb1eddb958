using System.Data.Common;

namespace ErrorMatching.Cell;

/// <summary>A user's row in the store.</summary>
/// <param name="Name">The name.</param>
/// <param name="Role">The user's role; null if the store has an unknown one: then the user has no rights.</param>
/// <param name="Password">The password hash.</param>
/// <param name="IsDisabled">True if the user may not sign in.</param>
/// <param name="AddedAt">When.</param>
/// <param name="PasswordAt">When the password was last set.</param>
internal sealed record Person(string Name, Role? Role, string Password, bool IsDisabled, DateTimeOffset AddedAt, DateTimeOffset PasswordAt)
{
    /// <summary>Prefix of the names of users' rows among coded rows.</summary>
    public const string RowPrefix = "person ";

    /// <summary>Rows with their codes, for <see cref="ReadKept"/>.</summary>
    public const string SelectKept = "SELECT name, role, password, is_disabled, added_at, password_at, row_code FROM person";

    /// <summary>The role as the store has it.</summary>
    public string RoleWord { get; private init; } = Role.ToString() ?? "";

    /// <summary>False if the row was changed outside the cell.</summary>
    public bool IsAsLeft { get; private init; } = true;

    /// <summary>Why the user has no rights, regardless of role: the row was changed outside the cell, or the role is unknown. Null if
    /// neither is the case.</summary>
    public PeopleException? Problem =>
        Role is null ? new(PeopleError.UnknownRole, Recorded.UserOfNoRole.With(Name, RoleWord))
        : !IsAsLeft ? new(PeopleError.Tampered, Recorded.UserTampered.With(Name))
        : null;

    /// <summary>Finds the user with a name, ignoring case; null if there is none.</summary>
    public static Person? Find(StoreTransaction transaction, string name) =>
        transaction.Query(SelectKept + " WHERE name_key = @Key", ReadKept, [("Key", UserName.Key(name))]) is [var row]
            ? Looked(row, transaction.Key) : null;

    /// <summary>All users, ordered by name.</summary>
    public static IReadOnlyList<Person> All(StoreTransaction transaction) =>
        [.. transaction.Query(SelectKept, ReadKept).Select(r => Looked(r, transaction.Key))
            .OrderBy(p => UserName.Key(p.Name), StringComparer.Ordinal)];

    /// <summary>The row with its code.</summary>
    public static StoredRow<Person> ReadKept(DbDataReader row) => new(Read(row), Coded, row.TextOrNull(6));

    /// <summary>The row in coded form.</summary>
    public static CodedRow Coded(Person p) => new(
        NameOf(UserName.Key(p.Name)),
        [p.Name, p.RoleWord, p.Password, p.IsDisabled ? "1" : "0", CodedRow.Number(StoredTime.Of(p.AddedAt)),
            CodedRow.Number(StoredTime.Of(p.PasswordAt))]);

    /// <summary>The row's name among coded rows.</summary>
    public static string NameOf(string key) => RowPrefix + key;

    /// <summary>The correct row of a user whose row was changed outside the cell: as the audit trail says, and with a hash that no password
    /// matches.</summary>
    /// <param name="name">The recorded name.</param>
    /// <param name="role">The recorded role.</param>
    /// <param name="isDisabled">True if the user is recorded as disabled.</param>
    /// <param name="nobodys">The hash.</param>
    public Person Mended(string name, Role role, bool isDisabled, string nobodys) =>
        As(role) with { Name = name, IsDisabled = isDisabled, Password = nobodys, IsAsLeft = true };

    /// <summary>The user with another role.</summary>
    public Person As(Role role) => this with { Role = role, RoleWord = role.ToString() };

    /// <summary>Stores a new user. The audit entry that follows names the row's code.</summary>
    public void Insert(StoreTransaction transaction) => transaction.Execute(
        "INSERT INTO person (name_key, name, role, password, is_disabled, added_at, password_at, row_code) VALUES (@Key, @Name, @Role, "
            + "@Password, @IsDisabled, @AddedAt, @PasswordAt, @Code)",
        Columns(transaction));

    /// <summary>Stores the changes of a user. The audit entry that follows names the row's code.</summary>
    public void Update(StoreTransaction transaction) => transaction.Execute(
        "UPDATE person SET name = @Name, role = @Role, password = @Password, is_disabled = @IsDisabled, password_at = @PasswordAt, "
            + "row_code = @Code WHERE name_key = @Key",
        Columns(transaction));

    private SqlArguments Columns(StoreTransaction transaction) => [
        ("Key", UserName.Key(Name)),
        ("Name", Name),
        ("Role", RoleWord),
        ("Password", Password),
        ("IsDisabled", IsDisabled ? 1 : 0),
        ("AddedAt", StoredTime.Of(AddedAt)),
        ("PasswordAt", StoredTime.Of(PasswordAt)),
        ("Code", transaction.CodeOf(Coded(this))),
    ];

    /// <summary>The user, and whether the row was changed outside the cell.</summary>
    public static Person Looked(StoredRow<Person> row, byte[]? key) => row.Value with { IsAsLeft = row.Holds(key) };

    private static Person Read(DbDataReader row) => new(
        row.GetString(0), Enum.GetValues<Role>().Where(r => r.ToString() == row.GetString(1)).Select(r => (Role?)r).FirstOrDefault(),
            row.GetString(2), row.GetInt32(3) != 0,
        StoredTime.From(row.GetInt64(4)), StoredTime.From(row.GetInt64(5)))
    {
        RoleWord = row.GetString(1),
    };
}
