using System.Buffers.Binary;

namespace ErrorMatching.Cell;

/// <summary>Requests to an SFTP server and its answers, in the order in which the server gives them. One operation at a time uses
/// it.</summary>
/// <param name="send">Sends bytes to the server; it may block.</param>
internal sealed class SftpSession(Action<byte[], int> send)
{
    /// <summary>The only version of the protocol that is spoken.</summary>
    private const uint Version = 3;

    // OpenSSH sends and accepts up to this many.
    private const int MostMessage = 256 << 10;

    private readonly Lock _gate = new();
    private readonly Dictionary<uint, TaskCompletionSource<SftpReply>> _asked = [];
    private readonly TaskCompletionSource<SftpReply> _greeted = New();
    private byte[] _got = new byte[4096];
    private int _count;
    private uint _last;
    private SftpLostException? _end;

    /// <summary>The extensions that the server names.</summary>
    public IReadOnlySet<string> Extensions { get; private set; } = new HashSet<string>(StringComparer.Ordinal);

    /// <summary>True if every request was answered and more can be asked.</summary>
    public bool IsAtRest
    {
        get
        {
            lock (_gate)
                return _end is null && _asked.Count == 0;
        }
    }

    /// <summary>Agrees on the version.</summary>
    /// <exception cref="SftpLostException">The connection broke, or the server speaks another version only.</exception>
    public async Task GreetAsync()
    {
        var init = SftpRequest.Init(Version);
        send(init, init.Length);
        var answer = await _greeted.Task.ConfigureAwait(false);
        if (answer.Number() is var version && version != Version)
            throw new SftpLostException(
                FormattableString.Invariant($"the server speaks version {version} of SFTP, and {Version} is needed"));
        var extensions = new HashSet<string>(StringComparer.Ordinal);
        while (!answer.IsAtEnd)
        {
            extensions.Add(answer.Text());
            answer.Bytes();
        }

        Extensions = extensions;
    }

    /// <summary>Sends a request.</summary>
    /// <returns>The answer, whatever its type.</returns>
    /// <exception cref="SftpLostException">The connection broke before the answer came.</exception>
    public Task<SftpReply> AskAsync(SftpRequest request)
    {
        var answer = New();
        uint id;
        lock (_gate)
        {
            if (_end is not null)
                return Task.FromException<SftpReply>(_end);
            id = ++_last;
            _asked.Add(id, answer);
        }

        try
        {
            send(request.Numbered(id), request.Count);
        }
        catch (Exception e) when (e is not SftpLostException)
        {
            // Whatever the library throws there, the connection is of no use any more.
            End("the connection broke while sending: " + e.Message, e);
        }

        return answer.Task;
    }

    /// <summary>Takes what came from the server. A server that sends what was not asked for, or more than fits, is not listened to any
    /// more.</summary>
    /// <returns>False if the session has ended.</returns>
    public bool Receive(ReadOnlySpan<byte> bytes)
    {
        lock (_gate)
        {
            if (_end is not null)
                return false;
        }

        if (_count + bytes.Length > _got.Length)
            Array.Resize(ref _got, Math.Max(2 * _got.Length, _count + bytes.Length));
        bytes.CopyTo(_got.AsSpan(_count));
        _count += bytes.Length;
        var at = 0;
        while (_count - at >= 4)
        {
            var length = BinaryPrimitives.ReadUInt32BigEndian(_got.AsSpan(at));
            if (length is < 5 or > MostMessage)
            {
                End(FormattableString.Invariant($"the server announced a message of {length} bytes, 5 to {MostMessage} are taken"));
                return false;
            }

            if (_count - at - 4 < length)
                break;
            if (!Take(_got.AsSpan(at + 4, (int)length)))
                return false;
            at += 4 + (int)length;
        }

        _got.AsSpan(at, _count - at).CopyTo(_got);
        _count -= at;
        return true;
    }

    /// <summary>Fails all requests that are not answered, and all later ones. Only the first reason is reported.</summary>
    public void End(string reason, Exception? cause = null)
    {
        TaskCompletionSource<SftpReply>[] open;
        lock (_gate)
        {
            _end ??= new SftpLostException(reason, cause);
            open = [.. _asked.Values, _greeted];
            _asked.Clear();
        }

        foreach (var one in open)
            one.TrySetException(_end);
    }

    private bool Take(ReadOnlySpan<byte> message)
    {
        var type = (SftpType)message[0];
        if (type == SftpType.Version && _greeted.TrySetResult(new(type, message[1..].ToArray())))
            return true;
        TaskCompletionSource<SftpReply>? asked;
        lock (_gate)
            _asked.Remove(BinaryPrimitives.ReadUInt32BigEndian(message[1..]), out asked);
        if (asked is null)
        {
            End("the server answered what it was not asked");
            return false;
        }

        return asked.TrySetResult(new(type, message[5..].ToArray()));
    }

    // The thread that received an answer must not go on with the operation: it would not receive the next one.
    private static TaskCompletionSource<SftpReply> New() => new(TaskCreationOptions.RunContinuationsAsynchronously);
}

/// <summary>A session that broke or that cannot be trusted any more.</summary>
internal sealed class SftpLostException(string message, Exception? cause = null) : Exception(message, cause);
