using System.Net;
using System.Net.Sockets;
using System.Text;

namespace ErrorMatching.Cell.Tests;

/// <summary>A server on a port of this computer that reads lines and answers as a test says.</summary>
internal sealed class LineServer : IAsyncDisposable
{
    private readonly TcpListener _listener = new(IPAddress.Loopback, 0);
    private readonly CancellationTokenSource _end = new();
    private readonly Func<string, string?> _answer;
    private readonly Task _serving;

    /// <summary>Starts the server.</summary>
    /// <param name="answer">The answer to a line, complete with its ends of lines; null to close the connection.</param>
    public LineServer(Func<string, string?> answer)
    {
        _answer = answer;
        _listener.Start();
        _serving = ServeAsync();
    }

    public int Port => ((IPEndPoint)_listener.LocalEndpoint).Port;

    /// <summary>All lines that came in.</summary>
    public System.Collections.Concurrent.ConcurrentQueue<string> Heard { get; } = new();

    public async ValueTask DisposeAsync()
    {
        // The loop ends by the token. Stopped before, the listener would refuse to accept once more.
        await _end.CancelAsync();
        await _serving;
        _listener.Stop();
        _end.Dispose();
    }

    private async Task ServeAsync()
    {
        var talks = new List<Task>();
        try
        {
            while (true)
                talks.Add(TalkAsync(await _listener.AcceptTcpClientAsync(_end.Token)));
        }
        catch (Exception e) when (e is OperationCanceledException or SocketException or ObjectDisposedException)
        {
            await Task.WhenAll(talks);
        }
    }

    private async Task TalkAsync(TcpClient client)
    {
        try
        {
            using (client)
            {
                using var lines = new StreamReader(client.GetStream(), Encoding.ASCII);
                while (await lines.ReadLineAsync(_end.Token) is { } line)
                {
                    Heard.Enqueue(line);
                    if (_answer(line) is not { } answer)
                        return;
                    await client.GetStream().WriteAsync(Encoding.UTF8.GetBytes(answer), _end.Token);
                }
            }
        }
        catch (Exception e) when (e is IOException or OperationCanceledException)
        {
            // The client has gone, or the test ends.
        }
    }
}
