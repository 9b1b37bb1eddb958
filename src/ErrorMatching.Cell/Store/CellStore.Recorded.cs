using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <content>Detection of changes from outside the cell.</content>
public sealed partial class CellStore
{
    private const int MostLooked = 500;
    private readonly AuditLedger _ledger;

    /// <summary>Ensures that a correction may go to its machine. According to the audit trail, the row must be genuine, someone with the
    /// right must have approved it, and its program must be the computed one. Its slot and the database schema must be as the cell left
    /// them.</summary>
    /// <remarks>Without a key this cannot be verified, and nothing is required. The first call checks the whole trail, later calls only the
    /// new entries.</remarks>
    /// <exception cref="StoreException">With <see cref="StoreError.Tampered"/> if a condition is not met.</exception>
    internal void DemandRecorded(Correction correction)
    {
        if (Database.Snapshot((connection, transaction) => _ledger.Fault(Database, connection, transaction, correction)) is { } fault)
        {
            throw new StoreException(StoreError.Tampered, Recorded.NotSent.With(fault.Statement));
        }
    }

    /// <summary>Changes made outside the cell, found by a quick check of users, slots, the first 500 corrections that have not ended, and
    /// the database schema. <c>audit verify</c> may find more.</summary>
    public IReadOnlyList<Statement> Tampered() => Database.Snapshot((connection, transaction) =>
    {
        var found = new List<Statement>();
        if (Database.FormFault(connection, transaction) is { } form) found.Add(form.Statement);
        foreach (var (person, fault) in Look(Person.SelectKept + " ORDER BY name_key", Person.ReadKept, "user"))
        {
            if (fault is not null) found.Add(fault.Statement);
            else if (Person.Looked(person!, _auditKey).Problem is { } problem) found.Add(problem.Statement);
        }

        foreach (var (slot, fault) in Look(SlotRow.SelectKept + " ORDER BY machine, slot", SlotRow.ReadKept, "slot"))
        {
            if (fault is not null) found.Add(fault.Statement);
            else if (!slot!.Holds(_auditKey)) found.Add(SlotRow.Tampered(slot).Statement);
        }

        var open = Enum.GetValues<CorrectionState>().Where(s => !CorrectionSteps.IsEnd(s) && s != CorrectionState.Released);
        foreach (var (correction, fault) in Look(
            $"{CorrectionRow.SelectKept} WHERE {CorrectionRow.IsIn("state", open)} ORDER BY id LIMIT {CodedRow.Number(MostLooked)}",
                CorrectionRow.ReadKept, "correction"))
        {
            if (fault is not null) found.Add(fault.Statement);
            else if (!correction!.Holds(_auditKey)) found.Add(Recorded.CorrectionTampered.With(correction.Value.Id));
        }

        return found;

        IReadOnlyList<(KeptRow<T>? Row, AuditFault? Fault)> Look<T>(string sql, Func<System.Data.Common.DbDataReader, KeptRow<T>> read,
            string kind) =>
            Rows.Query(connection, sql, r => RecordedRows.Read(r, read, kind), null, transaction);
    });

    // A step requires the row that the cell left. A step that ends a correction without sending it may start from any row: this is how a
    // person gets rid of a tampered correction, and the trail records what was found.
    private static void DemandKept(StoreTransaction transaction, Correction from, Correction after)
    {
        if (transaction.Key is not { } key || transaction.First(CorrectionRow.SelectKept + " WHERE id = @Id", CorrectionRow.ReadKept,
            new { from.Id }) is not { } row
            || row.Value.Version != from.Version || row.Value.State != from.State)
        {
            // A missing or changed row is a conflict, which the update itself detects.
            return;
        }

        if (row.Holds(key) && CorrectionRow.Coded(from).Code(key) == row.Code) return;
        var message = Recorded.CorrectionTampered.With(from.Id);
        var isEnded = after.State is CorrectionState.Rejected or CorrectionState.Refused or CorrectionState.Superseded;
        if (!isEnded && after is not { State: CorrectionState.Failed, ProgramSha256: null })
        {
            throw new StoreException(StoreError.Tampered, message);
        }

        transaction.Audit(CellFlow.ByCell, AuditLedger.Tampered, Recorded.Correction.With(from.Id), message);
    }
}
