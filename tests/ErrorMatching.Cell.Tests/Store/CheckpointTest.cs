using System.Globalization;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell.Tests;

/// <summary>Stores with checkpoints of their audit trails.</summary>
public abstract class CheckpointTest(StoreKind kind) : StoreTest(kind)
{
    private protected const string Own = "G0 Z-500";
    private protected static readonly Statement Policy = Recorded.PolicyWithin.With(0.05);

    private protected static CancellationToken Stop => TestContext.Current.CancellationToken;

    private protected CellStore NewProcess() => CellStore.Open(Settings, Clock, AuditKey);

    // An approved and a proposed correction, and a checkpoint behind them.
    private protected (Correction Approved, Correction Proposed) Filled()
    {
        using var store = NewProcess();
        var filled = Fill(store);
        store.Outside.KeepCheckpoint(Stop, 1);
        Assert.Equal(1, Count(store));
        return filled;
    }

    private protected (Correction Approved, Correction Proposed) Fill(CellStore store)
    {
        var approved = store.Step(Proposed(store, "one"), CorrectionState.Approved, "cell", Policy);
        return (approved, Proposed(store, "two"));
    }

    private protected static Correction Proposed(CellStore store, string key)
    {
        var c = Recognize(store, store.Archive(Arrival(key, key)).Correction, key);
        c = store.Step(c, CorrectionState.Computed, "cell", "computed", x => x with { ProgramSha256 = Hash("program " + key) },
            [Bytes("program " + key)]);
        return store.Step(c, CorrectionState.Proposed, "cell", "within limits");
    }

    private protected static Correction Sent(CellStore store, string key)
    {
        var c = store.Step(Proposed(store, key), CorrectionState.Approved, "cell", Policy);
        c = store.Step(Up(store, c), CorrectionState.Verified, "cell", "read back");
        return store.Step(c, CorrectionState.Released, "cell", "cut");
    }

    private protected static void Note(CellStore store, int entries) => store.Write(transaction =>
    {
        for (var i = 0; i < entries; i++) transaction.Audit("cell", "noted", null, i.ToString(CultureInfo.InvariantCulture));
        return true;
    });

    private protected static string Refused(CellStore store, Correction correction)
    {
        var refusal = Assert.Throws<StoreException>(() => store.Outside.DemandRecorded(correction));
        Assert.Equal(StoreError.Tampered, refusal.Error);
        return Stated.As(refusal.Statement);
    }

    private protected void ChangeOldEntry(CellStore store) =>
        Tamper(store, Kind.RemoveTriggersSql, "UPDATE audit SET who = 'eve' WHERE seq = 2");

    private protected static void Tamper(CellStore store, params string[] statements)
    {
        foreach (var sql in statements)
        {
            store.Database.Change((connection, transaction) => connection.Execute(
                sql, [("own", Hash(Own)), ("bytes", Bytes(Own).ToArray())], transaction));
        }
    }

    private protected static long Count(CellStore store) => store.Read("SELECT count(*) FROM audit_checkpoint", r => r.GetInt64(0))[0];

    private protected static AuditCheckpoint Kept(CellStore store) => store.Database.Snapshot((connection, transaction) =>
        AuditCheckpoint.Find(connection, transaction, AuditKey).Found)!;

    // What is kept is what a process says that has no checkpoint.
    private protected static void IsWhole(CellStore store)
    {
        var kept = Kept(store);
        AuditCheckpoint.Remove(store.Database);
        Assert.Equal(new AuditLedger(AuditKey).Checkpoint(store.Database, Stop), kept);
    }

    private protected static AuditFault? FaultOfCheckpoint(CellStore store) =>
        store.Database.Snapshot((connection, transaction) => AuditCheckpoint.Fault(connection, transaction, AuditKey));
}
