using ErrorMatching.Testing;
using Serilog.Core;

namespace ErrorMatching.Cell.Tests;

/// <summary>How far the trail goes is remembered while the cell runs, next to the keys and in a second file, and a store that was set back
/// is found by either.</summary>
public sealed class WitnessWorkerTests : IAsyncDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly ManualClock _clock = new();
    private readonly RunningCell _cell = new();
    private readonly CellSettings _settings;
    private CellStore _store;

    public WitnessWorkerTests()
    {
        Directory.CreateDirectory(_folder["elsewhere"]);
        _settings = _cell.Settings with
        {
            Store = new SqliteSettings(_folder["cell.db"]),
            KeysFolder = _folder["keys"],
            WitnessFile = _folder["elsewhere/seen"],
        };
        _store = Opened();
    }

    private AuditTrail Trail => new(_store, _settings);

    [Fact]
    public async Task The_end_is_remembered_at_the_start_every_hundred_entries_and_every_half_a_minute()
    {
        var worker = new WitnessWorker(Flow());
        await Works(1);
        Add(99);
        await Works(1);
        Add(1);
        await Works(101);
        Add(1);
        _clock.Advance(TimeSpan.FromSeconds(29));
        await Works(101);
        _clock.Advance(TimeSpan.FromSeconds(1));
        await Works(102);

        async Task Works(long remembered)
        {
            await worker.WorkAsync(TestContext.Current.CancellationToken);
            Assert.Equal(remembered, AuditWitness.Find(_settings.KeysFolder)!.Seq);
            Assert.Equal(remembered, new SecondWitness(_settings.WitnessFile!).Find()!.Seq);
        }
    }

    [Fact]
    public void A_store_that_was_set_back_together_with_its_keys_is_found_by_the_second_file()
    {
        Add(1);
        Assert.Null(Trail.Remember());
        Backup();
        Add(7);
        Assert.Null(Trail.Remember());
        BringBack();

        Assert.Null(new AuditTrail(_store, _settings.KeysFolder).EndFault());
        Assert.Equal((AuditFaultKind.Removed, 3L), Trail.EndFault() is { } end ? (end.Kind, end.Seq) : default);
        var fault = Trail.Verify().Fault!;
        Assert.Equal(AuditFaultKind.Removed, fault.Kind);
        Assert.StartsWith(
            $"Entries 3 to 9 are missing: {_settings.WitnessFile} says that the trail went to entry 9, and the store ends with entry 2 of ",
            fault.Message,
            StringComparison.Ordinal);
        Assert.Contains("errormatch audit take-over", fault.Message, StringComparison.Ordinal);

        // Whatever is written over it does not hide it, and nothing forgets it.
        Add(20);
        Assert.Equal(AuditFaultKind.Changed, Trail.Remember()?.Kind);
        Assert.Equal(9, new SecondWitness(_settings.WitnessFile!).Find()!.Seq);
    }

    [Fact]
    public void A_backup_that_was_brought_back_on_purpose_is_accepted_on_record()
    {
        Assert.Null(Trail.Remember());
        Backup();
        Add(7);
        var lost = _store.AuditHead();
        Assert.Null(Trail.Remember());
        BringBack();

        Assert.True(Trail.TakeOver("sam", "The disk is new."));

        var entry = _store.AuditEntries(1, 10)[^1];
        Assert.Equal(
            ("sam", "trail-set-back", $"set-back(The disk is new., 8, {lost.Hash})"), (entry.Who, entry.What, Stated.As(entry.Basis)));
        Assert.True(Trail.Verify().Holds);
        Assert.Equal(2, new SecondWitness(_settings.WitnessFile!).Find()!.Seq);
        Assert.False(Trail.TakeOver("sam", "Once more."));
    }

    [Fact]
    public void A_second_file_that_was_there_must_stay_there()
    {
        // Before it was ever written, it is not missed.
        Assert.Null(Trail.EndFault());
        Assert.Null(Trail.Remember());
        File.Delete(_settings.WitnessFile!);
        Assert.Equal(AuditFaultKind.WitnessMissing, Trail.EndFault()?.Kind);
        Assert.Equal(AuditFaultKind.WitnessMissing, Trail.Remember()?.Kind);
        Assert.Equal(AuditFaultKind.WitnessMissing, Trail.Verify().Fault?.Kind);

        Assert.True(Trail.TakeOver("sam", "It was thrown away."));
        Assert.Null(Trail.EndFault());
        Assert.True(_store.AuditEntries(1, 10)[^1].Basis.Is(Recorded.WitnessBegun));
        File.WriteAllText(_settings.WitnessFile!, "nine");
        Assert.Contains("elsewhere/seen", Assert.Throws<PeopleException>(() => Trail.EndFault()).Message, StringComparison.Ordinal);

        // Another place is a new beginning; no place is none.
        Assert.Null(new AuditTrail(_store, _settings with { WitnessFile = _folder["another"] }).Remember());
        Assert.True(File.Exists(_folder["another"]));
        Assert.Null(new AuditTrail(_store, _settings with { WitnessFile = null }).EndFault());
    }

    [Fact]
    public async Task What_cannot_be_remembered_is_a_trouble_until_it_can()
    {
        var flow = Flow();
        var worker = new WitnessWorker(flow);
        Directory.Delete(_folder["elsewhere"]);
        await worker.WorkAsync(TestContext.Current.CancellationToken);
        Assert.Equal([("end of the audit trail", "not-kept")], flow.Troubles.Open.Select(t => (t.Where, t.Code)));

        Directory.CreateDirectory(_folder["elsewhere"]);
        _clock.Advance(flow.Pace.Witness);
        await worker.WorkAsync(TestContext.Current.CancellationToken);
        Assert.Empty(flow.Troubles.Open);

        Backup();
        Add(7);
        Assert.Null(Trail.Remember());
        BringBack();
        var setBack = Flow();
        await new WitnessWorker(setBack).WorkAsync(TestContext.Current.CancellationToken);
        Assert.Equal([("end of the audit trail", "store-tampered")], setBack.Troubles.Open.Select(t => (t.Where, t.Code)));
    }

    public async ValueTask DisposeAsync()
    {
        _store.Dispose();
        await _cell.DisposeAsync();
        _folder.Dispose();
    }

    private CellFlow Flow() => new(_settings, _store, _clock, Logger.None, new FlowPace(), CancellationToken.None);

    private CellStore Opened() => CellStore.Open(_settings.Store, TimeProvider.System, AuditKey.Open(_settings.KeysFolder));

    private void Add(int entries)
    {
        for (var i = 0; i < entries; i++) _store.Audit("anna", "noted", "something");
    }

    // Store and keys as they are now, and again later, as by a snapshot of the whole computer.
    private void Backup()
    {
        _store.Backup(_folder["older.db"]);
        File.Copy(_folder["keys/audit.seen"], _folder["older.seen"]);
    }

    private void BringBack()
    {
        _store.Dispose();
        foreach (var file in Directory.GetFiles(_folder.Path, "cell.db*")) File.Delete(file);
        File.Move(_folder["older.db"], _folder["cell.db"]);
        File.Move(_folder["older.seen"], _folder["keys/audit.seen"], overwrite: true);
        _store = Opened();
    }
}
