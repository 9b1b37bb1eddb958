namespace ErrorMatching.Cell;

/// <summary>The connections to one server. Each operation has one of its own while it works; then the connection waits for the
/// next.</summary>
/// <param name="open">Opens another one.</param>
/// <param name="waits">How long they are trusted.</param>
internal sealed class SftpConnections(Func<CancellationToken, Task<SftpConnection>> open, SftpWaits waits) : IDisposable
{
    // Slots may send at the same time, but a control allows few sessions, so no more than these wait.
    private const int MostWaiting = 2;

    private static readonly TimeSpan Goodbye = TimeSpan.FromSeconds(2);

    private readonly Lock _gate = new();
    private readonly Stack<SftpConnection> _waiting = [];
    private bool _isClosed;

    /// <summary>A connection that waits, or a new one.</summary>
    /// <exception cref="SftpConnectException">There is none to be had.</exception>
    public async Task<SftpConnection> TakeAsync(CancellationToken cancellation)
    {
        while (Next() is { } waiting)
        {
            if (await IsAliveAsync(waiting, cancellation).ConfigureAwait(false))
                return waiting;
            Drop(waiting);
        }

        return await open(cancellation).ConfigureAwait(false);
    }

    /// <summary>Gives back a connection after an operation. One that is broken, or still owes an answer, is not used again.</summary>
    public void Give(SftpConnection connection)
    {
        connection.Touch();
        lock (_gate)
        {
            if (!_isClosed && _waiting.Count < MostWaiting && connection.IsFit)
            {
                _waiting.Push(connection);
                return;
            }
        }

        Drop(connection);
    }

    /// <summary>Breaks a connection. Its remains are cleared away in the background: the library waits for its own thread.</summary>
    public static void Drop(SftpConnection connection)
    {
        connection.Cut();
        _ = Task.Run(connection.Dispose);
    }

    /// <summary>Says goodbye to the server. Operations that still work lose their connections when they end.</summary>
    public void Dispose()
    {
        SftpConnection[] waiting;
        lock (_gate)
        {
            _isClosed = true;
            waiting = [.. _waiting];
            _waiting.Clear();
        }

        foreach (var connection in waiting)
        {
            if (!Task.Run(connection.Dispose).Wait(Goodbye))
                connection.Cut();
        }
    }

    private SftpConnection? Next()
    {
        lock (_gate)
            return _waiting.TryPop(out var waiting) ? waiting : null;
    }

    private async Task<bool> IsAliveAsync(SftpConnection connection, CancellationToken cancellation)
    {
        if (!connection.IsFit)
            return false;
        if (connection.Idle < waits.Fresh)
            return true;
        try
        {
            await connection.Files.GreetAgainAsync().WaitAsync(waits.Answer, cancellation).ConfigureAwait(false);
            return true;
        }
        catch (Exception e) when (e is SftpLostException or SftpStatusException or TimeoutException)
        {
            return false;
        }
        catch (OperationCanceledException)
        {
            Drop(connection);
            throw;
        }
    }
}

/// <summary>How long a connection that waits is trusted. A dead one must not cost a transfer its whole time limit.</summary>
/// <param name="Fresh">So long after its last use it is taken to be alive; later it is asked first.</param>
/// <param name="Answer">So long it may take to answer; then it is replaced.</param>
internal sealed record SftpWaits(TimeSpan Fresh, TimeSpan Answer)
{
    /// <summary>The usual waits.</summary>
    public static SftpWaits Usual { get; } = new(TimeSpan.FromSeconds(5), TimeSpan.FromSeconds(5));
}
