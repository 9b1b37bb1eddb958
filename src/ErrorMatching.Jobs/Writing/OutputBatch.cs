using ErrorMatching.Json;

namespace ErrorMatching.Jobs;

/// <summary>Writes several files as one: first under temporary names next to their targets, then renamed one by one. Unless
/// <see cref="Keep"/> is called, <see cref="Dispose"/> undoes the renaming.</summary>
internal sealed class OutputBatch : IDisposable
{
    private readonly List<Item> _items = [];
    private int _revealed;

    /// <summary>Writes a file next to its target and flushes it to disk. Missing folders are created.</summary>
    /// <exception cref="IOException">It cannot be written.</exception>
    /// <exception cref="UnauthorizedAccessException">Access is denied.</exception>
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

    /// <summary>Renames the next file to its target. An existing file is copied next to it until the batch ends. The last file
    /// needs no copy, because nothing after it can fail.</summary>
    /// <exception cref="IOException">It cannot be renamed.</exception>
    /// <exception cref="UnauthorizedAccessException">Access is denied.</exception>
    public void RevealNext()
    {
        var item = _items[_revealed];
        if (_revealed + 1 < _items.Count && File.Exists(item.Target))
        {
            File.Copy(item.Target, item.Old);
        }

        SharedFile.Replace(item.New, item.Target);
        _revealed++;
    }

    /// <summary>Makes the renaming permanent.</summary>
    public void Keep() => _revealed = 0;

    /// <summary>Undoes the renaming unless it was kept, and deletes temporary files next to the targets.</summary>
    public void Dispose()
    {
        foreach (var item in _items.Take(_revealed))
        {
            Attempt(() =>
            {
                if (File.Exists(item.Old))
                {
                    SharedFile.Replace(item.Old, item.Target);
                }
                else
                {
                    SharedFile.Delete(item.Target);
                }
            });
        }

        foreach (var item in _items)
        {
            Attempt(() => SharedFile.Delete(item.New));
            Attempt(() => SharedFile.Delete(item.Old));
        }
    }

    private static string Beside(string folder, string target) =>
        Path.Combine(folder, $".{Path.GetFileName(target)}.{Path.GetRandomFileName()}.tmp");

    private static void Attempt(Action work)
    {
        try
        {
            work();
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // The original failure is the one to report. A leftover temporary file is harmless and recognizable by its name.
        }
    }

    private sealed record Item(string Target, string New, string Old);
}
