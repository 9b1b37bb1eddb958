namespace ErrorMatching.Cell;

/// <summary>A folder or network share that this computer reaches by a path. What hangs, as a share may, is given up after the time limit.</summary>
internal sealed class FolderTransport(string machine, string folder, TimeSpan limit) : IMachineFolder
{
    private Task? _hanging;

    public string Machine => machine;

    public Task<IReadOnlyList<string>> ListAsync(CancellationToken cancellation) => DoAsync<IReadOnlyList<string>>(
        "listing " + folder,
        () => [.. Directory.EnumerateFiles(folder).Select(f => Path.GetFileName(f))],
        cancellation);

    public Task<byte[]?> ReadAsync(string name, long mostBytes, CancellationToken cancellation)
    {
        var path = PathOf(name);
        return DoAsync(
            "reading " + path,
            () =>
            {
                try
                {
                    return Read(path, mostBytes);
                }
                catch (FileNotFoundException)
                {
                    return null;
                }
            },
            cancellation);
    }

    public Task<byte[]> WriteAsync(string name, ReadOnlyMemory<byte> bytes, CancellationToken cancellation)
    {
        var path = PathOf(name);
        return DoAsync(
            "writing " + path,
            () =>
            {
                using (var file = new FileStream(path, FileMode.Create, FileAccess.Write, FileShare.None))
                {
                    file.Write(bytes.Span);
                    file.Flush(flushToDisk: true);
                }

                return Read(path, bytes.Length + 1L);
            },
            cancellation);
    }

    public Task<byte[]> RenameAsync(string from, string to, long mostBytes, CancellationToken cancellation)
    {
        var (fromPath, toPath) = (PathOf(from), PathOf(to));
        return DoAsync(
            $"renaming {fromPath} to {to}",
            () =>
            {
                File.Move(fromPath, toPath, overwrite: true);
                return Read(toPath, mostBytes);
            },
            cancellation);
    }

    public Task DeleteAsync(string name, CancellationToken cancellation)
    {
        var path = PathOf(name);
        return DoAsync(
            "deleting " + path,
            () =>
            {
                File.Delete(path);
                return true;
            },
            cancellation);
    }

    private string PathOf(string name) => ProgramNames.IsPlain(name)
        ? Path.Combine(folder, name)
        : throw TransportFailure.Of(TransportError.Denied, machine, $"reaching '{name}' in {folder}", "this is no plain file name");

    private byte[] Read(string path, long mostBytes)
    {
        using var file = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete);
        if (file.Length > mostBytes)
            throw TransportFailure.Of(TransportError.TooLarge, machine, "reading " + path, $"it has {file.Length} bytes, at most {mostBytes} are read");
        var bytes = new byte[file.Length];
        var read = file.ReadAtLeast(bytes, bytes.Length, throwOnEndOfStream: false);
        return bytes[..read];
    }

    private async Task<T> DoAsync<T>(string doing, Func<T> work, CancellationToken cancellation)
    {
        // A share that hangs holds a thread: one, not one for each try, and nothing overtakes what may still happen there.
        if (_hanging is { IsCompleted: false })
            throw TransportFailure.Of(TransportError.Slow, machine, doing, "an earlier access still hangs in the share");
        var working = Task.Run(
            () =>
            {
                // A share that is not mounted must not be mistaken for an empty one.
                if (!Directory.Exists(folder))
                    throw TransportFailure.Of(TransportError.Away, machine, doing, $"the folder {folder} is not there");
                return work();
            },
            cancellation);
        try
        {
            return await working.WaitAsync(limit, cancellation).ConfigureAwait(false);
        }
        catch (TimeoutException e)
        {
            _hanging = working;
            throw TransportFailure.Of(TransportError.Slow, machine, doing, $"nothing came within {limit.TotalSeconds:0.#} s", e);
        }
        catch (OperationCanceledException) when (!working.IsCompleted)
        {
            _hanging = working;
            throw;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException)
        {
            throw TransportFailure.Of(ErrorOf(e), machine, doing, e.Message, e);
        }
    }

    // The low half of HResult is Windows' error; on other systems the whole is the errno of Linux.
    private static TransportError ErrorOf(Exception failure) => failure switch
    {
        UnauthorizedAccessException => TransportError.Denied,
        FileNotFoundException => TransportError.Unknown,
        DirectoryNotFoundException or DriveNotFoundException => TransportError.Away,
        PathTooLongException => TransportError.Denied,
        _ when OperatingSystem.IsWindows() => (failure.HResult & 0xFFFF) switch
        {
            39 or 112 or 1295 => TransportError.Full,
            5 or 19 => TransportError.Denied,
            51 or 53 or 55 or 59 or 64 or 67 or 1231 or 1232 => TransportError.Away,
            _ => TransportError.Unknown,
        },
        _ => failure.HResult switch
        {
            28 or 122 => TransportError.Full,
            1 or 13 or 30 => TransportError.Denied,
            5 or 6 or 19 or 107 or 110 or 112 or 113 or 116 => TransportError.Away,
            _ => TransportError.Unknown,
        },
    };
}
