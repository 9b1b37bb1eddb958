using System.Globalization;
using ErrorMatching.Json;

namespace ErrorMatching.Cell;

/// <summary>Restores a backup in place of a file store.</summary>
internal static class SqliteRestore
{
    private const int AtOnce = 1 << 20;

    /// <summary>Verifies a copy of the backup, keeps the current store, and renames the copy over it: at any instant either the old store
    /// or the restored one exists.</summary>
    /// <param name="file">The store's file.</param>
    /// <param name="backup">The backup's.</param>
    /// <param name="migrate">Migrates it to the current schema.</param>
    /// <param name="progress">Receives progress; null for no reports.</param>
    /// <param name="cancellation">Cancels the restore until the copy is renamed.</param>
    /// <returns>The file with the replaced store; null if there was none.</returns>
    public static string? Restore(
        string file, string backup, Action<CellDatabase> migrate, IProgress<CellProgress>? progress, CancellationToken cancellation)
    {
        if (!File.Exists(backup)) throw new StoreException(StoreError.Missing, $"The backup {backup} is not there.");
        var locks = new List<FileLock>();
        var copy = $"{file}.{Guid.NewGuid():N}.restore";
        try
        {
            foreach (var each in FileLock.Beside(file))
            {
                locks.Add(
                    FileLock.TryTake(each)
                        ?? throw new StoreException(
                            StoreError.Locked, $"A cell runs with the store {file}. Stop it before a backup is brought into its place."));
            }

            Copy(backup, copy, progress, cancellation);
            progress?.Report(new("looking at each page of the copy", 0, 0));
            using (SqliteDatabase.Open(copy, Prove))
            {
            }

            using (var written = new FileStream(copy, FileMode.Open, FileAccess.ReadWrite)) written.Flush(flushToDisk: true);
            cancellation.ThrowIfCancellationRequested();
            var aside = KeepAside(file);
            SharedFile.Replace(copy, file);
            return aside;
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
        {
            throw new StoreException(
                StoreError.Disk, $"The backup {backup} cannot be brought into the place of {file}: {failure.Message}", failure);
        }
        finally
        {
            File.Delete(copy);
            foreach (var each in locks) each.Dispose();
        }

        void Prove(CellDatabase opened)
        {
            opened.Inspect();
            migrate(opened);
        }
    }

    private static void Copy(string from, string to, IProgress<CellProgress>? progress, CancellationToken cancellation)
    {
        using var source = new FileStream(from, FileMode.Open, FileAccess.Read);
        SqliteDatabase.MakeForOwner(to);
        using var target = new FileStream(to, FileMode.Open, FileAccess.Write);
        var buffer = new byte[AtOnce];
        int read;
        while ((read = source.Read(buffer)) > 0)
        {
            cancellation.ThrowIfCancellationRequested();
            target.Write(buffer, 0, read);
            progress?.Report(new("copying the backup", target.Position, source.Length));
        }
    }

    // The old store's log must not be read into the restored one; it stays with the old store.
    private static string? KeepAside(string file)
    {
        if (!File.Exists(file) && !File.Exists(file + "-wal")) return null;
        var aside = Enumerable.Range(1, int.MaxValue)
            .Select(n => string.Create(CultureInfo.InvariantCulture, $"{file}.before-restore-{n}"))
            .First(n => !File.Exists(n) && !File.Exists(n + "-wal"));
        if (File.Exists(file)) File.Copy(file, aside);
        if (File.Exists(file + "-wal")) File.Move(file + "-wal", aside + "-wal");
        File.Delete(file + "-shm");
        return aside;
    }
}
