using System.Net;
using System.Net.Sockets;

namespace ErrorMatching.Testing;

/// <summary>A server on a free loopback port: each connection is served beside the others until its client, its serving or the server ends.</summary>
internal sealed class LoopbackServer : IDisposable
{
    private readonly TcpListener _listener = new(IPAddress.Loopback, 0);
    private readonly CancellationTokenSource _end = new();
    private readonly Func<TcpClient, Task> _serve;

    /// <summary>Makes it; nothing is accepted before <see cref="Start"/>.</summary>
    /// <param name="serve">Serves one connection. It is closed when this ends, or fails because somebody hung up.</param>
    public LoopbackServer(Func<TcpClient, Task> serve) => _serve = serve;

    public int Port => ((IPEndPoint)_listener.LocalEndpoint).Port;

    /// <summary>Tells what serves that the server ends.</summary>
    public CancellationToken End => _end.Token;

    /// <summary>True for what is thrown when somebody hangs up or the server ends.</summary>
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
