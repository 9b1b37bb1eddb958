using System.Net;
using System.Net.Sockets;
using System.Text;
using ErrorMatching.Testing;

namespace ErrorMatching.Peers.Tests;

/// <summary>Stands before an FTP server's control port and hangs when a command comes:
/// from then on nothing passes, in this session or, if it shall, in any.</summary>
internal sealed class FtpHang : IDisposable
{
    private readonly LoopbackServer _loopback;
    private readonly int _server;
    private readonly string _command;
    private readonly bool _forGood;
    private volatile bool _hasHung;

    /// <summary>Starts it.</summary>
    /// <param name="server">The server's port.</param>
    /// <param name="command">The command at which it hangs, the first time that it comes.</param>
    /// <param name="forGood">True if everything that comes later hangs as well.</param>
    public FtpHang(int server, string command, bool forGood)
    {
        (_server, _command, _forGood) = (server, command + " ", forGood);
        _loopback = new(RunAsync);
        _loopback.Start();
    }

    public int Port => _loopback.Port;

    /// <summary>True once the command came.</summary>
    public bool HasHung => _hasHung;

    /// <summary>Lets everything pass again.</summary>
    public bool IsOver { get; set; }

    public void Dispose() => _loopback.Dispose();

    private async Task RunAsync(TcpClient client)
    {
        if (_hasHung && _forGood && !IsOver)
        {
            await Task.Delay(Timeout.Infinite, _loopback.End);
        }

        using var server = new TcpClient();
        await server.ConnectAsync(IPAddress.Loopback, _server, _loopback.End);
        await Task.WhenAny(
            CommandsAsync(client.GetStream(), server.GetStream()), server.GetStream().CopyToAsync(client.GetStream(), _loopback.End));
    }

    private async Task CommandsAsync(NetworkStream from, NetworkStream to)
    {
        using var lines = new StreamReader(from, Encoding.Latin1);
        while (await lines.ReadLineAsync(_loopback.End) is { } line)
        {
            if (!_hasHung && line.StartsWith(_command, StringComparison.Ordinal))
            {
                _hasHung = true;

                // Until who waits for the answer gives up.
                await lines.ReadLineAsync(_loopback.End);
                return;
            }

            await to.WriteAsync(Encoding.Latin1.GetBytes(line + "\r\n"), _loopback.End);
        }
    }
}
