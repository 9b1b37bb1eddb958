namespace ErrorMatching.Cell;

/// <summary>A file lock of the operating system, which releases it when the process ends.</summary>
internal sealed class FileLock : ISlotLock
{
    private readonly FileStream _file;
    private bool _disposed;

    private FileLock(FileStream file) => _file = file;

    // The lock is on the file that was opened. Once that file is deleted, the next process locks a new file of the same name.
    public bool IsHeld => !_disposed && File.GetLastWriteTimeUtc(_file.SafeFileHandle) == File.GetLastWriteTimeUtc(_file.Name);

    /// <summary>Name of a lock file next to the store.</summary>
    public static string NameBeside(string store, string name) => $"{store}.{name}.lock";

    /// <summary>All lock files ever created next to a store; they remain after their locks end.</summary>
    public static IEnumerable<string> Beside(string store)
    {
        var full = Path.GetFullPath(store);
        return Directory.EnumerateFiles(Path.GetDirectoryName(full)!, NameBeside(Path.GetFileName(full), "*"));
    }

    /// <summary>Takes the lock; null if it is already held.</summary>
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

    public void Dispose()
    {
        _disposed = true;
        _file.Dispose();
    }
}
