using System.Data;
using Dapper;
using Npgsql;

namespace ErrorMatching.Cell;

/// <summary>An advisory lock of the server, on its own connection: the server releases it when that connection ends.</summary>
internal sealed class PostgresLock : ISlotLock
{
    private readonly NpgsqlConnection _connection;
    private readonly string _name;

    private PostgresLock(NpgsqlConnection connection, string name)
    {
        _connection = connection;
        _name = name;
    }

    public bool IsHeld
    {
        get
        {
            lock (_connection)
            {
                try
                {
                    return _connection.ExecuteScalar<long>(
                        "SELECT count(*) FROM pg_locks, (SELECT hashtextextended(@Name, 0) AS key) AS wanted "
                        + "WHERE locktype = 'advisory' AND pid = pg_backend_pid() AND granted AND objsubid = 1 "
                        + "AND classid::bigint = ((key >> 32) & 4294967295) AND objid::bigint = (key & 4294967295)",
                        new { Name = _name },
                        commandTimeout: 5) == 1;
                }
                catch (Exception failure) when (failure is NpgsqlException or InvalidOperationException)
                {
                    // No response: the lock may be lost.
                    return false;
                }
            }
        }
    }

    /// <summary>Takes the lock; null if it is already held.</summary>
    /// <param name="connectionString">Of a connection that is not shared.</param>
    /// <param name="name">What is locked.</param>
    public static PostgresLock? TryTake(string connectionString, string name)
    {
        var connection = new NpgsqlConnection(connectionString);
        var taken = false;
        try
        {
            connection.Open();
            taken = connection.ExecuteScalar<bool>("SELECT pg_try_advisory_lock(hashtextextended(@Name, 0))", new { Name = name });
            return taken ? new PostgresLock(connection, name) : null;
        }
        finally
        {
            if (!taken) connection.Dispose();
        }
    }

    public void Dispose()
    {
        lock (_connection)
        {
            if (_connection.State == ConnectionState.Open) GiveBack();
            _connection.Dispose();
        }
    }

    // The server does not confirm that it has noticed the end of a connection: the next caller may find the lock still taken.
    private void GiveBack()
    {
        try
        {
            _connection.Execute("SELECT pg_advisory_unlock(hashtextextended(@Name, 0))", new { Name = _name }, commandTimeout: 5);
        }
        catch (NpgsqlException)
        {
            // The lock ends with the connection.
        }
    }
}
