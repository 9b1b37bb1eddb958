namespace ErrorMatching.Cell;

/// <summary>A folder on an SFTP server. The login happens once; the connection stays open for the next operation until it breaks or the
/// folder is disposed of.</summary>
internal sealed class SftpTransport : IMachineFolder
{
    private readonly SftpSettings _sftp;
    private readonly TimeSpan _limit;
    private readonly SftpConnections _connections;

    public SftpTransport(string machine, SftpSettings sftp, Func<string?> secret, TimeSpan limit, SftpWaits? waits = null)
    {
        (Machine, _sftp, _limit) = (machine, sftp, limit);
        _connections = new(c => SftpConnection.OpenAsync(sftp, secret, limit, c), waits ?? SftpWaits.Usual);
    }

    public string Machine { get; }

    private string Folder => _sftp.Folder.Length == 0 ? "." : _sftp.Folder;

    public Task<IReadOnlyList<string>> ListAsync(CancellationToken cancellation)
    {
        var doing = $"listing {_sftp.Folder}";
        return DoAsync(doing, f => ListAsync(f, doing), cancellation);
    }

    public Task<byte[]?> ReadAsync(string name, long mostBytes, CancellationToken cancellation)
    {
        var doing = $"reading {name}";
        var path = PathOf(doing, name);
        return DoAsync(
            doing,
            async f =>
            {
                try
                {
                    return await FetchAsync(f, doing, path, mostBytes).ConfigureAwait(false);
                }
                catch (SftpStatusException e) when (e.Error != TransportError.Away)
                {
                    // Servers give different answers for a file that is not there.
                    if ((await ListAsync(f, doing).ConfigureAwait(false)).Contains(name, StringComparer.Ordinal))
                        throw Failure(e.Error, doing, e);
                    return null;
                }
            },
            cancellation);
    }

    public Task<byte[]> WriteAsync(string name, ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
    {
        var doing = $"writing {name}";
        var path = PathOf(doing, name);
        return DoAsync(
            doing,
            async f =>
            {
                try
                {
                    await f.WriteAsync(path, bytes).ConfigureAwait(false);
                }
                catch (SftpStatusException e) when (e.IsUnexplained)
                {
                    // A failure while writing is hardly ever anything else.
                    throw Failure(TransportError.Full, doing, e);
                }

                return await f.ReadAsync(path, bytes.Length, bytes.Length).ConfigureAwait(false);
            },
            cancellation);
    }

    public Task<byte[]> RenameAsync(string from, string to, long mostBytes, CancellationToken cancellation)
    {
        var doing = $"renaming {from} to {to}";
        var (fromPath, toPath) = (PathOf(doing, from), PathOf(doing, to));
        return DoAsync(
            doing,
            async f =>
            {
                try
                {
                    await f.RenameAsync(fromPath, toPath).ConfigureAwait(false);
                }
                catch (SftpStatusException e) when (e.Error != TransportError.Away)
                {
                    // The answer does not tell whether an existing file was the reason.
                    var names = await ListAsync(f, doing).ConfigureAwait(false);
                    throw Failure(
                        names.Contains(from, StringComparer.Ordinal) && names.Contains(to, StringComparer.Ordinal)
                            ? TransportError.CannotReplace
                            : TransportError.Denied,
                        doing,
                        e);
                }

                return await FetchAsync(f, doing, toPath, mostBytes).ConfigureAwait(false);
            },
            cancellation);
    }

    /// <summary>Gives the program a second name, then renames, in one session. What is written to the old program's file in between is
    /// found under the second name. A file that replaces it by a rename at that moment is lost, because SFTP cannot exchange two
    /// names.</summary>
    public Task<ReplacedProgram?> ReplaceAsync(string from, string to, string aside, long mostBytes, CancellationToken cancellation)
    {
        var doing = $"replacing {to}";
        var (fromPath, toPath, asidePath) = (PathOf(doing, from), PathOf(doing, to), PathOf(doing, aside));
        return DoAsync(
            doing,
            async f =>
            {
                // There is no program, the second name is taken, or the server does not support links: nothing is changed.
                if (!await f.LinkAsync(toPath, asidePath).ConfigureAwait(false))
                    return null;
                try
                {
                    await f.RenameAsync(fromPath, toPath).ConfigureAwait(false);
                }
                catch (SftpStatusException e) when (e.Error != TransportError.Away)
                {
                    // It does not rename over a file. The second name belongs to the program itself.
                    await f.RemoveAsync(asidePath).ConfigureAwait(false);
                    return null;
                }

                return new ReplacedProgram(
                    await FetchAsync(f, doing, toPath, mostBytes).ConfigureAwait(false),
                    await FetchAsync(f, doing, asidePath, mostBytes).ConfigureAwait(false));
            },
            cancellation);
    }

    public Task DeleteAsync(string name, CancellationToken cancellation)
    {
        var doing = $"deleting {name}";
        var path = PathOf(doing, name);
        return DoAsync(
            doing,
            async f =>
            {
                try
                {
                    await f.RemoveAsync(path).ConfigureAwait(false);
                }
                catch (SftpStatusException e) when (e.Error != TransportError.Away)
                {
                    if ((await ListAsync(f, doing).ConfigureAwait(false)).Contains(name, StringComparer.Ordinal))
                        throw Failure(TransportError.Denied, doing, e);
                }

                return true;
            },
            cancellation);
    }

    public void Dispose() => _connections.Dispose();

    private async Task<T> DoAsync<T>(string doing, Func<SftpFiles, Task<T>> work, CancellationToken cancellation)
    {
        cancellation.ThrowIfCancellationRequested();
        if (_sftp.Folder.Any(char.IsControl))
            throw TransportFailure.Of(TransportError.Denied, Machine, doing, "the folder has characters that no server's have");
        using var end = CancellationTokenSource.CreateLinkedTokenSource(cancellation);
        end.CancelAfter(_limit);
        try
        {
            var connection = await _connections.TakeAsync(end.Token).ConfigureAwait(false);

            // Sending blocks while the server takes nothing.
            var working = Task.Run(() => work(connection.Files), CancellationToken.None);
            try
            {
                return await working.WaitAsync(end.Token).ConfigureAwait(false);
            }
            finally
            {
                // Work that is abandoned must not send another word.
                if (working.IsCompleted)
                    _connections.Give(connection);
                else
                    SftpConnections.Drop(connection);
            }
        }
        catch (Exception e) when (end.IsCancellationRequested)
        {
            cancellation.ThrowIfCancellationRequested();
            throw TransportFailure.Of(
                TransportError.Slow, Machine, doing, FormattableString.Invariant($"it was not done within {_limit.TotalSeconds:0.#} s"), e);
        }
        catch (SftpConnectException e)
        {
            throw Failure(e.Error, doing, e);
        }
        catch (SftpStatusException e)
        {
            throw Failure(e.Error, doing, e);
        }
        catch (SftpLostException e)
        {
            throw Failure(TransportError.Away, doing, e);
        }
    }

    private async Task<IReadOnlyList<string>> ListAsync(SftpFiles files, string doing) =>
        await files.NamesAsync(Folder).ConfigureAwait(false)
            ?? throw TransportFailure.Of(TransportError.TooLarge, Machine, doing, "the folder has more names than are read");

    private async Task<byte[]> FetchAsync(SftpFiles files, string doing, string path, long mostBytes)
    {
        // A pipe would block the server's session until someone writes into it.
        var (size, isPlain) = await files.LookAsync(path).ConfigureAwait(false);
        if (!isPlain)
            throw TransportFailure.Of(TransportError.NotAFile, Machine, doing, "it is a link, a pipe, a device or a folder");
        if (size > mostBytes)
            throw TransportFailure.Of(
                TransportError.TooLarge, Machine, doing, FormattableString.Invariant($"it has {size} bytes, at most {mostBytes} are read"));
        var bytes = await files.ReadAsync(path, size, mostBytes).ConfigureAwait(false);
        return bytes.Length <= mostBytes ? bytes : throw TransportFailure.Of(
            TransportError.TooLarge, Machine, doing, FormattableString.Invariant($"it has more than the {mostBytes} bytes that are read"));
    }

    private string PathOf(string doing, string name) => ProgramNames.IsPlain(name)
        ? (Folder.EndsWith('/') ? Folder : Folder + "/") + name
        : throw TransportFailure.Of(TransportError.Denied, Machine, doing, "this is no plain file name");

    private TransportException Failure(TransportError error, string doing, Exception cause) =>
        TransportFailure.Of(error, Machine, doing, cause.Message, cause);
}
