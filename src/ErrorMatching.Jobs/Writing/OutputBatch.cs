namespace ErrorMatching.Jobs;

/// <summary>
/// Files on their way to their places: written beside them first, then renamed one by one. Unless the batch is kept to the end, what was renamed is undone.
/// </summary>
internal sealed class OutputBatch : IDisposable
{
    private readonly List<Item> _items = [];
    private int _revealed;

    /// <summary>Writes a file beside its place and flushes it to the disk. Missing folders are made.</summary>
    /// <exception cref="IOException">It cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">It must not be written.</exception>
    public void Stage(string path, Action<Stream> write)
    {
        var target = Path.GetFullPath(path);
        var folder = Directory.CreateDirectory(Path.GetDirectoryName(target) ?? target).FullName;
        var item = new Item(target, Beside(folder, target), Beside(folder, target));
        _items.Add(item);
        using var stream = new FileStream(item.New, FileMode.CreateNew, FileAccess.Write, FileShare.None, bufferSize: 0);
        write(stream);
        stream.Flush(flushToDisk: true);
    }

    /// <summary>Renames the next file to its place. What was there is copied beside it until the batch ends, unless it is the last file: then nothing is left that could fail.</summary>
    /// <exception cref="IOException">It cannot be renamed.</exception>
    /// <exception cref="UnauthorizedAccessException">It must not be renamed.</exception>
    public void RevealNext()
    {
        var item = _items[_revealed];
        if (_revealed + 1 < _items.Count && File.Exists(item.Target))
        {
            File.Copy(item.Target, item.Old);
        }

        File.Move(item.New, item.Target, overwrite: true);
        _revealed++;
    }

    /// <summary>Leaves the files where they are.</summary>
    public void Keep() => _revealed = 0;

    /// <summary>Undoes what was not kept and removes what stands beside the places.</summary>
    public void Dispose()
    {
        foreach (var item in _items.Take(_revealed))
        {
            Attempt(() =>
            {
                if (File.Exists(item.Old))
                {
                    File.Move(item.Old, item.Target, overwrite: true);
                }
                else
                {
                    File.Delete(item.Target);
                }
            });
        }

        foreach (var item in _items)
        {
            Attempt(() => File.Delete(item.New));
            Attempt(() => File.Delete(item.Old));
        }
    }

    private static string Beside(string folder, string target) => Path.Combine(folder, $".{Path.GetFileName(target)}.{Path.GetRandomFileName()}.tmp");

    private static void Attempt(Action work)
    {
        try
        {
            work();
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // The failure that led here is the one to report; a stray temporary file is harmless and its name says what it is.
        }
    }

    private sealed record Item(string Target, string New, string Old);
}
