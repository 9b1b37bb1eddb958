using System.Net;
using System.Net.Sockets;
using System.Text;

namespace ErrorMatching.Peers.Tests;

/// <summary>Stands before an FTP server's control port and hangs when a command comes: from then on nothing passes, in this session or, if it shall, in any.</summary>
internal sealed class FtpHang : IDisposable
{
    private readonly TcpListener _listener = new(IPAddress.Loopback, 0);
    private readonly CancellationTokenSource _end = new();
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
        _listener.Start(64);
        _ = ServeAsync();
    }

    public int Port => ((IPEndPoint)_listener.LocalEndpoint).Port;

    /// <summary>True once the command came.</summary>
    public bool HasHung => _hasHung;

    /// <summary>Lets everything pass again.</summary>
    public bool IsOver { get; set; }

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
                _ = RunAsync(await _listener.AcceptTcpClientAsync(_end.Token));
            }
        }
        catch (Exception e) when (IsEnd(e))
        {
        }
    }

    private async Task RunAsync(TcpClient client)
    {
        using var server = new TcpClient();
        using (client)
        {
            try
            {
                if (_hasHung && _forGood && !IsOver)
                {
                    await Task.Delay(Timeout.Infinite, _end.Token);
                }

                await server.ConnectAsync(IPAddress.Loopback, _server, _end.Token);
                await Task.WhenAny(CommandsAsync(client.GetStream(), server.GetStream()), server.GetStream().CopyToAsync(client.GetStream(), _end.Token));
            }
            catch (Exception e) when (IsEnd(e))
            {
            }
        }
    }

    private async Task CommandsAsync(NetworkStream from, NetworkStream to)
    {
        using var lines = new StreamReader(from, Encoding.Latin1);
        while (await lines.ReadLineAsync(_end.Token) is { } line)
        {
            if (!_hasHung && line.StartsWith(_command, StringComparison.Ordinal))
            {
                _hasHung = true;

                // Until who waits for the answer gives up.
                await lines.ReadLineAsync(_end.Token);
                return;
            }

            await to.WriteAsync(Encoding.Latin1.GetBytes(line + "\r\n"), _end.Token);
        }
    }

    private static bool IsEnd(Exception e) => e is OperationCanceledException or IOException or SocketException or ObjectDisposedException;
}
