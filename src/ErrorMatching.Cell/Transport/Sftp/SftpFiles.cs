namespace ErrorMatching.Cell;

/// <summary>What is done with files and folders over an SFTP session. Paths are the server's.</summary>
/// <remarks>Each operation throws an <see cref="SftpStatusException"/> if the server refuses, and an <see cref="SftpLostException"/> if the
/// session broke.</remarks>
internal sealed class SftpFiles(SftpSession session)
{
    private const string RenamesOver = "posix-rename@openssh.com";
    private const string Links = "hardlink@openssh.com";
    private const string Syncs = "fsync@openssh.com";

    // Every server takes and sends this much in one message.
    private const int Piece = 32 << 10;

    // So many pieces are on the way at a time: a distant server must not cost a round trip for each.
    private const int Window = 16;
    private const int MostNames = 4 << 20;
    private const int LeastAnswer = 512;

    // A server that lies about a size must send as much before it costs memory.
    private const int MostTaken = 1 << 20;
    private const uint OpenToRead = 1;
    private const uint OpenToReplace = 2 | 8 | 16;
    private const uint WithMode = 4;
    private const uint ForEverybody = 0b110_110_110;
    private int _open;

    /// <summary>True if nothing is open at the server, and nothing unanswered.</summary>
    public bool IsAtRest => _open == 0 && session.IsAtRest;

    /// <summary>Asks the server for an answer that changes nothing.</summary>
    public Task GreetAgainAsync() => AskAsync(new SftpRequest(SftpType.RealPath).Add("."), SftpType.Name);

    /// <summary>The names in a folder, but not those that begin with a dot.</summary>
    /// <returns>Null if there are more than fit.</returns>
    public async Task<IReadOnlyList<string>?> NamesAsync(string folder)
    {
        var handle = await HandleAsync(new SftpRequest(SftpType.OpenFolder).Add(folder)).ConfigureAwait(false);
        var names = new List<string>();
        var bytes = 0L;
        while (await NextNamesAsync(handle).ConfigureAwait(false) is { } next)
        {
            for (var count = next.Number(); count > 0; count--)
            {
                var name = next.Text();
                bytes += name.Length + next.Bytes().Length;
                _ = next.Attributes();
                if (!name.StartsWith('.'))
                    names.Add(name);
            }

            // A folder may never end, and answers without names would never end it either.
            if ((bytes += LeastAnswer) > MostNames)
                break;
        }

        await CloseAsync(handle).ConfigureAwait(false);
        return bytes > MostNames ? null : names;
    }

    /// <summary>Size and type of a file; a link is not followed.</summary>
    public async Task<(long? Size, bool IsPlain)> LookAsync(string path) =>
        (await AskAsync(new SftpRequest(SftpType.LStat).Add(path), SftpType.Attributes).ConfigureAwait(false)).Attributes();

    /// <summary>The content of a file.</summary>
    /// <param name="path">The file.</param>
    /// <param name="size">Its size, as far as known.</param>
    /// <param name="most">More than this is not read.</param>
    /// <returns>The bytes, up to one more than <paramref name="most"/>.</returns>
    public async Task<byte[]> ReadAsync(string path, long? size, long most)
    {
        var handle = await HandleAsync(new SftpRequest(SftpType.Open).Add(path).Add(OpenToRead).Add(0u)).ConfigureAwait(false);
        using var content = new MemoryStream((int)Math.Min(Math.Min(size ?? 0, most) + 1, MostTaken));
        var asked = new Queue<(long From, int Count, Task<SftpReply> Answer)>();
        var next = 0L;
        var isAtEnd = false;
        while (!isAtEnd && content.Length <= most)
        {
            // The last one of them finds the end; what has grown meanwhile is read piece by piece.
            while (asked.Count == 0 || (asked.Count < Window && next <= (size ?? 0)))
            {
                asked.Enqueue((next, Piece, PieceAsync(handle, next, Piece)));
                next += Piece;
            }

            var (from, count, answer) = asked.Dequeue();
            for (var got = 0; got < count && !isAtEnd;)
            {
                var came = await (got == 0 ? answer : PieceAsync(handle, from + got, count - got)).ConfigureAwait(false);
                var piece = Data(came, count - got);
                isAtEnd = piece.Length == 0;
                got += piece.Length;
                content.Write(piece);
            }
        }

        foreach (var (_, _, rest) in asked)
            _ = await rest.ConfigureAwait(false);
        await CloseAsync(handle).ConfigureAwait(false);
        if (content.Length > most)
            content.SetLength(most + 1);
        return content.ToArray();
    }

    /// <summary>Writes a file, replacing an existing one, to the server's disk if the server can. Its mode is what the server's umask
    /// leaves of read and write for everybody: the control is another user.</summary>
    public async Task WriteAsync(string path, ReadOnlyMemory<byte> bytes)
    {
        var handle = await HandleAsync(
            new SftpRequest(SftpType.Open).Add(path).Add(OpenToReplace).Add(WithMode).Add(ForEverybody)).ConfigureAwait(false);
        var asked = new Queue<Task<SftpReply>>();
        for (var at = 0; at < bytes.Length; at += Piece)
        {
            if (asked.Count == Window)
                await DoneAsync(asked.Dequeue()).ConfigureAwait(false);
            var piece = bytes.Slice(at, Math.Min(Piece, bytes.Length - at));
            asked.Enqueue(session.AskAsync(new SftpRequest(SftpType.Write).Add(handle).Add((long)at).Add(piece.Span)));
        }

        while (asked.TryDequeue(out var answer))
            await DoneAsync(answer).ConfigureAwait(false);
        if (session.Extensions.Contains(Syncs))
            await DoAsync(new SftpRequest(SftpType.Extended).Add(Syncs).Add(handle)).ConfigureAwait(false);
        await CloseAsync(handle).ConfigureAwait(false);
    }

    /// <summary>Renames a file, over an existing one if the server can.</summary>
    public Task RenameAsync(string from, string to) => DoAsync(
        session.Extensions.Contains(RenamesOver)
            ? new SftpRequest(SftpType.Extended).Add(RenamesOver).Add(from).Add(to)
            : new SftpRequest(SftpType.Rename).Add(from).Add(to));

    /// <summary>Gives a file a second name.</summary>
    /// <returns>False if the server does not do that; then nothing has changed.</returns>
    public async Task<bool> LinkAsync(string file, string second)
    {
        if (!session.Extensions.Contains(Links))
            return false;
        try
        {
            await DoAsync(new SftpRequest(SftpType.Extended).Add(Links).Add(file).Add(second)).ConfigureAwait(false);
            return true;
        }
        catch (SftpStatusException e) when (e.Error != TransportError.Away)
        {
            return false;
        }
    }

    /// <summary>Deletes a file.</summary>
    public Task RemoveAsync(string path) => DoAsync(new SftpRequest(SftpType.Remove).Add(path));

    private async Task CloseAsync(byte[] handle)
    {
        await DoAsync(new SftpRequest(SftpType.Close).Add(handle)).ConfigureAwait(false);
        _open--;
    }

    private async Task<SftpReply?> NextNamesAsync(byte[] handle)
    {
        var answer = await session.AskAsync(new SftpRequest(SftpType.ReadFolder).Add(handle)).ConfigureAwait(false);
        return answer.Type == SftpType.Status && DemandSuccess(answer, SftpStatusException.EndOfFile)
            ? null
            : Demand(answer, SftpType.Name);
    }

    private async Task<byte[]> HandleAsync(SftpRequest request)
    {
        var handle = (await AskAsync(request, SftpType.Handle).ConfigureAwait(false)).Bytes().ToArray();
        _open++;
        return handle;
    }

    private Task<SftpReply> PieceAsync(byte[] handle, long from, int count) =>
        session.AskAsync(new SftpRequest(SftpType.Read).Add(handle).Add(from).Add((uint)count));

    // Empty at the end of the file.
    private static byte[] Data(SftpReply answer, int most)
    {
        if (answer.Type == SftpType.Status && DemandSuccess(answer, SftpStatusException.EndOfFile))
            return [];
        var piece = Demand(answer, SftpType.Data).Bytes();
        return piece.Length <= most && piece.Length > 0
            ? piece.ToArray()
            : throw new SftpLostException(
                FormattableString.Invariant($"the server sent {piece.Length} bytes of a file, 1 to {most} were asked"));
    }

    private Task DoAsync(SftpRequest request) => DoneAsync(session.AskAsync(request));

    private static async Task DoneAsync(Task<SftpReply> answer) =>
        _ = DemandSuccess(Demand(await answer.ConfigureAwait(false), SftpType.Status), 0);

    private async Task<SftpReply> AskAsync(SftpRequest request, SftpType type) =>
        Demand(await session.AskAsync(request).ConfigureAwait(false), type);

    private static SftpReply Demand(SftpReply answer, SftpType type)
    {
        if (answer.Type == type)
            return answer;
        if (answer.Type == SftpType.Status)
            DemandSuccess(answer, 0);
        throw new SftpLostException($"the server answered {answer.Type} where {type} was expected");
    }

    private static bool DemandSuccess(SftpReply status, uint expected)
    {
        var code = status.Number();
        return code == expected ? true : throw new SftpStatusException(code, status.IsAtEnd ? "" : ServerWords.Of(status.Text()));
    }
}
