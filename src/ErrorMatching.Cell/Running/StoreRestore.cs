using System.Globalization;

namespace ErrorMatching.Cell;

/// <summary>Puts a backup in the place of a store.</summary>
public static class StoreRestore
{
    /// <summary>Looks at every page of a backup, and only then puts a copy of it in the store's place.</summary>
    /// <param name="settings">The configuration, whose cell must not run.</param>
    /// <param name="backup">The backup, which stays as it is.</param>
    /// <param name="auditKey">Seals the audit trail.</param>
    /// <param name="clock">The clock.</param>
    /// <returns>What the store that was there is called now; null if there was none.</returns>
    /// <exception cref="StoreException">It cannot be done; the store is as it was.</exception>
    public static string? Run(CellSettings settings, string backup, byte[] auditKey, TimeProvider clock)
    {
        ArgumentNullException.ThrowIfNull(settings);
        ArgumentNullException.ThrowIfNull(clock);
        if (settings.Store is not SqliteSettings { File: var file })
        {
            throw new StoreException(StoreError.NotSupported, "A store on PostgreSQL is restored by its own tools: pg_restore.");
        }

        if (Heartbeat.Read(settings.LogFolder) is { } running && running.IsFresh(clock.GetUtcNow()))
        {
            throw new StoreException(StoreError.Locked, string.Create(CultureInfo.InvariantCulture, $"{settings.Name} runs (process {running.ProcessId}): stop it first."));
        }

        using var only = Lock(settings, auditKey, clock);
        try
        {
            return Replace(file, backup, settings, auditKey, clock);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new StoreException(StoreError.Disk, $"{backup} cannot be restored to {file}: {e.Message}", e);
        }
    }

    private static string? Replace(string file, string backup, CellSettings settings, byte[] auditKey, TimeProvider clock)
    {
        var copy = string.Create(CultureInfo.InvariantCulture, $"{file}.{Environment.ProcessId}.restored");
        Directory.CreateDirectory(Path.GetDirectoryName(Path.GetFullPath(file))!);
        File.Copy(backup, copy, overwrite: true);
        try
        {
            using (var store = CellStore.Open(new SqliteSettings(copy), clock, auditKey))
            {
                store.Audit(CellFlow.ByCell, "restored", $"from {Path.GetFileName(backup)} by whoever can write the store of {settings.Name}");
            }

            string? kept = null;
            if (File.Exists(file))
            {
                kept = string.Create(CultureInfo.InvariantCulture, $"{file}.before-{clock.GetUtcNow():yyyyMMddTHHmmss}");
                File.Move(file, kept);
                foreach (var suffix in new[] { "-wal", "-shm" }.Where(s => File.Exists(file + s)))
                {
                    File.Move(file + suffix, kept + suffix);
                }
            }

            File.Move(copy, file);
            return kept;
        }
        finally
        {
            foreach (var left in Directory.EnumerateFiles(Path.GetDirectoryName(Path.GetFullPath(file))!, Path.GetFileName(copy) + "*"))
            {
                File.Delete(left);
            }
        }
    }

    // The same right that a running cell has. A store that cannot even be opened has no cell that runs on it.
    private static ISlotLock? Lock(CellSettings settings, byte[] auditKey, TimeProvider clock)
    {
        if (settings.Store is not SqliteSettings { File: var file } || !File.Exists(file))
        {
            return null;
        }

        CellStore store;
        try
        {
            store = CellStore.Open(settings.Store, clock, auditKey, inspect: false);
        }
        catch (StoreException e) when (e.Error is StoreError.Damaged or StoreError.Foreign or StoreError.TooNew)
        {
            return null;
        }

        using (store)
        {
            return store.TryLockCell(settings.Name) ?? throw new StoreException(StoreError.Locked, $"{settings.Name} runs: stop it first.");
        }
    }
}
