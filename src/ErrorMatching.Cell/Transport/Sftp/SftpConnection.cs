using System.Diagnostics;
using System.Net.Sockets;
using Renci.SshNet;
using Renci.SshNet.Common;

namespace ErrorMatching.Cell;

/// <summary>A signed-in connection to an SFTP server. One operation at a time uses it.</summary>
internal sealed class SftpConnection : IDisposable
{
    // OpenSSH's own programs accept no others either: nothing with MD5, CBC or a group that is too small.
    private static readonly string[] Exchanges = [
        "mlkem768x25519-sha256", "sntrup761x25519-sha512", "sntrup761x25519-sha512@openssh.com", "curve25519-sha256",
        "curve25519-sha256@libssh.org", "ecdh-sha2-nistp256", "ecdh-sha2-nistp384", "ecdh-sha2-nistp521",
        "diffie-hellman-group-exchange-sha256", "diffie-hellman-group16-sha512", "diffie-hellman-group18-sha512",
        "diffie-hellman-group14-sha256"];

    // Those that the processor has instructions for come first.
    private static readonly string[] Ciphers = [
        "aes128-gcm@openssh.com", "aes256-gcm@openssh.com", "aes128-ctr", "aes192-ctr", "aes256-ctr", "chacha20-poly1305@openssh.com"];

    private static readonly string[] Codes = [
        "hmac-sha2-256-etm@openssh.com", "hmac-sha2-512-etm@openssh.com", "hmac-sha2-256", "hmac-sha2-512", "hmac-sha1-etm@openssh.com",
        "hmac-sha1"];

    private readonly SshClient _client;
    private readonly SftpSession _session;
    private readonly SshChannel _channel;
    private long _used = Stopwatch.GetTimestamp();

    private SftpConnection(SshClient client)
    {
        _client = client;
        SshChannel? channel = null;
        _session = new((bytes, count) => channel!.Send(bytes, count));
        channel = _channel = new(
            client,
            bytes =>
            {
                // A server that sends what was not asked for may never end.
                if (!_session.Receive(bytes.Span))
                    channel?.Cut();
            },
            reason => _session.End(reason));
        Files = new(_session);
    }

    /// <summary>What can be done over it.</summary>
    public SftpFiles Files { get; }

    /// <summary>True if another operation may use it.</summary>
    public bool IsFit => Files.IsAtRest && _channel.IsUp;

    /// <summary>How long nothing has used it.</summary>
    public TimeSpan Idle => Stopwatch.GetElapsedTime(_used);

    /// <summary>Connects, checks the server's key, and signs in.</summary>
    /// <param name="sftp">The server.</param>
    /// <param name="secret">Returns the password.</param>
    /// <param name="limit">The longest that each step may take.</param>
    /// <param name="cancellation">Cancels the wait. Until its own limits end it, the connecting may go on for a while; it changes nothing
    /// at the server.</param>
    /// <exception cref="SftpConnectException">There is no connection.</exception>
    public static async Task<SftpConnection> OpenAsync(
        SftpSettings sftp, Func<string?> secret, TimeSpan limit, CancellationToken cancellation)
    {
        // The library blocks its thread while it waits for the server.
        var opening = Task.Run(() => ConnectAsync(sftp, secret, limit, cancellation), CancellationToken.None);
        try
        {
            return await opening.WaitAsync(cancellation).ConfigureAwait(false);
        }
        catch (OperationCanceledException) when (!opening.IsCompleted)
        {
            _ = opening.ContinueWith(
                o => o.Result.Dispose(), CancellationToken.None, TaskContinuationOptions.OnlyOnRanToCompletion, TaskScheduler.Default);
            throw;
        }
    }

    /// <summary>Remembers that it was used just now.</summary>
    public void Touch() => _used = Stopwatch.GetTimestamp();

    /// <summary>Breaks the connection at once. What waits for an answer fails, and what is being sent, too.</summary>
    public void Cut()
    {
        _session.End("the connection was given up");
        _channel.Cut();
    }

    /// <summary>Says goodbye, and waits until the connection is closed.</summary>
    public void Dispose()
    {
        _session.End("the connection is closed");
        _client.Dispose();
    }

    private static async Task<SftpConnection> ConnectAsync(
        SftpSettings sftp, Func<string?> secret, TimeSpan limit, CancellationToken cancellation)
    {
        var pin = new HostKeyPin(sftp.HostKey);
        if (pin.Signatures.Count == 0)
            throw new SftpConnectException(
                TransportError.WrongServer, $"the pinned key has the type \"{ServerWords.Of(pin.Kind)}\", by which no server is trusted: "
                    + "pin its ED25519, ECDSA or RSA key");
        byte[]? offered = null;
        ConnectionInfo? info = null;
        SshClient? client = null;
        try
        {
            using var who = sftp.KeyFile is { } key ? new SftpSignIn(sftp.User, key) : new SftpSignIn(sftp.User, secret);
            info = new ConnectionInfo(sftp.Host, sftp.Port, sftp.User, who.Methods) { Timeout = limit };
            Keep(info.HostKeyAlgorithms, pin.Signatures);
            Keep(info.KeyExchangeAlgorithms, Exchanges);
            Keep(info.Encryptions, Ciphers);
            Keep(info.HmacAlgorithms, Codes);

            // A server that compresses may send very much in very little.
            Keep(info.CompressionAlgorithms, ["none"]);
            // A server may ask whether the client is still there. The library gives no answer to requests that it knows, and refuses those
            // that it does not know. Either answer will do.
            info.ChannelRequests.Clear();
            client = new(info);
            client.HostKeyReceived += (_, e) =>
            {
                e.CanTrust = pin.IsKey(e.HostKey);
                if (!e.CanTrust)
                    offered = e.HostKey;
            };
            await client.ConnectAsync(cancellation).ConfigureAwait(false);
            var connection = new SftpConnection(client);
            using var late = cancellation.Register(connection.Cut);
            await connection._session.GreetAsync().ConfigureAwait(false);
            client = null;
            return connection;
        }
        catch (OperationCanceledException)
        {
            throw;
        }
        catch (Exception e)
        {
            // A hostile server can make the library throw almost anything.
            throw offered is null ? Failed(e, info, pin) : new SftpConnectException(
                TransportError.WrongServer,
                $"the server's key is {HostKeyPin.Describe(offered)}, the pinned one is {pin.Kind} {pin.Fingerprint}", e);
        }
        finally
        {
            client?.Dispose();
        }
    }

    private static SftpConnectException Failed(Exception failure, ConnectionInfo? info, HostKeyPin pin) => failure switch
    {
        SftpSignInException or SshAuthenticationException => new(TransportError.Login, ServerWords.Of(failure.Message), failure),
        SshChannelException => new(TransportError.Denied, failure.Message, failure),
        SshOperationTimeoutException or SocketException { SocketErrorCode: SocketError.TimedOut } =>
            new(TransportError.Slow, failure.Message, failure),
        SshConnectionException when info is { CurrentKeyExchangeAlgorithm: not null, CurrentHostKeyAlgorithm: null } => new(
            TransportError.WrongServer,
            $"the server has no key of the pinned one's type ({ServerWords.Of(failure.Message)}); the pinned one is "
                + $"{pin.Kind} {pin.Fingerprint}",
            failure),
        ArgumentException => new(TransportError.Unknown, ServerWords.Of(failure.Message), failure),
        _ => new(TransportError.Away, ServerWords.Of(failure.Message), failure),
    };

    private static void Keep<T>(IOrderedDictionary<string, T> offered, IReadOnlyList<string> names)
    {
        var all = offered.ToDictionary(StringComparer.Ordinal);
        offered.Clear();
        foreach (var name in names)
            offered.Add(name, all[name]);
    }
}

/// <summary>A connection that did not come about.</summary>
/// <param name="error">Why.</param>
/// <param name="message">What happened; no secrets.</param>
/// <param name="cause">The underlying error.</param>
internal sealed class SftpConnectException(TransportError error, string message, Exception? cause = null) : Exception(message, cause)
{
    /// <summary>Why.</summary>
    public TransportError Error => error;
}

/// <summary>What a server said, as far as a message may repeat it.</summary>
internal static class ServerWords
{
    private const int Most = 200;

    /// <summary>The words without control characters, shortened.</summary>
    public static string Of(string said) =>
        string.Concat(said.Take(Most).Select(c => char.IsControl(c) || char.IsSurrogate(c) ? ' ' : c)).Trim()
        + (said.Length > Most ? "..." : "");
}
