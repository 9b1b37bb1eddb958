using System.Globalization;
using System.Text;
using Microsoft.Data.Sqlite;

namespace ErrorMatching.Cell.Tests;

/// <summary>A store in a file that was damaged: it is named before anything is done with it, and a backup brings it back.</summary>
public sealed class SqliteDamageTests : IDisposable
{
    private const int Corrections = 60;
    private readonly string _folder = Directory.CreateTempSubdirectory("errormatch-store-").FullName;

    private string File => Path.Combine(_folder, "cell.db");

    private SqliteSettings Settings => new(File);

    [Fact]
    public void A_page_that_is_torn_at_the_end_is_found_at_the_start()
    {
        Fill();
        using (var file = new FileStream(File, FileMode.Open)) file.SetLength(file.Length - 1000);
        IsDamaged();
    }

    [Theory]
    [InlineData(0.3), InlineData(0.6), InlineData(0.9)]
    public void A_file_that_is_cut_is_found_at_the_start(double part)
    {
        Fill();
        using (var file = new FileStream(File, FileMode.Open)) file.SetLength((long)(file.Length * part));
        IsDamaged();
    }

    [Fact]
    public void A_file_that_became_empty_is_not_taken_for_a_new_store()
    {
        Fill();
        using (var file = new FileStream(File, FileMode.Open)) file.SetLength(0);
        IsDamaged();
    }

    [Fact]
    public void Every_table_and_index_that_has_garbage_in_it_is_found_at_the_start()
    {
        Fill();
        var whole = System.IO.File.ReadAllBytes(File);
        long[] roots;
        using (var connection = new SqliteConnection($"Data Source={File};Pooling=False"))
        {
            connection.Open();
            roots = [.. Rows.Query(connection, "SELECT rootpage FROM sqlite_master WHERE rootpage > 0", r => r.GetInt64(0))];
        }

        Assert.True(roots.Length > 10);
        foreach (var root in roots.Append(1))
        {
            System.IO.File.WriteAllBytes(File, whole);
            using (var file = new FileStream(File, FileMode.Open))
            {
                file.Position = (root - 1) * 4096 + (root == 1 ? 100 : 0);
                var garbage = new byte[64];
                new Random(5).NextBytes(garbage);
                file.Write(garbage);
            }

            IsDamaged();
        }
    }

    [Fact]
    public void A_file_that_is_something_else_is_named()
    {
        System.IO.File.WriteAllText(File, string.Concat(Enumerable.Repeat("not a database ", 1000)));
        IsDamaged();
        System.IO.File.Delete(File);
        using (var connection = new SqliteConnection($"Data Source={File};Pooling=False"))
        {
            connection.Open();
            connection.Execute("CREATE TABLE music (title TEXT)");
        }

        Assert.Equal(StoreError.Foreign, Assert.Throws<StoreException>(() => CellStore.Open(Settings, TimeProvider.System)).Error);
    }

    [Fact]
    public void A_store_that_is_gone_is_not_begun_anew()
    {
        using (var store = CellStore.Open(Settings, TimeProvider.System)) store.TryLockCell("line 1")!.Dispose();
        System.IO.File.Delete(File);
        Assert.Equal(StoreError.Missing, Assert.Throws<StoreException>(() => CellStore.Open(Settings, TimeProvider.System)).Error);
        Assert.False(System.IO.File.Exists(File));
    }

    [Fact]
    public void A_store_that_is_taken_away_while_it_is_open_is_away_until_it_is_back_or_another_that_has_all_of_it()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "An open file cannot be taken away there.");
        using var store = CellStore.Open(Settings, TimeProvider.System);
        var kept = Archive(store, 0);
        Move("", ".aside");
        Assert.Equal(StoreError.Away, Assert.Throws<StoreException>(() => store.ChangeCount()).Error);
        Assert.Equal(StoreError.Away, Assert.Throws<StoreException>(() => Archive(store, 2)).Error);
        Move(".aside", "");
        Assert.Equal([kept], store.Corrections.InState(CorrectionState.Archived));

        var backup = Path.Combine(_folder, "backup.db");
        store.Backup(backup);
        Move("", ".aside");
        System.IO.File.Move(backup, File);
        Assert.Equal([kept], store.Corrections.InState(CorrectionState.Archived));
        Archive(store, 3);
        Assert.Null(store.VerifyAudit());
    }

    [Theory]
    [InlineData("older", "lacks entries 3 to 3")]
    [InlineData("other", "entry 3 of its audit trail is another one")]
    [InlineData("foreign", "cannot be read")]
    public void Another_file_in_the_place_of_an_open_store_is_refused_and_left_as_it_is(string what, string why)
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "An open file cannot be replaced there.");
        var other = Path.Combine(_folder, "other.db");
        using var store = CellStore.Open(Settings, TimeProvider.System);
        Archive(store, 0);
        if (what == "older")
        {
            store.Backup(other);
        }
        else if (what == "foreign")
        {
            System.IO.File.WriteAllText(other, "no database, and longer than the head of one: " + new string('x', 200));
        }
        else
        {
            using var made = CellStore.Open(new SqliteSettings(other), TimeProvider.System);
            Archive(made, 7);
            Archive(made, 8);
        }

        Archive(store, 1);
        var bytes = System.IO.File.ReadAllBytes(other);
        Move("", ".aside");
        System.IO.File.Move(other, File);
        var refused = Assert.Throws<StoreException>(() => Archive(store, 2));
        Assert.Equal(StoreError.Replaced, refused.Error);
        Assert.Contains(why, refused.Message, StringComparison.Ordinal);
        Assert.Equal(StoreError.Replaced, Assert.Throws<StoreException>(() => store.ChangeCount()).Error);
        Assert.Equal(bytes, System.IO.File.ReadAllBytes(File));
    }

    [Fact]
    public void A_file_renamed_over_an_open_store_is_refused()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "An open file cannot be replaced there.");
        var older = Path.Combine(_folder, "older.db");
        using var store = CellStore.Open(Settings, TimeProvider.System);
        store.Backup(older);
        Archive(store, 1);
        System.IO.File.Move(older, File, overwrite: true);
        Assert.Equal(StoreError.Replaced, Assert.Throws<StoreException>(() => Archive(store, 2)).Error);
    }

    [Fact]
    public void What_was_kept_in_a_file_that_lost_its_name_meanwhile_is_not_reported_as_kept()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "An open file cannot be taken away there.");
        using var store = CellStore.Open(Settings, TimeProvider.System);
        Assert.Equal(StoreError.Away, Assert.Throws<StoreException>(() => store.Database.Write(TimeProvider.System, null, t =>
        {
            t.Audit("anna", "signed-in", null, "password");
            Move("", ".aside");
            return true;
        })).Error);
    }

    [Fact]
    public void A_log_whose_store_is_gone_is_not_read_into_a_new_one()
    {
        System.IO.File.WriteAllText(File + "-wal", "what is left");
        Assert.Equal(StoreError.Damaged, Assert.Throws<StoreException>(() => CellStore.Open(Settings, TimeProvider.System)).Error);
        Assert.False(System.IO.File.Exists(File));
    }

    [Fact]
    public void A_folder_that_is_not_there_is_named() =>
        Assert.Equal(
            StoreError.Missing,
            Assert.Throws<StoreException>(() => CellStore.Open(
                new SqliteSettings(Path.Combine(_folder, "none", "cell.db")), TimeProvider.System)).Error);

    [Fact]
    public void A_byte_that_flipped_in_a_content_is_named_with_its_hash()
    {
        var kept = Fill();
        var bytes = System.IO.File.ReadAllBytes(File);
        bytes[bytes.AsSpan().IndexOf(PackedContent.Of(Measurement(7)).Bytes) + 20] ^= 1;
        System.IO.File.WriteAllBytes(File, bytes);
        using var store = CellStore.Open(Settings, TimeProvider.System);
        var damaged = Assert.Throws<StoreException>(() => store.Content(kept[7].MeasurementSha256));
        Assert.Equal(StoreError.Damaged, damaged.Error);
        Assert.Contains(kept[7].MeasurementSha256, damaged.Message, StringComparison.Ordinal);
        Assert.StartsWith("measurement 8;", Encoding.UTF8.GetString(store.Content(kept[8].MeasurementSha256)), StringComparison.Ordinal);
    }

    [Fact]
    public void A_log_that_is_torn_in_the_middle_of_a_write_keeps_what_was_kept()
    {
        using var store = CellStore.Open(Settings, TimeProvider.System);
        var kept = Enumerable.Range(0, 20).Select(i => Archive(store, i)).ToArray();
        var log = System.IO.File.ReadAllBytes(File + "-wal");
        Assert.True(log.Length > 100_000);

        // A frame is 24 bytes and a page.
        var garbage = new byte[3000];
        new Random(7).NextBytes(garbage);
        Survives([.. log, .. garbage], kept.Length, kept.Length);
        Survives([.. log, .. log.AsSpan(32, 24 + 4096)], kept.Length, kept.Length);
        Survives(log[..^1], kept.Length - 1, kept.Length - 1);
        Survives(log[..^5000], kept.Length - 1, kept.Length - 1);
        Survives(log[..(log.Length / 2)], 5, kept.Length - 5);

        void Survives(byte[] torn, int fewest, int most)
        {
            var copy = Path.Combine(_folder, $"{Guid.NewGuid():N}.db");
            System.IO.File.Copy(File, copy);
            System.IO.File.WriteAllBytes(copy + "-wal", torn);
            using var opened = CellStore.Open(new SqliteSettings(copy), TimeProvider.System);
            var found = opened.Corrections.InState(CorrectionState.Archived);
            Assert.InRange(found.Count, fewest, most);
            Assert.Equal(kept.Take(found.Count), found);
            Assert.All(found, c => opened.Content(c.MeasurementSha256));
            Assert.Null(opened.VerifyAudit());
            Archive(opened, 1000);
            Assert.Null(opened.VerifyAudit());
        }
    }

    [Fact]
    public void A_database_that_has_no_more_pages_is_full_and_loses_nothing()
    {
        using var store = CellStore.Open(Settings, TimeProvider.System);
        var kept = Archive(store, 0);
        store.Database.Change((c, t) => c.Execute("PRAGMA max_page_count = 60", transaction: t));
        var failure = Assert.Throws<StoreException>(() =>
        {
            for (var i = 1; i < 1000; i++) Archive(store, i);
        });
        Assert.Equal(StoreError.Full, failure.Error);
        Assert.Equal(kept, store.Find(kept.Id));
        Assert.Null(store.VerifyAudit());

        // The connection that met the fault was given up, and its limit with it.
        Assert.Equal("measurement 5000;", Encoding.UTF8.GetString(store.Content(Archive(store, 5000).MeasurementSha256))[..17]);
    }

    [Fact]
    public void A_database_that_takes_no_changes_is_read_only()
    {
        using var store = CellStore.Open(Settings, TimeProvider.System);
        store.Database.Change((c, t) => c.Execute("PRAGMA query_only = ON", transaction: t));
        Assert.Equal(StoreError.ReadOnly, Assert.Throws<StoreException>(() => Archive(store, 1)).Error);
        Archive(store, 1);
    }

    [Fact]
    public void A_backup_made_while_others_write_brings_a_damaged_store_back()
    {
        var backup = Path.Combine(_folder, "backup.db");
        IReadOnlyList<Correction> before;
        using (var store = CellStore.Open(Settings, TimeProvider.System))
        {
            for (var i = 0; i < 30; i++) Archive(store, i);
            before = store.Corrections.InState(CorrectionState.Archived);
            using var stop = new CancellationTokenSource();
            var writer = new Thread(() =>
            {
                for (var i = 30; !stop.IsCancellationRequested; i++) Archive(store, i);
            });
            writer.Start();
            store.Backup(backup);
            store.Backup(backup);
            stop.Cancel();
            writer.Join();
        }

        Assert.Equal(["backup.db", "cell.db"], Directory.EnumerateFiles(_folder).Select(Path.GetFileName).Order());
        var bytes = System.IO.File.ReadAllBytes(backup);
        using (var file = new FileStream(File, FileMode.Open)) file.SetLength(10_000);
        IsDamaged();
        var aside = CellStore.Restore(Settings, backup, TimeProvider.System, "anna");
        Assert.Equal(10_000, new FileInfo(aside!).Length);
        Assert.Equal(bytes, System.IO.File.ReadAllBytes(backup));
        using var restored = CellStore.Open(Settings, TimeProvider.System);
        var found = restored.Corrections.InState(CorrectionState.Archived);
        Assert.Equal(before, found.Take(before.Count));
        Assert.All(found, c => restored.Content(c.MeasurementSha256));
        Assert.Null(restored.VerifyAudit());
        Assert.Equal(
            ("anna", "restored"),
            (restored.AuditEntries(restored.ChangeCount() - 1, 1)[0].Who, restored.AuditEntries(restored.ChangeCount() - 1, 1)[0].What));
    }

    [Fact]
    public void A_backup_that_is_copied_into_place_by_hand_is_a_store()
    {
        var kept = Fill();
        var backup = Path.Combine(_folder, "backup.db");
        using (var store = CellStore.Open(Settings, TimeProvider.System)) store.Backup(backup);
        foreach (var file in Directory.EnumerateFiles(_folder, "cell.db*")) System.IO.File.Delete(file);
        System.IO.File.Copy(backup, File);
        using var restored = CellStore.Open(Settings, TimeProvider.System);
        Assert.Equal(kept, restored.Corrections.InState(CorrectionState.Archived));
    }

    [Fact]
    public void A_restore_leaves_no_log_that_is_read_into_the_restored_store()
    {
        var backup = Path.Combine(_folder, "backup.db");
        using (var store = CellStore.Open(Settings, TimeProvider.System))
        {
            Archive(store, 0);
            store.Backup(backup);
            for (var i = 1; i < 20; i++) Archive(store, i);

            // As a power cut leaves it: with a log beside it.
            foreach (var end in new[] { "", "-wal" }) System.IO.File.Copy(File + end, Path.Combine(_folder, "cut.db" + end));
        }

        var cut = new SqliteSettings(Path.Combine(_folder, "cut.db"));
        var aside = CellStore.Restore(cut, backup, TimeProvider.System, "anna");
        using (var restored = CellStore.Open(cut, TimeProvider.System))
            Assert.Single(restored.Corrections.InState(CorrectionState.Archived));
        using var kept = CellStore.Open(new SqliteSettings(aside!), TimeProvider.System);
        Assert.Equal(20, kept.Corrections.InState(CorrectionState.Archived).Count);
    }

    [Fact]
    public void Nothing_is_restored_while_a_cell_runs_or_from_what_is_no_backup()
    {
        Fill();
        var backup = Path.Combine(_folder, "backup.db");
        using var store = CellStore.Open(Settings, TimeProvider.System);
        store.Backup(backup);
        using (store.TryLockCell("line 1")) Assert.Equal(
            StoreError.Locked, Assert.Throws<StoreException>(() => CellStore.Restore(Settings, backup, TimeProvider.System, "anna")).Error);
        using (var file = new FileStream(backup, FileMode.Open)) file.SetLength(20_000);
        Assert.Equal(
            StoreError.Damaged,
            Assert.Throws<StoreException>(() => CellStore.Restore(Settings, backup, TimeProvider.System, "anna")).Error);
        Assert.Equal(
            StoreError.Missing,
            Assert.Throws<StoreException>(() => CellStore.Restore(Settings, backup + ".none", TimeProvider.System, "anna")).Error);
        Assert.Equal(StoreError.Denied, Assert.Throws<StoreException>(() => store.Backup(File)).Error);
        Assert.Equal(Corrections, store.Corrections.InState(CorrectionState.Archived).Count);
        Assert.DoesNotContain(Directory.EnumerateFiles(_folder), f => f.Contains("restore", StringComparison.Ordinal));
    }

    [Fact]
    public void A_backup_that_cannot_be_written_is_named_and_leaves_nothing()
    {
        Fill();
        using var store = CellStore.Open(Settings, TimeProvider.System);
        var nowhere = Path.Combine(_folder, "none", "backup.db");
        Assert.Contains(
            $"The backup {nowhere} was not written",
            Assert.Throws<StoreException>(() => store.Backup(nowhere)).Message,
            StringComparison.Ordinal);
        Directory.CreateDirectory(Path.Combine(_folder, "folder"));
        Assert.Equal(StoreError.Disk, Assert.Throws<StoreException>(() => store.Backup(Path.Combine(_folder, "folder"))).Error);
        Assert.DoesNotContain(Directory.EnumerateFiles(_folder), f => f.Contains(".tmp", StringComparison.Ordinal));
    }

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    private static Correction Archive(CellStore store, int number)
    {
        var name = string.Create(CultureInfo.InvariantCulture, $"measurement {number}");
        return store.Archive(new Arrival("gauge", name, name, Measurement(number))).Correction;
    }

    // Noise behind the name: what compresses well leaves nothing to damage.
    private static byte[] Measurement(int number)
    {
        var noise = new byte[500];
        new Random(number).NextBytes(noise);
        return Encoding.UTF8.GetBytes(string.Create(CultureInfo.InvariantCulture, $"measurement {number};{Convert.ToHexString(noise)}"));
    }

    private Correction[] Fill()
    {
        using var store = CellStore.Open(Settings, TimeProvider.System);
        return [.. Enumerable.Range(0, Corrections).Select(i => Archive(store, i))];
    }

    private void IsDamaged()
    {
        var bytes = System.IO.File.ReadAllBytes(File);
        var damaged = Assert.Throws<StoreException>(() => CellStore.Open(Settings, TimeProvider.System));
        Assert.True(damaged.Error == StoreError.Damaged, damaged.ToString());
        Assert.Contains("Restore the latest backup.", damaged.Message, StringComparison.Ordinal);
        Assert.Equal(bytes, System.IO.File.ReadAllBytes(File));
    }

    private void Move(string from, string to)
    {
        foreach (var end in new[] { "", "-wal", "-shm" }.Where(e => System.IO.File.Exists(File + e + from)))
        {
            System.IO.File.Move(File + end + from, File + end + to);
        }
    }
}
