using System.Diagnostics;
using System.Text;
using ErrorMatching.Cell;
using ErrorMatching.Json;
using ErrorMatching.Testing;

namespace ErrorMatching.Peers.Tests;

/// <summary>Cells with a schema of their own on one server: each has its own audit trail, and a right to a slot is a lease.</summary>
[Collection(PostgresTests.Name)]
public sealed class OwnSchemaTests : IDisposable
{
    private const string Program = "O1.NC";
    private static readonly byte[] Key = [.. Enumerable.Range(1, 32).Select(i => (byte)i)];
    private readonly TemporaryFolder _folder = new();
    private readonly PostgresServer _server;
    private readonly PostgresSettings _settings;

    public OwnSchemaTests(PostgresServer server)
    {
        PostgresServer.IsNeeded();
        (_server, _settings) = (server, server.NewDatabase());
    }

    public void Dispose() => _folder.Dispose();

    [Fact]
    public void Each_schema_has_its_own_trail_corrections_and_slots()
    {
        using var one = Open("press");
        using var two = Open("mill_2");
        using var all = Open(null);
        Archive(one, "a");
        Archive(one, "b");
        Archive(two, "a");

        Assert.Equal((3L, 2L, 1L), (one.ChangeCount(), two.ChangeCount(), all.ChangeCount()));
        Assert.Equal(["2, 1", "1", ""], [Numbers(one), Numbers(two), Numbers(all)]);
        Assert.NotEqual(one.AuditEntries(1, 1)[0].Hash, two.AuditEntries(1, 1)[0].Hash);
        using var here = one.TryLockSlot("mill", "1");
        using var there = two.TryLockSlot("mill", "1");
        Assert.True(here!.IsHeld && there!.IsHeld);

        _server.Execute(_settings.Database, "UPDATE press.correction SET file_name = 'c' WHERE id = 1");
        Assert.NotEmpty(one.Tampered());
        Assert.Empty(two.Tampered());
        Assert.All([one, two, all], s => Assert.Null(s.VerifyAudit()));

        static string Numbers(CellStore store) => string.Join(", ", store.Search(new HistoryQuery()).Select(c => c.Id));
    }

    [Fact]
    public void A_store_of_before_becomes_the_schema_of_its_cell_as_it_is()
    {
        AuditHead head;
        using (var before = Open(null))
        {
            Archive(before, "a");
            head = before.AuditHead();
        }

        _server.Execute(_settings.Database, "ALTER SCHEMA public RENAME TO line_1");
        using var after = Open("line_1");
        Assert.Equal(head, after.AuditHead());
        after.Step(after.Find(1)!, CorrectionState.Recognized, "cell", "by name");
        Assert.Null(after.VerifyAudit());
        Assert.Empty(after.Tampered());
    }

    // The server does not hear from a frozen process, and hears from a living one that has nothing to say.
    [Theory]
    [InlineData(0, 3, false)]
    [InlineData(1, 6, true)]
    public async Task Rights_end_with_the_silence_of_their_process(int signOfLifeSeconds, int leaseSeconds, bool isKept)
    {
        using var locks = Locks(signOfLifeSeconds);
        using var others = Locks(0);
        using var taken = locks.TryTake("slot 1");
        Assert.Null(locks.TryTake("slot 1"));
        Assert.Null(others.TryTake("slot 1"));

        // On a busy computer a sign of life is late by seconds, and so is the end of a lease.
        var other = isKept ? await LaterAsync() : await AtLastAsync();
        using (other) Assert.Equal((isKept, !isKept), (taken!.IsHeld, other is not null));

        async Task<PostgresLock?> LaterAsync()
        {
            await Task.Delay(TimeSpan.FromSeconds(leaseSeconds + 1), TestContext.Current.CancellationToken);
            return others.TryTake("slot 1");
        }

        async Task<PostgresLock?> AtLastAsync()
        {
            var (watch, got) = (Stopwatch.StartNew(), others.TryTake("slot 1"));
            while (got is null && watch.Elapsed < TimeSpan.FromMinutes(1))
            {
                await Task.Delay(100, TestContext.Current.CancellationToken);
                got = others.TryTake("slot 1");
            }

            return got;
        }

        PostgresLocks Locks(int keepAlive)
        {
            var connection = PostgresDatabase.Connection(_settings);
            (connection.Pooling, connection.KeepAlive) = (false, keepAlive);
            connection.Options += $" -c idle_session_timeout={leaseSeconds}s";
            return new(connection.ConnectionString, "");
        }
    }

    // It is frozen between asking for its right and writing, before it looks once more, or between asking again and renaming; meanwhile
    // another process gets the slot, or nobody does.
    [Theory]
    [InlineData(1, true)]
    [InlineData(2, true)]
    [InlineData(3, true)]
    [InlineData(1, false)]
    [InlineData(2, false)]
    public async Task Who_lost_its_right_replaces_nothing_at_the_machine(int frozenBefore, bool isTakenOver)
    {
        var token = TestContext.Current.CancellationToken;
        using var here = Open("line_1");
        using var there = Open("line_1");
        _folder.File(Program, "old");
        var (frozen, thaw) = (new TaskCompletionSource(), new TaskCompletionSource());
        var right = new SlotRight(here, "mill", "1");
        using var taken = right.TryTake();
        var operations = 0;
        var machine = new HookedFolder(Machine(), async _ =>
        {
            if (++operations == frozenBefore && frozen.TrySetResult()) await thaw.Task;
        });
        var sending = Sender(machine, right).SendAsync(Program, Hash("old"), "first"u8.ToArray(), "1", token);
        await frozen.Task.WaitAsync(token);
        _server.Execute(_settings.Database, "SELECT pg_terminate_backend(pid) FROM pg_locks WHERE locktype = 'advisory'");

        if (isTakenOver)
        {
            var other = new SlotRight(there, "mill", "1");
            IDisposable? got = null;
            while (got is null) got = other.TryTake();
            using (got)
            {
                var sender = Sender(Machine(), other);
                await sender.RecoverAsync(Program, token);
                await sender.SendAsync(Program, Hash("old"), "second"u8.ToArray(), "2", token);
            }
        }

        thaw.SetResult();
        var failure = await Record.ExceptionAsync(() => sending);
        if (isTakenOver)
            Assert.True(
                failure is StoreException { Error: StoreError.Away } or ChangedAtMachineException or TransportException, $"{failure}");
        else Assert.Equal(StoreError.Away, Assert.IsType<StoreException>(failure).Error);
        Assert.Equal(isTakenOver ? "second" : "old", File.ReadAllText(_folder[Program]));

        // What was written since then lies beside the program until the next one is sent.
        if (isTakenOver && frozenBefore > 1) Assert.Equal([Program], Directory.EnumerateFiles(_folder.Path).Select(Path.GetFileName));
    }

    private IMachineFolder Machine() => new FolderSettings(_folder.Path).Open("mill", () => null, TimeSpan.FromSeconds(10));

    private static ProgramSender Sender(IMachineFolder folder, SlotRight right) =>
        new(new FencedFolder(folder, right.Demand), hash => hash == Hash("old"));

    private static string Hash(string text) => ContentHash.Sha256(Encoding.UTF8.GetBytes(text));

    private CellStore Open(string? schema) => CellStore.Open(_settings with { Schema = schema }, TimeProvider.System, Key);

    private static void Archive(CellStore store, string key) => store.Archive(new Arrival("gauge", key, key, Encoding.UTF8.GetBytes(key)));
}
