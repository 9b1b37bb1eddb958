using Npgsql;

namespace ErrorMatching.Cell;

/// <summary>Listens for changes by other processes, on a connection of its own.</summary>
internal sealed class PostgresListener : IDisposable
{
    private static readonly TimeSpan Pause = TimeSpan.FromSeconds(1);
    private readonly string _connectionString;
    private readonly string _channel;
    private readonly string _own;
    private readonly CancellationTokenSource _stop = new();
    private readonly Task _listening;
    private volatile bool _isLive;
    private long _heard;

    /// <summary>Starts to listen.</summary>
    /// <param name="connectionString">Of a connection that is not shared.</param>
    /// <param name="channel">The channel.</param>
    /// <param name="own">What this process says itself, which is no news.</param>
    public PostgresListener(string connectionString, string channel, string own)
    {
        (_connectionString, _channel, _own) = (connectionString, channel, own);
        _listening = Task.Run(ListenAsync);
    }

    /// <summary>True while the server would tell of any change.</summary>
    public bool IsLive => _isLive;

    /// <summary>A number that differs after each news, and after any time in which there may have been some.</summary>
    public long Heard => Interlocked.Read(ref _heard);

    public void Dispose()
    {
        _stop.Cancel();
        _listening.Wait();
        _stop.Dispose();
    }

    private async Task ListenAsync()
    {
        while (!_stop.IsCancellationRequested)
        {
            try
            {
                await using var connection = new NpgsqlConnection(_connectionString);
                connection.Notification += (_, news) =>
                {
                    if (news.Payload != _own) Interlocked.Increment(ref _heard);
                };
                await connection.OpenAsync(_stop.Token);
                await using (var listen = new NpgsqlCommand($"LISTEN \"{_channel}\"", connection))
                    await listen.ExecuteNonQueryAsync(_stop.Token);

                // What happened before is not told.
                Interlocked.Increment(ref _heard);
                _isLive = true;
                while (true) await connection.WaitAsync(_stop.Token);
            }
            catch (OperationCanceledException) when (_stop.IsCancellationRequested)
            {
                return;
            }
            catch (Exception e) when (e is NpgsqlException or OperationCanceledException or IOException or ObjectDisposedException)
            {
                // A server that is away, or a standby, which tells nothing: the readers ask meanwhile, and are told why.
                _isLive = false;
            }

            await Task.WhenAny(Task.Delay(Pause, _stop.Token));
        }
    }
}
