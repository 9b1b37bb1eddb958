using System.Data.Common;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Reads a statement's rows with a given function.</summary>
internal static class Rows
{
    public static IReadOnlyList<T> Query<T>(
        DbConnection connection, string sql, Func<DbDataReader, T> row, SqlArguments? parameters = null, DbTransaction? transaction = null)
    {
        var rows = new List<T>();
        foreach (var each in Stream(connection, sql, row, parameters, transaction)) rows.Add(each);
        return rows;
    }

    /// <summary>The first row; null if there is none.</summary>
    public static T? First<T>(
        DbConnection connection, string sql, Func<DbDataReader, T> row, SqlArguments? parameters = null, DbTransaction? transaction = null)
        where T : class
    {
        using var command = Sql.Command(connection, sql, parameters, transaction);
        using var reader = command.ExecuteReader();
        return reader.Read() ? row(reader) : null;
    }

    /// <summary>The rows, read one at a time as they are enumerated.</summary>
    public static IEnumerable<T> Stream<T>(
        DbConnection connection, string sql, Func<DbDataReader, T> row, SqlArguments? parameters = null, DbTransaction? transaction = null)
    {
        using var command = Sql.Command(connection, sql, parameters, transaction);
        using var reader = command.ExecuteReader();
        while (reader.Read()) yield return row(reader);
    }

    /// <summary>A statement in a column; null for none.</summary>
    public static Statement? StatementOrNull(this DbDataReader reader, int column) =>
        reader.TextOrNull(column) is { } text ? Recorded.Read(text) : null;

    // A column that has no text, which somebody else wrote, is read or refused as the database does it.
    public static string? TextOrNull(this DbDataReader reader, int column) => reader.GetValue(column) switch
    {
        string text => text,
        DBNull => null,
        _ => reader.GetString(column),
    };
}
