using System.Data.Common;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Detects changes that were made to a store from outside the cell.</summary>
/// <param name="database">The store's database.</param>
/// <param name="key">The key that seals the trail and codes rows; null for none.</param>
internal sealed class OutsideChanges(CellDatabase database, byte[]? key)
{
    private const int MostLooked = 500;
    private readonly AuditLedger _ledger = new(key);

    /// <summary>Ensures that a correction may go to its machine. The first call checks the whole trail, later calls only the new
    /// entries.</summary>
    /// <exception cref="StoreException">With <see cref="StoreError.Tampered"/> if it may not.</exception>
    public void DemandRecorded(Correction correction)
    {
        if (_ledger.Fault(database, correction) is { } fault)
        {
            throw new StoreException(StoreError.Tampered, Recorded.NotSent.With(fault.Statement));
        }
    }

    /// <summary>Changes found by a quick check of users, slots, the first 500 corrections that have not ended, and the database
    /// schema.</summary>
    public IReadOnlyList<Statement> Find() => database.Snapshot((connection, transaction) =>
    {
        var found = new List<Statement>();
        if (database.FormFault(connection, transaction) is { } form) found.Add(form.Statement);
        foreach (var (person, fault) in Look(Person.SelectKept + " ORDER BY name_key", Person.ReadKept, "user"))
        {
            if (fault is not null) found.Add(fault.Statement);
            else if (Person.Looked(person!, key).Problem is { } problem) found.Add(problem.Statement);
        }

        foreach (var (slot, fault) in Look(SlotRow.SelectKept + " ORDER BY machine, slot", SlotRow.ReadKept, "slot"))
        {
            if (fault is not null) found.Add(fault.Statement);
            else if (!slot!.Holds(key)) found.Add(SlotRow.Tampered(slot).Statement);
        }

        var open = Enum.GetValues<CorrectionState>().Where(s => !CorrectionSteps.IsEnd(s) && s != CorrectionState.Released);
        foreach (var (correction, fault) in Look(
            $"{CorrectionRow.SelectKept} WHERE {CorrectionRow.IsIn("state", open)} ORDER BY id LIMIT {CodedRow.Number(MostLooked)}",
                CorrectionRow.ReadKept, "correction"))
        {
            if (fault is not null) found.Add(fault.Statement);
            else if (!correction!.Holds(key)) found.Add(Recorded.CorrectionTampered.With(correction.Value.Id));
        }

        return found;

        IReadOnlyList<(StoredRow<T>? Row, AuditFault? Fault)> Look<T>(string sql, Func<DbDataReader, StoredRow<T>> read,
            string kind) =>
            Rows.Query(connection, sql, r => RecordedRows.Read(r, read, kind), null, transaction);
    });
}
