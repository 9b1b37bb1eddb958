using System.Net.Sockets;
using System.Runtime.CompilerServices;
using Renci.SshNet;
using SshSession = Renci.SshNet.Session;

namespace ErrorMatching.Cell;

/// <summary>The channel of a signed-in SSH connection on which a server's subsystem <c>sftp</c> speaks.</summary>
/// <remarks>SSH.NET offers this subsystem only through its own SFTP client, which can neither flush a file to the server's disk nor give a
/// file a second name. The members below are how that client itself opens the channel. The package is pinned to one exact version, and a
/// missing member fails the first connection of any test.</remarks>
internal sealed class SshChannel
{
    // A send that was let go takes microseconds of a processor, and on a busy computer waits for one.
    private static readonly TimeSpan SendEnds = TimeSpan.FromSeconds(1);
    private static readonly TimeSpan LookAgain = TimeSpan.FromMilliseconds(50);

    private readonly SshSession _session;
    private readonly object _channel;
    private readonly ManualResetEventSlim _hasKeys;
    private readonly Lock _sending = new();
    private Socket? _socket;

    /// <summary>Opens the subsystem. Blocks until the server has answered.</summary>
    /// <param name="client">The signed-in client.</param>
    /// <param name="received">Called with each piece of the server's data; it must not block.</param>
    /// <param name="ended">Called with a reason when nothing more will come, possibly several times; it must not block.</param>
    /// <exception cref="SshChannelException">The server has no such subsystem.</exception>
    public SshChannel(BaseClient client, Action<ReadOnlyMemory<byte>> received, Action<string> ended)
    {
        _session = SessionOf(client) as SshSession ?? throw new SshChannelException("the connection is closed");
        _socket = SocketOf(_session);
        _hasKeys = HasKeysOf(_session);

        // A machine that is switched off closes nothing: without this, a connection that waits would never notice.
        _socket?.SetSocketOption(SocketOptionLevel.Socket, SocketOptionName.KeepAlive, optionValue: true);
        _socket?.SetSocketOption(SocketOptionLevel.Tcp, SocketOptionName.TcpKeepAliveTime, 30);
        _socket?.SetSocketOption(SocketOptionLevel.Tcp, SocketOptionName.TcpKeepAliveInterval, 10);
        _socket?.SetSocketOption(SocketOptionLevel.Tcp, SocketOptionName.TcpKeepAliveRetryCount, 3);

        // It is the only channel of its connection.
        _session.ChannelDataReceived += (_, e) => received(e.Message.Data.AsMemory(e.Message.Offset, e.Message.Size));
        _session.ChannelEofReceived += (_, _) => ended("the server ended the session");
        _session.ChannelCloseReceived += (_, _) => ended("the server closed the session");
        _session.Disconnected += (_, _) => ended("the connection broke");
        _session.ErrorOccured += (_, e) => ended(e.Exception.Message);

        // This is also called when keys are changed, before the new ones are used.
        client.HostKeyReceived += (_, _) => LetSendEnd();
        _channel = ChannelOf(_session);
        Open(_channel);
        if (!StartSubsystem(_channel, "sftp"))
            throw new SshChannelException("the server offers no SFTP");
    }

    /// <summary>True while the connection is up.</summary>
    public bool IsUp => _session.IsConnected;

    /// <summary>Sends bytes. Blocks while the server takes none, until <see cref="Cut"/>.</summary>
    /// <remarks>Before it sends, the library looks whether keys are being changed, but not again once it is its turn. If the server changes
    /// keys in between, it sends with the cipher of the old ones, which is disposed of (SSH.NET, issue 1764). So nothing is sent here while
    /// keys are being changed, and no change of keys goes on while something is being sent.</remarks>
    public void Send(byte[] bytes, int count)
    {
        while (true)
        {
            while (!_hasKeys.Wait(LookAgain) && IsUp)
            {
                // They are being changed.
            }

            lock (_sending)
            {
                if (!_hasKeys.IsSet && IsUp)
                    continue;
                Send(_channel, bytes, 0, count);
                return;
            }
        }
    }

    /// <summary>Closes the socket without a word. A send that blocks ends with an error.</summary>
    public void Cut() => Interlocked.Exchange(ref _socket, null)?.Dispose();

    // Not for ever: one that the library itself holds until the keys are changed, or until the server takes more, does not end before.
    private void LetSendEnd()
    {
        if (_sending.TryEnter(SendEnds))
            _sending.Exit();
    }

    [UnsafeAccessor(UnsafeAccessorKind.Method, Name = "get_Session")]
    [return: UnsafeAccessorType("Renci.SshNet.ISession, Renci.SshNet")]
    private static extern object? SessionOf(BaseClient client);

    [UnsafeAccessor(UnsafeAccessorKind.Field, Name = "_socket")]
    private static extern ref Socket? SocketOf(SshSession session);

    [UnsafeAccessor(UnsafeAccessorKind.Field, Name = "_keyExchangeCompletedWaitHandle")]
    private static extern ref ManualResetEventSlim HasKeysOf(SshSession session);

    [UnsafeAccessor(UnsafeAccessorKind.Method, Name = "Renci.SshNet.ISession.CreateChannelSession")]
    [return: UnsafeAccessorType("Renci.SshNet.Channels.IChannelSession, Renci.SshNet")]
    private static extern object ChannelOf(SshSession session);

    [UnsafeAccessor(UnsafeAccessorKind.Method, Name = "Open")]
    private static extern void Open([UnsafeAccessorType("Renci.SshNet.Channels.ChannelSession, Renci.SshNet")] object channel);

    [UnsafeAccessor(UnsafeAccessorKind.Method, Name = "SendSubsystemRequest")]
    private static extern bool StartSubsystem(
        [UnsafeAccessorType("Renci.SshNet.Channels.ChannelSession, Renci.SshNet")] object channel, string subsystem);

    [UnsafeAccessor(UnsafeAccessorKind.Method, Name = "SendData")]
    private static extern void Send(
        [UnsafeAccessorType("Renci.SshNet.Channels.Channel, Renci.SshNet")] object channel, byte[] data, int offset, int size);
}

/// <summary>A server that does not open the subsystem.</summary>
internal sealed class SshChannelException(string message) : Exception(message);
