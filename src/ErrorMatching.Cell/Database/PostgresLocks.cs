using Npgsql;

namespace ErrorMatching.Cell;

/// <summary>The rights of this process, as advisory locks of the server, all on one connection of their own.</summary>
/// <remarks>They are a lease. The server ends this connection, and with it all rights, if it hears nothing for <see cref="Lease"/>: also
/// from a process that is frozen, or whose computer is off. A living process is heard often enough, without a transaction
/// (<see cref="SignOfLife"/>).</remarks>
/// <param name="connectionString">Of a connection that is not shared.</param>
/// <param name="part">The part of the database that the rights are about.</param>
internal sealed class PostgresLocks(string connectionString, string part) : IDisposable
{
    /// <summary>How long a process may be silent before its rights go to others.</summary>
    public static readonly TimeSpan Lease = TimeSpan.FromSeconds(6);

    /// <summary>How often a process that does nothing else lets the server hear from it.</summary>
    public static readonly TimeSpan SignOfLife = TimeSpan.FromSeconds(2);

    private const int AnswerSeconds = 5;

    private readonly Lock _gate = new();
    private readonly HashSet<string> _held = new(StringComparer.Ordinal);
    private NpgsqlConnection? _connection;

    /// <summary>Takes a right; null if this process or another one has it.</summary>
    /// <exception cref="NpgsqlException">The server cannot be asked.</exception>
    public PostgresLock? TryTake(string name)
    {
        lock (_gate)
        {
            if (_connection is not null && !Answers()) Lose();
            if (_held.Contains(name)) return null;
            var connection = _connection ??= Open();
            try
            {
                if (!connection.Value<bool>(
                    "SELECT pg_try_advisory_lock(hashtextextended(@Name, 0))", [("Name", part + name)], commandTimeout: AnswerSeconds))
                    return null;
            }
            catch (NpgsqlException)
            {
                Lose();
                throw;
            }

            _held.Add(name);
            return new(this, connection, name);
        }
    }

    /// <summary>Asks the server whether a right that was taken on a connection is still there.</summary>
    public bool Has(NpgsqlConnection on, string name)
    {
        lock (_gate)
        {
            if (_connection != on || !_held.Contains(name)) return false;
            try
            {
                if (on.Value<long>(
                    "SELECT count(*) FROM pg_locks, (SELECT hashtextextended(@Name, 0) AS key) AS wanted "
                        + "WHERE locktype = 'advisory' AND pid = pg_backend_pid() AND granted AND objsubid = 1 "
                        + "AND classid::bigint = ((key >> 32) & 4294967295) AND objid::bigint = (key & 4294967295)",
                    [("Name", part + name)],
                    commandTimeout: AnswerSeconds) == 1) return true;
            }
            catch (Exception failure) when (failure is NpgsqlException or InvalidOperationException)
            {
                // No response: the lease may have ended.
            }

            Lose();
            return false;
        }
    }

    /// <summary>Gives a right back.</summary>
    public void GiveBack(NpgsqlConnection on, string name)
    {
        lock (_gate)
        {
            if (_connection != on || !_held.Remove(name)) return;
            try
            {
                on.Execute(
                    "SELECT pg_advisory_unlock(hashtextextended(@Name, 0))", [("Name", part + name)], commandTimeout: AnswerSeconds);
            }
            catch (Exception failure) when (failure is NpgsqlException or InvalidOperationException)
            {
                // It ends with the connection.
                Lose();
            }
        }
    }

    public void Dispose()
    {
        lock (_gate) Lose();
    }

    private bool Answers()
    {
        try
        {
            return _connection!.Value<int>("SELECT 1", commandTimeout: AnswerSeconds) == 1;
        }
        catch (Exception failure) when (failure is NpgsqlException or InvalidOperationException)
        {
            return false;
        }
    }

    // All rights end with the connection: who holds one finds that out before using it.
    private void Lose()
    {
        _held.Clear();
        _connection?.Dispose();
        _connection = null;
    }

    private NpgsqlConnection Open()
    {
        var connection = new NpgsqlConnection(connectionString);
        try
        {
            connection.Open();
            return connection;
        }
        catch
        {
            connection.Dispose();
            throw;
        }
    }
}

/// <summary>A right of this process; see <see cref="PostgresLocks"/>.</summary>
internal sealed class PostgresLock(PostgresLocks locks, NpgsqlConnection on, string name) : ISlotLock
{
    public bool IsHeld => locks.Has(on, name);

    public void Dispose() => locks.GiveBack(on, name);
}
