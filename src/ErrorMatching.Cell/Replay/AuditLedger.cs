using System.Data.Common;

namespace ErrorMatching.Cell;

/// <summary>The state of the audit trail as this process has read it. Each entry is read once.</summary>
/// <param name="key">The key that seals the trail and codes rows; null for none, in which case nothing is checked.</param>
internal sealed class AuditLedger(byte[]? key)
{
    /// <summary>The audit trail's word for a change made outside the cell.</summary>
    public const string Tampered = "tampered";

    private readonly Lock _gate = new();
    private AuditReplay _replay = new();
    private long _seq;
    private string _hash = AuditEntry.NoHash;

    /// <summary>Why a correction must not go to its machine; null if there is no objection.</summary>
    public AuditFault? Fault(CellDatabase database, Correction correction)
    {
        if (key is null) return null;

        // One after another, each with a connection only in its turn: a store has few.
        lock (_gate)
        {
            return database.Snapshot((connection, transaction) => CatchUp(connection, transaction)
                ?? database.FormFault(connection, transaction)
                ?? Rows(connection, transaction, correction)
                ?? _replay.Corrections[correction.Id].Fault);
        }
    }

    private AuditFault? CatchUp(DbConnection connection, DbTransaction transaction)
    {
        var head = AuditRow.Head(connection, transaction, "");
        foreach (var entry in Cell.Rows.Stream(connection, AuditRow.Select + " WHERE seq > @_seq ORDER BY seq", AuditRow.Read,
            new { _seq }, transaction))
        {
            if (entry.Seq != _seq + 1 || entry.Previous != _hash || !entry.IsWrittenAs(entry.Seq)) return Broken();
            _replay.Add(entry);
            (_seq, _hash) = (entry.Seq, entry.Hash);
        }

        return head.Seq == _seq && head.Hash == _hash && head.IsSealedBy(key) ? null : Broken();
    }

    // The next check starts from the first entry: by then a backup may have replaced the store.
    private AuditFault Broken()
    {
        var fault = new AuditFault(AuditFaultKind.Changed, _seq, Recorded.TrailBroken.With(_seq + 1));
        (_replay, _seq, _hash) = (new(), 0, AuditEntry.NoHash);
        return fault;
    }

    private AuditFault? Rows(DbConnection connection, DbTransaction transaction, Correction correction)
    {
        var rows = new RecordedRows(connection, transaction, _replay, key);
        var found = Cell.Rows.Query(
            connection, CorrectionRow.SelectKept + " WHERE id = @Id", r =>
                RecordedRows.Read(r, CorrectionRow.ReadKept, "correction"), new { correction.Id }, transaction);
        if (found is not [({ } row, _)]) return found is [(_, { } unreadable)] ? unreadable
            : RecordedRows.Unreadable("correction", CodedRow.Number(correction.Id));
        if (rows.OfCorrection(row) is { } fault) return fault;

        // The correction in memory is what will be sent. It was read earlier and must still match the row.
        if (CorrectionRow.Coded(correction).Code(key) != row.Code) return new(AuditFaultKind.RowDiffers, 0,
            Recorded.CorrectionDiffers.With(correction.Id, _seq));
        var (machine, name) = (correction.Machine ?? "", correction.Slot ?? "");
        var slot = Cell.Rows.Query(
            connection, SlotRow.SelectKept + SlotRow.One, r =>
                RecordedRows.Read(r, SlotRow.ReadKept, "slot"), new { Machine = machine, Slot = name }, transaction);
        return slot is [var (held, fault2)] ? fault2 ?? rows.OfSlot(held!) : rows.OfNoSlot(machine, name);
    }
}
