using System.Globalization;
using System.Net;
using System.Net.Sockets;
using System.Text;
using System.Text.RegularExpressions;
using ErrorMatching.Testing;

namespace ErrorMatching.Peers.Tests;

/// <summary>
/// Stands between curl and an FTP server. It understands the control connection as far as it must:
/// it puts ports of its own into the answers to PASV and EPSV, knows which data connection carries which file,
/// and breaks what it is told to break.
/// </summary>
internal sealed partial class FtpProxy : IDisposable
{
    private readonly LoopbackServer _loopback;
    private readonly int _server;
    private FtpFault? _fault;
    private int _readings;
    private int _sessions;
    private int _skipped;

    /// <summary>Starts it before a server on a loopback port.</summary>
    public FtpProxy(int server)
    {
        _server = server;
        _loopback = new(client => new Session(this, client).RunAsync());
        _loopback.Start();
    }

    public int Port => _loopback.Port;

    /// <summary>If set, renaming over a file of this folder is answered with 550, as some servers do.</summary>
    public string? KeepsFilesOf { get; set; }

    /// <summary>True as long as the fault has not happened.</summary>
    public bool IsArmed => Volatile.Read(ref _fault) is not null;

    /// <summary>Arms a fault.</summary>
    public void Arm(FtpFault fault)
    {
        _readings = 0;
        _skipped = 0;
        Volatile.Write(ref _fault, fault);
    }

    /// <summary>Forgets the fault if it has not happened.</summary>
    public void Disarm() => Volatile.Write(ref _fault, null);

    /// <summary>Waits until the server has ended all sessions: what it had heard before a cut it may do after it.</summary>
    public Task QuietAsync() => Quiet.WhenAsync(() => Volatile.Read(ref _sessions) == 0, "the server ends its sessions");

    public void Dispose() => _loopback.Dispose();

    private bool Takes(Func<FtpFault, bool> matches)
    {
        var fault = Volatile.Read(ref _fault);
        return fault is not null && matches(fault) && Interlocked.CompareExchange(ref _fault, null, fault) == fault;
    }

    // Sessions of one client follow each other, so nothing counts at the same time.
    private bool HasPassed(FtpFault fault) => _skipped++ >= fault.Skip;

    private sealed class Session(FtpProxy proxy, TcpClient client)
    {
        private readonly CancellationTokenSource _cut = CancellationTokenSource.CreateLinkedTokenSource(proxy._loopback.End);
        private string _command = "";
        private string _argument = "";

        public async Task RunAsync()
        {
            Interlocked.Increment(ref proxy._sessions);
            using var server = new TcpClient { NoDelay = true };
            client.NoDelay = true;
            try
            {
                await server.ConnectAsync(IPAddress.Loopback, proxy._server, _cut.Token);
                var (up, down) = (
                    CommandsAsync(client.GetStream(), server.GetStream()), AnswersAsync(server.GetStream(), client.GetStream()));
                await Task.WhenAny(up, down);
            }
            catch (Exception e) when (LoopbackServer.IsEnd(e))
            {
            }
            finally
            {
                await _cut.CancelAsync();
                client.Dispose();
                await EndAsync(server);
                Interlocked.Decrement(ref proxy._sessions);
            }
        }

        // Reads until the server, too, has hung up.
        private async Task EndAsync(TcpClient server)
        {
            try
            {
                server.Client.Shutdown(SocketShutdown.Send);
                var buffer = new byte[1024];
                while (await server.GetStream().ReadAsync(buffer, proxy._loopback.End) > 0)
                {
                }
            }
            catch (Exception e) when (LoopbackServer.IsEnd(e) || e is InvalidOperationException)
            {
            }
        }

        private async Task CommandsAsync(NetworkStream from, NetworkStream to)
        {
            using var lines = new StreamReader(from, Encoding.Latin1);
            while (await lines.ReadLineAsync(_cut.Token) is { } line)
            {
                var space = line.IndexOf(' ', StringComparison.Ordinal);
                (_command, _argument) = space < 0 ? (line, "") : (line[..space], line[(space + 1)..]);
                if (proxy.Takes(f => f.CutBefore == _command && proxy.HasPassed(f)))
                    return;
                (string Command, string Answer)? instead = null;
                if (proxy.Takes(f => (instead = f.Instead)?.Command == _command))
                {
                    await WriteLineAsync(from, instead!.Value.Answer);
                    if (instead.Value.Answer.StartsWith("421", StringComparison.Ordinal))
                        return;
                    continue;
                }

                if (_command == "RNTO" && proxy.KeepsFilesOf is { } folder && File.Exists(Path.Combine(folder, _argument)))
                {
                    await WriteLineAsync(from, "550 File exists.");
                    continue;
                }

                await WriteLineAsync(to, line);
            }
        }

        private async Task AnswersAsync(NetworkStream from, NetworkStream to)
        {
            using var lines = new StreamReader(from, Encoding.Latin1);
            while (await lines.ReadLineAsync(_cut.Token) is { } line)
            {
                var isLast = line.Length > 3 && line[3] == ' ' && line[0] is not '1';
                if (isLast && proxy.Takes(f => f.CutAfter == _command && proxy.HasPassed(f)))
                    return;
                (string Command, string Answer)? last = null;
                if (isLast && proxy.Takes(f => (last = f.Finally)?.Command == _command))
                    line = last!.Value.Answer;
                if (Extended().Match(line) is { Success: true } extended)
                    line = string.Create(
                        CultureInfo.InvariantCulture,
                        $"229 Entering Extended Passive Mode (|||"
                            + $"{Listen(int.Parse(extended.Groups["port"].ValueSpan, CultureInfo.InvariantCulture))}|)");
                else if (Passive().Match(line) is { Success: true } passive)
                    line = PassiveAnswer(passive);
                await WriteLineAsync(to, line);
            }
        }

        private string PassiveAnswer(Match passive)
        {
            int Part(string name) => int.Parse(passive.Groups[name].ValueSpan, CultureInfo.InvariantCulture);
            var port = Listen((Part("high") << 8) + Part("low"));
            return string.Create(CultureInfo.InvariantCulture, $"227 Entering Passive Mode (127,0,0,1,{port >> 8},{port & 255}).");
        }

        private int Listen(int server)
        {
            var listener = new TcpListener(IPAddress.Loopback, 0);
            listener.Start(1);
            _ = DataAsync(listener, server);
            return ((IPEndPoint)listener.LocalEndpoint).Port;
        }

        private async Task DataAsync(TcpListener listener, int serverPort)
        {
            try
            {
                using var data = await listener.AcceptTcpClientAsync(_cut.Token);
                listener.Stop();
                using var server = new TcpClient { NoDelay = true };
                await server.ConnectAsync(IPAddress.Loopback, serverPort, _cut.Token);
                data.NoDelay = true;
                await Task.WhenAny(
                    PumpAsync(data, server, isWriting: true),
                    PumpAsync(server, data, isWriting: false));
            }
            catch (Exception e) when (LoopbackServer.IsEnd(e))
            {
            }
            finally
            {
                listener.Stop();
            }
        }

        private async Task PumpAsync(TcpClient from, TcpClient to, bool isWriting)
        {
            var buffer = new byte[16 << 10];
            var passed = 0;
            FtpFault? fault = null;
            if (isWriting
                && await MaySendAsync("STOR")
                && proxy.Takes(f => (fault = f) is { CutWriting: not null } or { StallWriting: not null } or { CorruptWriting: not null }))
            {
            }
            else if (!isWriting && await MaySendAsync("RETR"))
            {
                var number = Interlocked.Increment(ref proxy._readings) - 1;
                if (!proxy.Takes(
                    f => (fault = f).Reading == number
                        && f is { CutReading: not null } or { StallReading: not null } or { CorruptReading: not null }))
                    fault = null;
            }
            else
            {
                fault = null;
            }

            var (cut, stall, corrupt) = isWriting
                ? (fault?.CutWriting, fault?.StallWriting, fault?.CorruptWriting)
                : (fault?.CutReading, fault?.StallReading, fault?.CorruptReading);
            int read;
            while ((read = cut == 0 ? 0 : await from.GetStream().ReadAsync(buffer, _cut.Token)) > 0)
            {
                if (corrupt is { } at && at >= passed && at < passed + read)
                    buffer[at - passed] ^= 0x20;
                var through = Math.Min(read, (cut ?? stall ?? int.MaxValue) - passed);
                await to.GetStream().WriteAsync(buffer.AsMemory(0, through), _cut.Token);
                passed += through;
                if (stall is not null && passed == stall)
                    await Task.Delay(Timeout.Infinite, _cut.Token);
                if (cut is not null && passed == cut)
                    break;
            }

            if (cut is not null)
                await _cut.CancelAsync();
            else if (read == 0)
                to.Client.Shutdown(SocketShutdown.Send);
        }

        // The data connection is made before its command is given.
        private async Task<bool> MaySendAsync(string command)
        {
            while (_command is "EPSV" or "PASV" or "TYPE" or "SIZE" or "RNFR" or "RNTO")
                await Task.Delay(1, _cut.Token);
            return _command == command;
        }

        private async Task WriteLineAsync(NetworkStream to, string line) =>
            await to.WriteAsync(Encoding.Latin1.GetBytes(line + "\r\n"), _cut.Token);
    }

    [GeneratedRegex(@"\A229 .*\(\|\|\|(?<port>[0-9]+)\|\)", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Extended();

    [GeneratedRegex(@"\A227 .*\([0-9]+,[0-9]+,[0-9]+,[0-9]+,(?<high>[0-9]+),(?<low>[0-9]+)\)", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Passive();
}
