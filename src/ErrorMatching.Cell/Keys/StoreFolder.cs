namespace ErrorMatching.Cell;

/// <summary>The folder of a store in a file.</summary>
public static class StoreFolder
{
    /// <summary>Makes the folder for a store that is to be made. Only a person does that, by adding its first user: a cell that runs must
    /// not take the empty mount point of a disk for the place of a new store.</summary>
    /// <param name="settings">The configuration.</param>
    /// <exception cref="StoreException">With <see cref="StoreError.Missing"/> if a cell ran here before; with
    /// <see cref="StoreError.ReadOnly"/> if the folder cannot be made.</exception>
    public static void Make(CellSettings settings)
    {
        ArgumentNullException.ThrowIfNull(settings);
        if (settings.Store is not SqliteSettings { File: var file }
            || Path.GetDirectoryName(Path.GetFullPath(file)) is not { } folder || Directory.Exists(folder))
        {
            return;
        }

        if (AuditWitness.Find(settings.KeysFolder) is { Seq: > 0 })
        {
            throw new StoreException(
                StoreError.Missing,
                $"The store's folder {folder} is not there, and {settings.KeysFolder} says that there was a store. Mount the disk that has "
                    + "it, or restore the latest backup. Only if the cell is to begin again: make the folder.");
        }

        try
        {
            if (OperatingSystem.IsWindows())
            {
                Directory.CreateDirectory(folder);
            }
            else
            {
                // Whatever the umask: a folder that everybody may write is refused.
                Directory.CreateDirectory(
                    folder,
                    UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute | UnixFileMode.GroupRead
                        | UnixFileMode.GroupExecute | UnixFileMode.OtherRead | UnixFileMode.OtherExecute);
            }
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new StoreException(
                StoreError.ReadOnly,
                $"The store's folder {folder} cannot be made: {e.Message.TrimEnd('.')}. Make it, and give it to the user that the cell "
                    + "runs as.",
                e);
        }
    }
}
