using System.Net;
using System.Net.Sockets;
using ErrorMatching.Testing;

namespace ErrorMatching.Peers.Tests;

/// <summary>Stands between the cell and an SSH server, whose stream it cannot read:
/// cuts it after so many bytes, holds it, or changes one.</summary>
internal sealed class CutProxy : IDisposable
{
    /// <summary>In place of a connection's number: whichever is the first to pass so many bytes.</summary>
    public const int Any = -1;

    // IPPROTO_TCP and TCP_QUICKACK of Linux; see tcp(7).
    private const int Tcp = 6;
    private const int QuickAck = 12;

    private readonly LoopbackServer _loopback;
    private readonly int _server;
    private CancellationTokenSource _hangUp = new();
    private CutFault? _fault;
    private int _sessions;
    private int _connections;
    private int _held;
    private long _up;
    private long _down;

    /// <summary>Starts it before a server on a loopback port.</summary>
    public CutProxy(int server)
    {
        _server = server;
        _loopback = new(RunAsync);
        _loopback.Start();
    }

    public int Port => _loopback.Port;

    /// <summary>True as long as the fault has not happened.</summary>
    public bool IsArmed => Volatile.Read(ref _fault) is not null;

    /// <summary>How many bytes went through the last connection to the server, and from it.</summary>
    public (long Up, long Down) Passed => (Interlocked.Read(ref _up), Interlocked.Read(ref _down));

    /// <summary>How many connections came since the last fault was armed.</summary>
    public int Connections => Volatile.Read(ref _connections);

    /// <summary>How many connections are open to the server.</summary>
    public int Open => Volatile.Read(ref _sessions);

    /// <summary>Lets nothing through any more on the connections that are open now, and closes none of them.</summary>
    public void Hold() => Volatile.Write(ref _held, Connections);

    /// <summary>Closes all connections, as a server does that is started again.</summary>
    public void HangUp() => Interlocked.Exchange(ref _hangUp, new()).Cancel();

    /// <summary>Arms a fault; connections are counted from here.</summary>
    public void Arm(CutFault? fault)
    {
        _connections = 0;
        Volatile.Write(ref _fault, fault);
    }

    /// <summary>Waits until the server has ended all sessions: what it had heard before a cut it may do after it.</summary>
    public Task QuietAsync() => Quiet.WhenAsync(() => Volatile.Read(ref _sessions) == 0, "the server ends its sessions");

    public void Dispose() => _loopback.Dispose();

    private static bool IsEnd(Exception e) => LoopbackServer.IsEnd(e) || e is InvalidOperationException;

    private async Task RunAsync(TcpClient client)
    {
        Interlocked.Increment(ref _sessions);
        var number = Interlocked.Increment(ref _connections) - 1;
        using var cut = CancellationTokenSource.CreateLinkedTokenSource(_loopback.End, _hangUp.Token);
        using var server = new TcpClient { NoDelay = true };
        client.NoDelay = true;
        (_up, _down) = (0, 0);
        try
        {
            await server.ConnectAsync(IPAddress.Loopback, _server, cut.Token);
            var fault = Volatile.Read(ref _fault) is { } armed && (armed.Connection == Any || armed.Connection == number) ? armed : null;
            await Task.WhenAny(
                PumpAsync(client, server, fault is { IsUp: true } ? fault : null, true, number, cut),
                PumpAsync(server, client, fault is { IsUp: false } ? fault : null, false, number, cut));
        }
        catch (Exception e) when (IsEnd(e))
        {
        }

        await cut.CancelAsync();
        client.Dispose();
        try
        {
            // Reads until the server, too, has hung up.
            server.Client.Shutdown(SocketShutdown.Send);
            var rest = new byte[4096];
            while (await server.GetStream().ReadAsync(rest, _loopback.End) > 0)
            {
            }
        }
        catch (Exception e) when (IsEnd(e))
        {
        }

        Interlocked.Decrement(ref _sessions);
    }

    private async Task PumpAsync(TcpClient from, TcpClient to, CutFault? fault, bool isUp, int number, CancellationTokenSource cut)
    {
        var buffer = new byte[16 << 10];
        long passed = 0;
        while (true)
        {
            var room = fault is { Kind: not CutKind.Corrupt } ? (int)Math.Min(buffer.Length, fault.After - passed) : buffer.Length;
            if (room == 0)
            {
                Volatile.Write(ref _fault, null);
                while (fault!.Kind == CutKind.Stall && await from.GetStream().ReadAsync(buffer, cut.Token) > 0)
                {
                    // What comes goes nowhere, until who sends it gives up.
                }

                return;
            }

            // OpenSSH holds a small packet back until the one before is acknowledged, which Linux does 40 ms later unless asked to do it at
            // once, each time.
            if (OperatingSystem.IsLinux())
                from.Client.SetRawSocketOption(Tcp, QuickAck, [1, 0, 0, 0]);
            var read = await from.GetStream().ReadAsync(buffer.AsMemory(0, room), cut.Token);
            if (read == 0)
                return;
            if (number < Volatile.Read(ref _held))
                continue;
            if (fault is { Kind: CutKind.Corrupt } && fault.After >= passed && fault.After < passed + read)
            {
                buffer[fault.After - passed] ^= 0x20;
                Volatile.Write(ref _fault, null);
            }

            passed += read;
            Interlocked.Add(ref (isUp ? ref _up : ref _down), read);
            await to.GetStream().WriteAsync(buffer.AsMemory(0, read), cut.Token);
        }
    }
}
