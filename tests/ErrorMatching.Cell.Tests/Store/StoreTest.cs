using System.Security.Cryptography;
using System.Text;

namespace ErrorMatching.Cell.Tests;

/// <summary>A test of a store, whatever keeps it. Each kind of store runs all of them.</summary>
/// <param name="kind">The kind of store.</param>
public abstract class StoreTest(StoreKind kind) : IDisposable
{
    private readonly List<IDisposable> _opened = [];
    private StoreSettings? _settings;

    private protected static readonly byte[] AuditKey = [.. Enumerable.Range(0, 32).Select(i => (byte)i)];

    private protected TestClock Clock { get; } = new();

    /// <summary>The kind of store.</summary>
    private protected StoreKind Kind => kind;

    /// <summary>The store of this test, which begins empty.</summary>
    protected StoreSettings Settings => _settings ??= kind.NewSettings();

    protected static string Hash(string text) => Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(text)));

    protected static ReadOnlyMemory<byte> Bytes(string text) => Encoding.UTF8.GetBytes(text);

    protected static Arrival Arrival(string key, string text) => new("gauge", $"{key}.csv", key, Bytes(text), "trace");

    protected static Correction Recognize(CellStore store, Correction correction, string serial, string? identity = null) => store.Step(
        correction,
        CorrectionState.Recognized,
        "cell",
        "by name",
        c => c with
        {
            Job = "job",
            Piece = "part",
            Serial = serial,
            WorkOrder = "WO-1",
            Identity = identity ?? $"identity {c.Id}",
            Machine = "mill",
            Slot = "1",
            Program = "O1.nc"
        });

    protected CellStore Open(byte[]? auditKey = null)
    {
        var store = CellStore.Open(Settings, Clock, auditKey);
        _opened.Add(store);
        return store;
    }

    private protected static Correction Approve(CellStore store, string key, string program)
    {
        var correction = Recognize(store, store.Archive(Arrival(key, key)).Correction, key);
        correction = store.Step(
            correction, CorrectionState.Computed, "cell", "computed", c => c with { ProgramSha256 = Hash(program) }, [Bytes(program)]);
        correction = store.Step(correction, CorrectionState.Proposed, "cell", "within limits");
        return store.Step(correction, CorrectionState.Approved, "anna", "looks right");
    }

    private protected static Correction Up(CellStore store, Correction correction) =>
        store.Step(correction, CorrectionState.Uploading, "cell", "in line");

    private protected static Correction Release(CellStore store, string key, string program) =>
        store.Step(
            store.Step(Up(store, Approve(store, key, program)), CorrectionState.Verified, "cell", "read back"),
            CorrectionState.Released,
            "anna",
            "cut");

    public void Dispose()
    {
        Dispose(true);
        GC.SuppressFinalize(this);
    }

    protected virtual void Dispose(bool disposing)
    {
        foreach (var each in _opened) each.Dispose();
        kind.Dispose();
    }
}
