using System.Data.Common;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Detects changes that were made to a store from outside the cell.</summary>
/// <param name="database">The store's database.</param>
/// <param name="key">The key that seals the trail and codes rows; null for none.</param>
internal sealed class OutsideChanges(CellDatabase database, byte[]? key)
{
    /// <summary>After how many entries a new checkpoint is made.</summary>
    public const int Rhythm = 1000;

    private const int MostLooked = 500;
    private readonly AuditLedger _ledger = new(key);
    private long _checkpointAt;

    /// <summary>Why this process read the whole trail, and did not go on from a checkpoint; null if it did, or if the trail is
    /// short.</summary>
    public Statement? WhyWhole =>
        _ledger.WhyWhole is { } why && (!why.Is(RecordedCheckpoint.Missing) || _ledger.Seq >= Rhythm) ? why : null;

    /// <summary>Ensures that a correction may go to its machine. According to the audit trail, the row must be genuine, someone with the
    /// right must have approved it, and its program must be the computed one. Its slot and the database schema must be as the cell left
    /// them.</summary>
    /// <remarks>Without a key this cannot be verified, and nothing is required. The first call goes on from the store's checkpoint of the
    /// trail, or reads the whole trail; later calls read only the new entries.</remarks>
    /// <exception cref="StoreException">With <see cref="StoreError.Tampered"/> if a condition is not met.</exception>
    public void DemandRecorded(Correction correction)
    {
        if (_ledger.Fault(database, correction) is { } fault)
        {
            throw new StoreException(StoreError.Tampered, Recorded.NotSent.With(fault.Statement));
        }
    }

    /// <summary>Makes a new checkpoint if enough entries were added since the last one.</summary>
    /// <param name="stop">Ends the reading of the trail; the next call goes on.</param>
    /// <param name="rhythm">How many entries are enough.</param>
    public void KeepCheckpoint(CancellationToken stop, int rhythm = Rhythm)
    {
        if (key is null || database.HeardOf() is var now && now - _checkpointAt < rhythm) return;
        var checkpoint = _ledger.Checkpoint(database, stop);
        if (checkpoint is { State.Length: <= AuditCheckpoint.MostLength }) checkpoint.Keep(database, key);
        _checkpointAt = now;
    }

    /// <summary>Looks at some more of the entries before the checkpoint that this process went on from. If one is not as it was written,
    /// nothing is sent any more, and the next process reads the whole trail.</summary>
    /// <param name="most">How many entries at most.</param>
    /// <returns>What is wrong; null if nothing is.</returns>
    public Statement? LookBehind(int most)
    {
        if (_ledger.LookBehind(database, most) is not { } fault) return null;
        AuditCheckpoint.Remove(database);
        return fault.Statement;
    }

    /// <summary>Changes found by a quick check of users, slots, the first 500 corrections that are not settled, and the database
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

        foreach (var (credential, fault) in Look(
            CredentialRow.SelectKept + " ORDER BY name_key, kind", CredentialRow.ReadKept, "credential"))
        {
            if (fault is not null) found.Add(fault.Statement);
            else if (!credential!.Holds(key)) found.Add(CredentialRow.Tampered(credential.Value).Statement);
        }

        foreach (var (slot, fault) in Look(SlotRow.SelectKept + " ORDER BY machine, slot", SlotRow.ReadKept, "slot"))
        {
            if (fault is not null) found.Add(fault.Statement);
            else if (!slot!.Holds(key)) found.Add(SlotRow.Tampered(slot).Statement);
        }

        var open = CorrectionSteps.Where(s => !s.IsSettled);
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
