global using SqlArguments = System.Collections.Generic.IReadOnlyList<(string Name, ErrorMatching.Cell.SqlArgument Value)>;
using System.Data;
using System.Data.Common;
using System.Globalization;

namespace ErrorMatching.Cell;

/// <summary>Statements with named arguments. No code is generated while the program runs, so that it can be compiled to one native
/// file.</summary>
internal static class Sql
{
    /// <summary>Runs a statement.</summary>
    /// <returns>How many rows it changed.</returns>
    public static int Execute(
        this DbConnection connection,
        string sql,
        SqlArguments? arguments = null,
        DbTransaction? transaction = null,
        int? commandTimeout = null)
    {
        using var command = Command(connection, sql, arguments, transaction, commandTimeout);
        return command.ExecuteNonQuery();
    }

    /// <summary>The first column of the first row; the type's default if there is no row, or nothing in it.</summary>
    public static T? Value<T>(
        this DbConnection connection,
        string sql,
        SqlArguments? arguments = null,
        DbTransaction? transaction = null,
        int? commandTimeout = null)
    {
        using var command = Command(connection, sql, arguments, transaction, commandTimeout);
        return command.ExecuteScalar() switch
        {
            null or DBNull => default,
            T value => value,
            var value => (T)Convert.ChangeType(value, Nullable.GetUnderlyingType(typeof(T)) ?? typeof(T), CultureInfo.InvariantCulture),
        };
    }

    /// <summary>A statement that is ready to run.</summary>
    public static DbCommand Command(
        DbConnection connection,
        string sql,
        SqlArguments? arguments,
        DbTransaction? transaction,
        int? commandTimeout = null)
    {
        var command = connection.CreateCommand();
        try
        {
#pragma warning disable CA2100 // The texts are this program's own; the name of a schema has a pattern in cell.schema.json.
            command.CommandText = sql;
#pragma warning restore CA2100
            command.Transaction = transaction;
            if (commandTimeout is { } seconds) command.CommandTimeout = seconds;
            foreach (var (name, value) in arguments ?? [])
            {
                var parameter = command.CreateParameter();
                (parameter.ParameterName, parameter.DbType, parameter.Value) = (name, value.Type, value.Value ?? DBNull.Value);
                command.Parameters.Add(parameter);
            }

            return command;
        }
        catch
        {
            command.Dispose();
            throw;
        }
    }
}

/// <summary>What a statement is given for a name. Its type is known even if it has no value: PostgreSQL must not guess it.</summary>
/// <param name="Type">The type.</param>
/// <param name="Value">The value; null for none.</param>
internal readonly record struct SqlArgument(DbType Type, object? Value)
{
    public static implicit operator SqlArgument(string? text) => new(DbType.String, text);

    public static implicit operator SqlArgument(byte[]? bytes) => new(DbType.Binary, bytes);

    public static implicit operator SqlArgument(long? number) => new(DbType.Int64, number);

    public static implicit operator SqlArgument(long number) => new(DbType.Int64, number);

    public static implicit operator SqlArgument(double? number) => new(DbType.Double, number);

    public static implicit operator SqlArgument(int number) => new(DbType.Int32, number);

    public static implicit operator SqlArgument(int? number) => new(DbType.Int32, number);
}
