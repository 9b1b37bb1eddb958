using System.Net.Sockets;
using System.Text;
using ErrorMatching.Testing;

namespace ErrorMatching.Peers.Tests;

/// <summary>An FTP server that refuses every login and repeats name and password in its answer.</summary>
internal sealed class TellingFtp : IDisposable
{
    private readonly LoopbackServer _server;

    public TellingFtp()
    {
        _server = new(AnswerAsync);
        _server.Start();
    }

    public int Port => _server.Port;

    /// <summary>The passwords that were tried.</summary>
    public System.Collections.Concurrent.ConcurrentQueue<string> Tried { get; } = new();

    public void Dispose() => _server.Dispose();

    private async Task AnswerAsync(TcpClient client)
    {
        using var writer = new StreamWriter(client.GetStream(), new UTF8Encoding(false)) { NewLine = "\r\n", AutoFlush = true };
        using var reader = new StreamReader(client.GetStream(), new UTF8Encoding(false));
        await writer.WriteLineAsync("220 ready");
        while (await reader.ReadLineAsync(_server.End) is { } line)
        {
            if (line.StartsWith("PASS ", StringComparison.Ordinal))
            {
                Tried.Enqueue(line[5..]);
            }

            await writer.WriteLineAsync(line.StartsWith("USER ", StringComparison.Ordinal) ? "331 go on" : $"530 not you: {line}");
        }
    }
}
