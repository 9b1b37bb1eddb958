using System.Data.Common;
using System.Globalization;
using Microsoft.Data.Sqlite;
using Npgsql;

namespace ErrorMatching.Cell;

/// <summary>Examines a store without creating or migrating it.</summary>
internal static class StoreCheck
{
    private const string FormOf = "SELECT max(number) FROM migration";

    public static CheckedStore Of(StoreSettings settings)
    {
        var latest = Migrations.All[^1].Number;
        try
        {
            var form = settings switch
            {
                SqliteSettings { File: var file } => File.Exists(file) ? FormOfFile(file) : null,
                PostgresSettings postgres => FormOnServer(postgres),
                _ => throw new ArgumentOutOfRangeException(nameof(settings), settings, "No such kind of store."),
            };
            var problem = form > latest
                ? CheckProblem.Of(
                    CellCodes.Of(StoreError.TooNew),
                    string.Create(
                        CultureInfo.InvariantCulture,
                        $"The store has form {form} and this program knows forms up to {latest}. Use the newer program that made it."))
                : null;
            return new(form is not null, form ?? 0, latest, problem);
        }
        catch (StoreException e)
        {
            return new(false, 0, latest, CheckProblem.Of(CellCodes.Of(e.Error), e.Message));
        }
        catch (DbException e)
        {
            var error = settings is PostgresSettings
                ? StoreError.Away
                : e is SqliteException { SqliteErrorCode: 11 or 26 }
                ? StoreError.Damaged
                : StoreError.Denied;
            return new(
                false,
                0,
                latest,
                CheckProblem.Of(CellCodes.Of(error), $"{Place(settings)} cannot be looked at: {e.Message.TrimEnd('.')}."));
        }
    }

    private static long? FormOfFile(string file)
    {
        SQLitePCL.Batteries_V2.Init();
        using var connection = new SqliteConnection(
            new SqliteConnectionStringBuilder { DataSource = file, Mode = SqliteOpenMode.ReadOnly, Pooling = false }.ConnectionString);
        connection.Open();
        return connection.Value<int>("PRAGMA application_id") == SqliteDatabase.ApplicationId
            ? connection.Value<long?>(FormOf) ?? 0
            : throw new StoreException(StoreError.Foreign, $"{file} is a database, but not of a cell. Name another file as the store.");
    }

    private static long? FormOnServer(PostgresSettings settings)
    {
        using var connection = new NpgsqlConnection(PostgresDatabase.Connection(settings).ConnectionString);
        connection.Open();
        return connection.Value<string?>("SELECT to_regclass('migration')::text") is null
            ? null
            : connection.Value<long?>(FormOf);
    }

    private static string Place(StoreSettings settings) => settings switch
    {
        SqliteSettings { File: var file } => $"The store {file}",
        PostgresSettings p => FormattableString.Invariant($"The store {p.Database} on {p.Host}:{p.Port}"),
        _ => "The store",
    };
}

/// <summary>The state of the store, found without creating or changing it.</summary>
/// <param name="IsThere">True if it exists.</param>
/// <param name="Form">Its schema version, from 1; 0 if it has none yet.</param>
/// <param name="Latest">The schema version that this program migrates it to on opening.</param>
/// <param name="Problem">Why it could not be examined; null if it could.</param>
public sealed record CheckedStore(bool IsThere, long Form, long Latest, CheckProblem? Problem);
