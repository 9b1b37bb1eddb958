using System.Data.Common;
using System.Globalization;
using System.Reflection;
using System.Text.RegularExpressions;

namespace ErrorMatching.Cell;

/// <summary>The numbered steps from an empty database to the current schema: the embedded files <c>NNNN_name.sql</c>. Each step and its
/// number are one transaction.</summary>
internal static partial class Migrations
{
    private const string OwnTable = "CREATE TABLE IF NOT EXISTS migration (number BIGINT NOT NULL PRIMARY KEY, name TEXT NOT NULL, at "
        + "BIGINT NOT NULL)";

    /// <summary>All of them, in order.</summary>
    public static IReadOnlyList<Migration> All { get; } = ReadAll();

    /// <summary>Migrates a database to the last migration, or to an earlier one.</summary>
    /// <exception cref="StoreException">With <see cref="StoreError.TooNew"/> if its schema is newer than the last migration.</exception>
    public static void Apply(CellDatabase database, TimeProvider clock, byte[]? auditKey, int upTo = int.MaxValue)
    {
        // Reading alone must not require the right to write.
        if (database.Read(
            connection => database.HasTable(connection, "migration") && Number(connection, null) == Math.Min(upTo, All[^1].Number)))
            return;
        database.Change((connection, transaction) =>
        {
            database.WaitForMigration(connection, transaction);
            return connection.Execute(OwnTable, transaction: transaction);
        });
        while (Next(database, clock, auditKey, upTo))
        {
        }
    }

    /// <summary>All statements that give an empty database the current schema.</summary>
    /// <param name="word">Translates the tokens for an engine.</param>
    public static IEnumerable<string> Statements(Func<string, string, string> word) => All.Select(m => Sql(m, word)).Prepend(OwnTable);

    /// <summary>The arguments that a token is used with, such as the append-only tables.</summary>
    public static IEnumerable<string> Arguments(string token) =>
        All.SelectMany(m => Token().Matches(m.Sql)).Where(m => m.Groups["token"].Value == token).Select(m => m.Groups["argument"].Value);

    private static string Sql(Migration migration, Func<string, string, string> word) =>
        Token().Replace(migration.Sql, m => word(m.Groups["token"].Value, m.Groups["argument"].Value));

    private static bool Next(CellDatabase database, TimeProvider clock, byte[]? auditKey, int upTo) =>
        database.Change((connection, transaction) =>
    {
        database.WaitForMigration(connection, transaction);
        var number = Number(connection, transaction);
        if (number > All[^1].Number)
        {
            throw new StoreException(
                StoreError.TooNew,
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"{database.Place} has form {number} and this program knows forms up to {All[^1].Number}. Use the newer program that "
                        + $"made it."));
        }

        var migration = All.FirstOrDefault(m => m.Number > number && m.Number <= upTo);
        if (migration is null) return false;
        connection.Execute(Sql(migration, database.Word), transaction: transaction);
        connection.Execute(
            "INSERT INTO migration (number, name, at) VALUES (@Number, @Name, @At)",
            [("Number", migration.Number), ("Name", migration.Name), ("At", StoredTime.Of(clock.GetUtcNow()))],
            transaction);
        if (number == 0)
        {
            var first = StoreTransaction.Begin(connection, transaction, "", clock, auditKey);
            first.Audit(AuditEntry.ByCell, "created", null, Recorded.StoreMade.With());
            first.Finish();
        }

        return true;
    });

    private static long Number(DbConnection connection, DbTransaction? transaction) =>
        connection.Value<long?>("SELECT max(number) FROM migration", transaction: transaction) ?? 0;

    private static Migration[] ReadAll()
    {
        var assembly = Assembly.GetExecutingAssembly();
        return [
            .. assembly.GetManifestResourceNames()
                .Where(n => n.EndsWith(".sql", StringComparison.Ordinal))
                .Order(StringComparer.Ordinal)
                .Select(Read)];

        Migration Read(string name)
        {
            using var reader = new StreamReader(assembly.GetManifestResourceStream(name)!);
            return new Migration(
                int.Parse(name.AsSpan(0, 4), NumberStyles.None, CultureInfo.InvariantCulture), name[5..^4], reader.ReadToEnd());
        }
    }

    [GeneratedRegex(@"\{(?<token>[a-z_]+)(:(?<argument>[a-z_]+))?\}", RegexOptions.ExplicitCapture, Timeout.Infinite)]
    private static partial Regex Token();
}

/// <summary>A numbered step of the database schema.</summary>
/// <param name="Number">Its number.</param>
/// <param name="Name">Its subject.</param>
/// <param name="Sql">Its statements, with tokens such as <c>{blob}</c> where the engines' syntax differs.</param>
internal sealed record Migration(int Number, string Name, string Sql);
