using System.Diagnostics;
using System.Globalization;
using System.Text;
using ErrorMatching.Cell;

namespace ErrorMatching.Peers.Tests;

/// <summary>Several cells on one server, and a server that goes away.</summary>
[Collection(PostgresTests.Name)]
public sealed class PostgresCellsTests : IDisposable
{
    private readonly PostgresServer _server;
    private readonly PostgresSettings _settings;
    private readonly List<CellStore> _opened = [];

    public PostgresCellsTests(PostgresServer server)
    {
        PostgresServer.IsNeeded();
        _server = server;
        _settings = server.NewDatabase();
    }

    [Fact]
    public void Of_two_cells_that_take_the_same_step_one_is_told()
    {
        var (here, there) = (Open(), Open());
        var correction = Archive(here, "one");
        here.Step(correction, CorrectionState.Recognized, "cell", "by name");
        Assert.Equal(
            StoreError.Conflict,
            Assert.Throws<StoreException>(() => there.Step(correction, CorrectionState.Recognized, "cell", "by name")).Error);
    }

    [Fact]
    public void Two_cells_that_open_an_empty_database_at_once_make_one_store()
    {
        var stores = new CellStore[8];
        Parallel.For(
            0,
            stores.Length,
            new ParallelOptions { MaxDegreeOfParallelism = stores.Length },
            i => stores[i] = CellStore.Open(_settings, TimeProvider.System));
        _opened.AddRange(stores);
        Assert.Equal(1, stores[0].ChangeCount());
        Assert.All(stores, s => Assert.Null(s.VerifyAudit()));
    }

    [Fact]
    public void A_slot_of_a_cell_whose_connection_ended_goes_to_another()
    {
        var (here, there) = (Open(), Open());
        using var taken = here.TryLockSlot("mill", "1");
        Assert.True(taken!.IsHeld);
        Assert.Null(there.TryLockSlot("mill", "1"));
        _server.Execute(_settings.Database, "SELECT pg_terminate_backend(pid) FROM pg_locks WHERE locktype = 'advisory'");
        Assert.False(taken.IsHeld);

        // The server says that it ends the connection before it gives back what that one held.
        using var other = Until(() => there.TryLockSlot("mill", "1"), slotLock => slotLock is not null);
        Assert.True(other!.IsHeld);
        Assert.False(taken.IsHeld);
    }

    // A connection that only ended is seen by the server some time later, when it has much to do:
    // who asked next was told that the slot is taken.
    [Fact]
    public void A_slot_that_was_given_back_is_there_at_once()
    {
        var (here, there) = (Open(), Open());
        Parallel.For(0, 8, new ParallelOptions { MaxDegreeOfParallelism = 8 }, slot =>
        {
            for (var round = 0; round < 25; round++)
            {
                using var taken = (round % 2 == 0 ? here : there).TryLockSlot("mill", slot.ToString(CultureInfo.InvariantCulture));
                Assert.True(taken is not null, $"Slot {slot} is still taken in round {round}.");
            }
        });
    }

    [Fact]
    public void A_server_that_goes_away_is_named_and_the_next_call_finds_it_again()
    {
        var store = Open();
        var correction = Archive(store, "one");
        using var taken = store.TryLockSlot("mill", "1");
        _server.Kill();
        try
        {
            Assert.Equal(StoreError.Away, Assert.Throws<StoreException>(() => store.Find(correction.Id)).Error);
            Assert.Equal(
                StoreError.Away,
                Assert.Throws<StoreException>(() => store.Step(correction, CorrectionState.Recognized, "cell", "by name")).Error);
            Assert.Equal(StoreError.Away, Assert.Throws<StoreException>(() => store.TryLockSlot("mill", "2")).Error);
            Assert.Equal(StoreError.Away, Assert.Throws<StoreException>(() => Open()).Error);
            Assert.False(taken!.IsHeld);
        }
        finally
        {
            _server.Start();
        }

        Assert.Equal(correction, store.Find(correction.Id));
        store.Step(correction, CorrectionState.Recognized, "cell", "by name");
        Assert.Null(store.VerifyAudit());
        Assert.False(taken.IsHeld);
    }

    [Fact]
    public void Connections_that_the_server_ends_are_named_once_and_replaced()
    {
        var store = Open();
        var correction = Archive(store, "one");
        _server.Execute(_settings.Database, "SELECT pg_terminate_backend(pid) FROM pg_stat_activity WHERE application_name = 'errormatch'");
        Assert.Equal(StoreError.Away, Assert.Throws<StoreException>(() => store.Find(correction.Id)).Error);
        Assert.Equal(correction, store.Find(correction.Id));
        store.Step(correction, CorrectionState.Recognized, "cell", "by name");
    }

    [Fact]
    public void A_writer_that_another_one_keeps_waiting_is_told()
    {
        var store = Open();
        var correction = Archive(store, "one");
        using var holds = new ManualResetEventSlim();
        var done = false;
        var other = new Thread(() => Open().Write(t =>
        {
            holds.Set();
            while (!Volatile.Read(ref done)) t.Execute("SELECT pg_sleep(0.1)");
            return true;
        }));
        other.Start();
        Assert.True(holds.Wait(TimeSpan.FromMinutes(3), TestContext.Current.CancellationToken));
        try
        {
            Assert.Equal(
                StoreError.Locked,
                Assert.Throws<StoreException>(() => store.Step(correction, CorrectionState.Recognized, "cell", "by name")).Error);
            Assert.Equal(correction, store.Find(correction.Id));
        }
        finally
        {
            Volatile.Write(ref done, true);
            other.Join();
        }

        store.Step(correction, CorrectionState.Recognized, "cell", "by name");
    }

    [Fact]
    public void A_server_that_cannot_keep_every_text_or_forgets_is_refused()
    {
        var latin = _server.NewDatabase("ENCODING 'LATIN1' TEMPLATE template0");
        Assert.Contains(
            "createdb --encoding=UTF8",
            Assert.Throws<StoreException>(() => CellStore.Open(latin, TimeProvider.System)).Message,
            StringComparison.Ordinal);
        _server.Execute("postgres", "ALTER SYSTEM SET fsync = off");
        _server.Execute("postgres", "SELECT pg_reload_conf()");
        try
        {
            // The server reads its settings a little later.
            var refused = Until(() => Record.Exception(() => Open()), refused => refused is not null);
            Assert.Contains("fsync = on", Assert.IsType<StoreException>(refused).Message, StringComparison.Ordinal);
        }
        finally
        {
            _server.Execute("postgres", "ALTER SYSTEM RESET fsync");
            _server.Execute("postgres", "SELECT pg_reload_conf()");
            Until(() => Record.Exception(() => Open()), refused => refused is null);
        }
    }

    [Fact]
    public void A_server_that_takes_no_changes_is_still_read()
    {
        var store = Open();
        var correction = Archive(store, "one");
        _server.Execute("postgres", $"ALTER DATABASE {_settings.Database} SET default_transaction_read_only = on");
        var standby = Open();
        Assert.Equal(correction, standby.Find(correction.Id));
        Assert.Equal(
            StoreError.ReadOnly,
            Assert.Throws<StoreException>(() => standby.Step(correction, CorrectionState.Recognized, "cell", "by name")).Error);
        Assert.Equal(correction, store.Find(correction.Id));
    }

    [Fact]
    public void Who_is_not_let_in_is_told_why()
    {
        var wrong = Path.GetTempFileName();
        try
        {
            File.WriteAllText(wrong, "127.0.0.1:*:*:errormatch:wrong\n");
            PostgresServer.SetMode(wrong, "600");
            var refused = Assert.Throws<StoreException>(() => CellStore.Open(_settings with { PasswordFile = wrong }, TimeProvider.System));
            Assert.Equal(StoreError.Denied, refused.Error);
            Assert.DoesNotContain("wrong", refused.Message, StringComparison.Ordinal);

            PostgresServer.SetMode(wrong, "604");
            Assert.Equal(
                StoreError.Denied,
                Assert.Throws<StoreException>(() => CellStore.Open(_settings with { PasswordFile = wrong }, TimeProvider.System)).Error);
            Assert.Equal(
                StoreError.Missing,
                Assert.Throws<StoreException>(() => CellStore.Open(
                    _settings with { PasswordFile = wrong + ".none" }, TimeProvider.System)).Error);
            Assert.Equal(
                StoreError.Missing,
                Assert.Throws<StoreException>(() => CellStore.Open(_settings with { Database = "none" }, TimeProvider.System)).Error);
        }
        finally
        {
            File.Delete(wrong);
        }
    }

    [Fact]
    public void A_dump_is_its_backup_and_is_restored_by_the_server_s_own_program()
    {
        var store = Open();
        var correction = Archive(store, "one");
        var advice = Assert.Throws<StoreException>(() => store.Backup("cell.dump"));
        Assert.Equal(StoreError.NotSupported, advice.Error);
        Assert.Contains("pg_dump --format=custom", advice.Message, StringComparison.Ordinal);

        var dump = Path.GetTempFileName();
        try
        {
            _server.RunProgram("pg_dump", "--format=custom", $"--file={dump}", _settings.Database);
            var empty = _server.NewDatabase();
            _server.RunProgram("pg_restore", "--exit-on-error", $"--dbname={empty.Database}", dump);
            using var restored = CellStore.Open(empty, TimeProvider.System);
            Assert.Equal(correction, restored.Find(correction.Id));
            Assert.Equal("one"u8.ToArray(), restored.Content(correction.MeasurementSha256));
            Assert.Null(restored.VerifyAudit());
            restored.Step(correction, CorrectionState.Recognized, "cell", "by name");
            Assert.Null(restored.VerifyAudit());
        }
        finally
        {
            File.Delete(dump);
        }
    }

    public void Dispose()
    {
        foreach (var store in _opened) store.Dispose();
    }

    private static T Until<T>(Func<T> look, Func<T, bool> isIt)
    {
        var since = Stopwatch.StartNew();
        while (true)
        {
            var found = look();
            if (isIt(found) || since.Elapsed > TimeSpan.FromMinutes(2)) return found;
            Thread.Sleep(20);
        }
    }

    private static Correction Archive(CellStore store, string key) =>
        store.Archive(new Arrival("gauge", key, key, Encoding.UTF8.GetBytes(key))).Correction;

    private CellStore Open()
    {
        var store = CellStore.Open(_settings, TimeProvider.System);
        lock (_opened) _opened.Add(store);
        return store;
    }
}
