using System.Net;
using System.Net.Sockets;
using System.Text;

namespace ErrorMatching.Peers.Tests;

/// <summary>An FTP server that refuses every login and repeats name and password in its answer.</summary>
internal sealed class TellingFtp : IDisposable
{
    private readonly TcpListener _listener = new(IPAddress.Loopback, 0);
    private readonly CancellationTokenSource _end = new();

    public TellingFtp()
    {
        _listener.Start();
        _ = ServeAsync();
    }

    public int Port => ((IPEndPoint)_listener.LocalEndpoint).Port;

    /// <summary>The passwords that were tried.</summary>
    public System.Collections.Concurrent.ConcurrentQueue<string> Tried { get; } = new();

    public void Dispose()
    {
        _end.Cancel();
        _listener.Stop();
        _end.Dispose();
    }

    private async Task ServeAsync()
    {
        try
        {
            while (true)
            {
                _ = AnswerAsync(await _listener.AcceptTcpClientAsync(_end.Token));
            }
        }
        catch (Exception e) when (IsEnd(e))
        {
        }
    }

    private async Task AnswerAsync(TcpClient client)
    {
        try
        {
            using var writer = new StreamWriter(client.GetStream(), new UTF8Encoding(false)) { NewLine = "\r\n", AutoFlush = true };
            using var reader = new StreamReader(client.GetStream(), new UTF8Encoding(false));
            await writer.WriteLineAsync("220 ready");
            while (await reader.ReadLineAsync(_end.Token) is { } line)
            {
                if (line.StartsWith("PASS ", StringComparison.Ordinal))
                {
                    Tried.Enqueue(line[5..]);
                }

                await writer.WriteLineAsync(line.StartsWith("USER ", StringComparison.Ordinal) ? "331 go on" : $"530 not you: {line}");
            }
        }
        catch (Exception e) when (IsEnd(e))
        {
        }
        finally
        {
            client.Dispose();
        }
    }

    private static bool IsEnd(Exception e) => e is OperationCanceledException or IOException or SocketException or ObjectDisposedException;
}
