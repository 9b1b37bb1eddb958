namespace ErrorMatching.Cell;

/// <summary>A lock that the operating system keeps on a file and takes back when the process ends.</summary>
internal sealed class FileLock : ISlotLock
{
    private readonly FileStream _file;
    private bool _disposed;

    private FileLock(FileStream file) => _file = file;

    // The lock is on the file that was opened: once somebody removed that, the next one locks another file of its name, which is younger.
    /// <inheritdoc/>
    public bool IsHeld => !_disposed && File.GetLastWriteTimeUtc(_file.SafeFileHandle) == File.GetLastWriteTimeUtc(_file.Name);

    /// <summary>Name of the lock's file beside the store's.</summary>
    public static string NameBeside(string store, string name) => $"{store}.{name}.lock";

    /// <summary>The files of all locks that were ever taken beside a store; they stay when the lock ends.</summary>
    public static IEnumerable<string> Beside(string store)
    {
        var full = Path.GetFullPath(store);
        return Directory.EnumerateFiles(Path.GetDirectoryName(full)!, NameBeside(Path.GetFileName(full), "*"));
    }

    /// <summary>Takes the lock; null if another one has it.</summary>
    public static FileLock? TryTake(string file)
    {
        try
        {
            return new FileLock(new FileStream(file, FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.None));
        }
        catch (UnauthorizedAccessException failure)
        {
            throw new StoreException(StoreError.ReadOnly, $"The lock {file} cannot be made: {failure.Message}", failure);
        }
        catch (IOException) when (File.Exists(file))
        {
            return null;
        }
        catch (IOException failure)
        {
            throw new StoreException(StoreError.ReadOnly, $"The lock {file} cannot be made: {failure.Message}", failure);
        }
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        _disposed = true;
        _file.Dispose();
    }
}
