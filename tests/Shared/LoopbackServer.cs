using System.Net;
using System.Net.Sockets;

namespace ErrorMatching.Testing;

/// <summary>A server on a free loopback port. Connections are served concurrently, each until its client, its handler or the server
/// ends.</summary>
internal sealed class LoopbackServer : IDisposable
{
    private readonly TcpListener _listener = new(IPAddress.Loopback, 0);
    private readonly CancellationTokenSource _end = new();
    private readonly Func<TcpClient, Task> _serve;

    /// <summary>Creates the server; it accepts connections only after <see cref="Start"/>.</summary>
    /// <param name="serve">Serves one connection. The connection is closed when this ends, or fails because the client
    /// disconnected.</param>
    public LoopbackServer(Func<TcpClient, Task> serve) => _serve = serve;

    public int Port => ((IPEndPoint)_listener.LocalEndpoint).Port;

    /// <summary>Signals the end of the server to the handlers.</summary>
    public CancellationToken End => _end.Token;

    /// <summary>True for exceptions caused by a disconnected client or the end of the server.</summary>
    public static bool IsEnd(Exception e) => e is OperationCanceledException or IOException or SocketException or ObjectDisposedException;

    public void Start()
    {
        _listener.Start(64);
        _ = AcceptAsync();
    }

    public void Dispose()
    {
        _end.Cancel();
        _listener.Stop();
        _end.Dispose();
    }

    private async Task AcceptAsync()
    {
        try
        {
            while (true)
            {
                _ = ServeAsync(await _listener.AcceptTcpClientAsync(_end.Token));
            }
        }
        catch (Exception e) when (IsEnd(e))
        {
        }
    }

    private async Task ServeAsync(TcpClient client)
    {
        using (client)
        {
            try
            {
                await _serve(client);
            }
            catch (Exception e) when (IsEnd(e))
            {
            }
        }
    }
}
