using System.Data.Common;

namespace ErrorMatching.Cell;

/// <summary>A person's PIN or badge in the store.</summary>
/// <param name="NameKey">The person, as <see cref="UserName.Key"/> has it.</param>
/// <param name="Kind">Which of them.</param>
/// <param name="Hash">Its hash; empty if it was taken away.</param>
/// <param name="SetAt">When it was set or taken away.</param>
internal sealed record CredentialRow(string NameKey, CredentialKind Kind, string Hash, DateTimeOffset SetAt)
{
    private const string RowPrefix = "credential ";

    /// <summary>Rows with their codes, for <see cref="ReadKept"/>.</summary>
    public const string SelectKept = "SELECT name_key, kind, hash, set_at, row_code FROM credential";

    /// <summary>The credential of a person; null if there is none.</summary>
    /// <exception cref="PeopleException">With <see cref="PeopleError.Tampered"/> if the row was changed outside the cell.</exception>
    public static CredentialRow? Find(StoreTransaction transaction, string name, CredentialKind kind) => Looked(
        transaction,
        transaction.First(
            SelectKept + " WHERE name_key = @Key AND kind = @Kind", ReadKept, [("Key", UserName.Key(name)), ("Kind", Word(kind))]));

    /// <summary>The badge with a hash; null if nobody has it.</summary>
    /// <exception cref="PeopleException">As for <see cref="Find"/>.</exception>
    public static CredentialRow? FindBadge(StoreTransaction transaction, string hash) => Looked(
        transaction,
        transaction.First(
            SelectKept + " WHERE kind = @Kind AND hash = @Hash", ReadKept, [("Kind", Word(CredentialKind.Badge)), ("Hash", hash)]));

    /// <summary>The row with its code.</summary>
    public static StoredRow<CredentialRow> ReadKept(DbDataReader row) => new(
        new(row.GetString(0), KindOf(row.GetString(1)), row.GetString(2), StoredTime.From(row.GetInt64(3))), Coded, row.TextOrNull(4));

    /// <summary>True for the name of such a row among coded rows.</summary>
    public static bool IsName(string row) => row.StartsWith(RowPrefix, StringComparison.Ordinal);

    /// <summary>The row in coded form.</summary>
    public static CodedRow Coded(CredentialRow c) => new(
        $"{RowPrefix}{Word(c.Kind)} {c.NameKey}", [c.NameKey, Word(c.Kind), c.Hash, CodedRow.Number(StoredTime.Of(c.SetAt))]);

    /// <summary>Stores it in place of an earlier one. The audit entry that follows names the row's code.</summary>
    public void Put(StoreTransaction transaction) => transaction.Execute(
        "INSERT INTO credential (name_key, kind, hash, set_at, row_code) VALUES (@Key, @Kind, @Hash, @SetAt, @Code) ON CONFLICT (name_key, "
            + "kind) DO UPDATE SET hash = excluded.hash, set_at = excluded.set_at, row_code = excluded.row_code",
        [
            ("Key", NameKey), ("Kind", Word(Kind)), ("Hash", Hash), ("SetAt", StoredTime.Of(SetAt)),
            ("Code", transaction.CodeOf(Coded(this)))
        ]);

    /// <summary>The refusal of a row that was changed outside the cell.</summary>
    public static PeopleException Tampered(CredentialRow row) =>
        new(PeopleError.Tampered, Recorded.CredentialTampered.With(Word(row.Kind), row.NameKey));

    /// <summary>Its word in the store.</summary>
    public static string Word(CredentialKind kind) => kind == CredentialKind.Pin ? "pin" : "badge";

    private static CredentialKind KindOf(string word) => word switch
    {
        "pin" => CredentialKind.Pin,
        "badge" => CredentialKind.Badge,
        _ => throw new FormatException($"There is no credential \"{word}\"."),
    };

    private static CredentialRow? Looked(StoreTransaction transaction, StoredRow<CredentialRow>? row) =>
        row is null || row.Value.Hash.Length == 0 ? null
        : row.Holds(transaction.Key) ? row.Value
        : throw Tampered(row.Value);
}

/// <summary>What a person may sign in with besides the password.</summary>
public enum CredentialKind
{
    /// <summary>A number that the person knows.</summary>
    Pin,

    /// <summary>A badge whose code a scanner reads.</summary>
    Badge,
}
