using ErrorMatching.Json;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Stores what arrives as new corrections.</summary>
internal static class ArrivalWriter
{
    /// <summary>The code of a correction that ends because it is recalculated. It is stored and documented, so that it stays as it
    /// was.</summary>
    public const string Recalculated = "computed-anew";

    /// <summary>Stores a file as a new correction.</summary>
    /// <returns>The correction, and whether it is new.</returns>
    public static (Correction Correction, bool IsNew) Archive(
        StoreTransaction transaction, Arrival arrival, string sha256, PackedContent packed)
    {
        if (Known(transaction, arrival.Key) is { } known) return (known, false);
        StoredContent.Keep(transaction, sha256, packed);
        return (
            Arrive(
                transaction,
                New(transaction, CorrectionState.Archived, arrival.Gauge, arrival.FileName, sha256, arrival.Bytes.Length) with
                {
                    Trace = arrival.Trace
                },
                arrival.Key),
            true);
    }

    /// <summary>Records a file that is refused without being stored.</summary>
    /// <returns>The correction, and whether it is new.</returns>
    public static (Correction Correction, bool IsNew) ArchiveUnread(StoreTransaction transaction, UnreadArrival arrival) =>
        Known(transaction, arrival.Key) is { } known
            ? (known, false)
            : (Arrive(
                transaction,
                New(transaction, CorrectionState.Refused, arrival.Gauge, arrival.FileName, arrival.Sha256, arrival.Length) with
                {
                    Code = arrival.Code,
                    Reason = arrival.Reason,
                    Trace = arrival.Trace
                },
                arrival.Key), true);

    /// <summary>A correction that is about to be stored.</summary>
    public static Correction New(
        StoreTransaction transaction, CorrectionState state, string gauge, string fileName, string sha256, long length) =>
        new(0, state, 1, StoredText.Name(gauge), StoredText.Name(fileName), transaction.Now, sha256, length)
        {
            ChangedAt = transaction.Now
        };

    /// <summary>Stores a new correction with its first step. Without a basis, the cell itself took it from its gauge.</summary>
    public static Correction Arrive(
        StoreTransaction transaction, Correction arriving, string key, string by = AuditEntry.ByCell, Statement? basis = null)
    {
        var arrived = CorrectionRow.Stored(arriving);
        var id = transaction.Value<long>(CorrectionRow.Insert, [
            ("State", CorrectionRow.Word(arrived.State)),
            ("Arrival", KeyOf(key)),
            ("Gauge", arrived.Gauge),
            ("FileName", arrived.FileName),
            ("At", StoredTime.Of(transaction.Now)),
            ("MeasurementSha256", arrived.MeasurementSha256),
            ("MeasurementBytes", arrived.MeasurementBytes),
            ("Code", arrived.Code),
            ("Reason", arrived.Reason?.Text),
            ("Trace", arrived.Trace),
            ("Job", arrived.Job),
            ("Piece", arrived.Piece),
            ("Serial", arrived.Serial),
            ("WorkOrder", arrived.WorkOrder),
            ("Machine", arrived.Machine),
            ("Slot", arrived.Slot),
            ("Program", arrived.Program),
            ("MeasuredAs", arrived.MeasuredAs),
        ]);
        arrived = arrived with { Id = id };
        if (transaction.CodeOf(CorrectionRow.Coded(arrived)) is { } code) transaction.Execute(
            "UPDATE correction SET row_code = @code WHERE id = @id", [("code", code), ("id", id)]);
        CorrectionStepWriter.Note(
            transaction, arrived, null, by, basis ?? arrived.Reason ?? Recorded.Arrived.With(arrived.Gauge, arrived.FileName));
        return arrived;
    }

    /// <summary>Recalculates a correction that is not at its machine: its measurement is stored once more as a new correction, in the same
    /// place in line, and the old one ends.</summary>
    /// <returns>The new correction, which is archived.</returns>
    /// <exception cref="StoreException">With <see cref="StoreError.Conflict"/> if someone else changed the old one first, or no step leads
    /// to its end.</exception>
    public static Correction Recalculate(StoreTransaction transaction, Correction correction, string by, string? reason)
    {
        // Before anything is written, so that the later of two callers sees the result of the first.
        if (!CorrectionSteps.Allows(correction.State, CorrectionState.Superseded)
            || transaction.Value<long>("SELECT version FROM correction WHERE id = @Id", [("Id", correction.Id)]) != correction.Version)
        {
            throw CorrectionStepWriter.Conflict(transaction, correction, CorrectionState.Superseded);
        }

        var given = ArrivalWriter.Arrive(
            transaction,
            ArrivalWriter.New(
                transaction,
                CorrectionState.Archived,
                correction.Gauge,
                correction.FileName,
                correction.MeasurementSha256,
                correction.MeasurementBytes) with
            {
                MeasuredAs = correction.Turn,
                Job = correction.Job,
                Piece = correction.Piece,
                Serial = correction.Serial,
                WorkOrder = correction.WorkOrder,
                Machine = correction.Machine,
                Slot = correction.Slot,
                Program = correction.Program,
                Trace = correction.Trace,
            },
            ArrivalKey.OfRecalculation(correction.Gauge, correction.FileName, correction.Id),
            by,
            Recorded.RecalculationOf.With(correction.Id));
        var basis = Recorded.RecalculatedBy.With(given.Id);

        // This frees its identity: if the job reverts to an earlier version, the measurement may be computed with it again.
        var ended = CorrectionRow.Stored(correction with
        {
            State = CorrectionState.Superseded,
            Version = correction.Version + 1,
            ChangedAt = transaction.Now,
            Identity = null,
            Code = Recalculated,
            Reason = basis,
        });
        CorrectionStepWriter.Update(transaction, correction, ended);
        CorrectionStepWriter.Note(transaction, ended, correction.State, by, Statement.InARow(basis, reason ?? ""));
        return given;
    }

    private static Correction? Known(StoreTransaction transaction, string key) =>
        transaction.First(CorrectionRow.Select + " WHERE arrival = @Arrival", CorrectionRow.Read, [("Arrival", KeyOf(key))]);

    private static string KeyOf(string key) => ContentHash.Sha256OfText(key);
}
