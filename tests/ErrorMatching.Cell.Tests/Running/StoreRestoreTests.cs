namespace ErrorMatching.Cell.Tests;

public sealed class StoreRestoreTests
{
    private static readonly byte[] Key = new byte[32];

    [Fact]
    public async Task A_backup_takes_the_place_of_the_store_and_what_was_there_is_kept()
    {
        await using var cell = new RunningCell();
        cell.Start();
        cell.Drop("a_S1.csv", 1);
        await cell.Until(1, CorrectionState.Verified);
        cell.Store.Backup(cell.PathOf("backup.db"));
        cell.Drop("c_S2.csv", 2);
        await cell.Until(2, CorrectionState.Verified);
        Assert.Equal(StoreError.Locked, Assert.Throws<StoreException>(() => Restore(cell)).Error);
        await cell.StopAsync();
        cell.Store.Dispose();

        var kept = Restore(cell);
        Assert.True(File.Exists(kept));
        using var restored = cell.Open();
        Assert.Equal(CorrectionState.Verified, restored.Find(1)!.State);
        Assert.Null(restored.Find(2));
        Assert.Contains(restored.AuditEntries(0, 1000), e => e.What == "restored");
    }

    [Fact]
    public async Task A_damaged_backup_replaces_nothing()
    {
        await using var cell = new RunningCell();
        _ = cell.Store;
        File.WriteAllText(cell.PathOf("backup.db"), "this is no database, however long it goes on".PadRight(5000, '.'));
        var before = cell.Store.ChangeCount();
        Assert.Throws<StoreException>(() => Restore(cell));
        Assert.Equal(before, cell.Store.ChangeCount());
        Assert.DoesNotContain(Directory.EnumerateFiles(cell.Folder), f => f.Contains("restored", StringComparison.Ordinal) || f.Contains("before", StringComparison.Ordinal));
    }

    private static string? Restore(RunningCell cell) => StoreRestore.Run(cell.Settings, cell.PathOf("backup.db"), Key, TimeProvider.System);
}
