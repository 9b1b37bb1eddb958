using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>A folder or network share with a path on this computer. An operation that hangs, as on a share, is abandoned after the time
/// limit.</summary>
internal sealed class FolderTransport(string machine, string folder, TimeSpan limit) : IMachineFolder
{
    private Task? _hanging;

    public string Machine => machine;

    /// <summary>Called at the start of each operation and each flush to disk, on the working thread. Tests observe the order, and simulate
    /// a share that hangs.</summary>
    internal Action<string>? Doing { get; init; }

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
                    Doing?.Invoke("syncing " + path);
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
                SharedFile.Replace(fromPath, toPath);
                SyncNames();
                return Read(toPath, mostBytes);
            },
            cancellation);
    }

    public Task<ReplacedProgram?> ReplaceAsync(string from, string to, string aside, long mostBytes, CancellationToken cancellation)
    {
        var (fromPath, toPath, asidePath) = (PathOf(from), PathOf(to), PathOf(aside));
        return DoAsync($"replacing {toPath}", () => OperatingSystem.IsLinux() ? Replace(fromPath, toPath, asidePath, mostBytes) : null,
            cancellation);
    }

    public Task DeleteAsync(string name, CancellationToken cancellation)
    {
        var path = PathOf(name);
        return DoAsync(
            "deleting " + path,
            () =>
            {
                SharedFile.Delete(path);
                return true;
            },
            cancellation);
    }

    // The new program gets the third name before the two are exchanged. So an interruption leaves one of the two programs under that name,
    // never half a transfer. Both names are of this attempt alone: a process that goes on here after another one took them finds nothing.
    private ReplacedProgram? Replace(string from, string to, string aside, long mostBytes)
    {
        if (from != aside && LinuxCalls.RenameToFree(from, aside) != true)
            return null;
        while (true)
        {
            Doing?.Invoke("exchanging " + to);
            switch (LinuxCalls.Exchange(aside, to))
            {
                case true:
                    return Exchanged(to, aside, mostBytes);
                case null:
                    GiveBack();
                    return null;
            }

            // The program's name is free.
            switch (LinuxCalls.RenameToFree(aside, to))
            {
                case true:
                    SyncNames();
                    return new(Read(to, mostBytes), null);
                case null:
                    GiveBack();
                    return null;
            }
        }

        void GiveBack()
        {
            if (from != aside)
                File.Move(aside, from);
        }
    }

    private ReplacedProgram Exchanged(string to, string aside, long mostBytes)
    {
        byte[] was;
        try
        {
            Doing?.Invoke("comparing " + to);
            was = Read(aside, mostBytes);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or TransportException)
        {
            // A program that cannot be read cannot be kept: it gets its name back.
            Doing?.Invoke("giving back " + to);
            LinuxCalls.Exchange(aside, to);
            throw;
        }

        var there = Read(to, mostBytes);
        SyncNames();
        return new(there, was);
    }

    // A rename that is only in memory is undone by a power failure. Windows flushes names on its own, through its journal.
    private void SyncNames()
    {
        if (OperatingSystem.IsLinux())
        {
            Doing?.Invoke("syncing " + folder);
            LinuxCalls.SyncFolder(folder);
        }
    }

    private string PathOf(string name) => ProgramNames.IsPlain(name)
        ? Path.Combine(folder, name)
        : throw TransportFailure.Of(TransportError.Denied, machine, $"reaching '{name}' in {folder}", "this is no plain file name");

    private byte[] Read(string path, long mostBytes)
    {
        using var file = PlainFile.Open(path, FileShare.ReadWrite | FileShare.Delete);
        var length = RandomAccess.GetLength(file);
        if (length > mostBytes)
            throw TransportFailure.Of(TransportError.TooLarge, machine, "reading " + path,
                $"it has {length} bytes, at most {mostBytes} are read");
        var bytes = new byte[length];
        var count = 0;
        for (int read; count < bytes.Length && (read = RandomAccess.Read(file, bytes.AsSpan(count), count)) > 0;)
            count += read;
        return bytes[..count];
    }

    private async Task<T> DoAsync<T>(string doing, Func<T> work, CancellationToken cancellation)
    {
        // A share that hangs blocks one thread, not one per attempt, and no later operation overtakes one that may still complete.
        if (_hanging is { IsCompleted: false })
            throw TransportFailure.Of(TransportError.Slow, machine, doing, "an earlier access still hangs in the share");
        var working = Task.Run(
            () =>
            {
                Doing?.Invoke(doing);

                // An unmounted share must not be mistaken for an empty one.
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

    // The low half of HResult is the Windows error; on other systems all of it is the Linux errno.
    private static TransportError ErrorOf(Exception failure) => failure switch
    {
        UnauthorizedAccessException => TransportError.Denied,
        NotPlainFileException => TransportError.NotAFile,
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

/// <summary>A folder or network share.</summary>
/// <param name="Folder">The folder. It must exist, so that an unmounted share is not mistaken for an empty one.</param>
internal sealed record FolderSettings(string Folder) : TransportSettings
{
    /// <inheritdoc/>
    public override string Address => Folder;

    /// <inheritdoc/>
    public override string? LocalFolder => Folder;

    /// <inheritdoc/>
    public override bool NeedsPassword => false;

    internal override bool IsSamePlace(TransportSettings other) =>
        other is FolderSettings { Folder: var there } && (CellPaths.IsInside(Folder, there) || CellPaths.IsInside(there, Folder));

    internal override IMachineFolder Open(string machine, Func<string?> secret, TimeSpan limit) =>
        new FolderTransport(machine, Folder, limit);
}
