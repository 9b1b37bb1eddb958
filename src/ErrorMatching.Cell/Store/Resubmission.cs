using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Resubmits a measurement: a new correction takes the place of one that is not at its machine.</summary>
internal static class Resubmission
{
    /// <summary>The code of the correction that ends.</summary>
    public const string Code = "computed-anew";

    /// <summary>The new correction, which is archived, in the same place in line as the one that it ends.</summary>
    public static Correction Give(StoreTransaction transaction, Correction correction, string by, string? reason)
    {
        // Before anything is written, so that the later of two callers sees the result of the first.
        if (!CorrectionSteps.Allows(correction.State, CorrectionState.Superseded)
            || transaction.Value<long>("SELECT version FROM correction WHERE id = @Id", [("Id", correction.Id)]) != correction.Version)
        {
            throw StepWriter.Conflict(transaction, correction, CorrectionState.Superseded);
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
            ArrivalKey.OfAgain(correction.Gauge, correction.FileName, correction.Id),
            by,
            Recorded.GivenAgain.With(correction.Id));
        var basis = Recorded.ComputedAnew.With(given.Id);

        // This frees its identity: if the job reverts to an earlier version, the measurement may be computed with it again.
        var ended = CorrectionRow.Stored(correction with
        {
            State = CorrectionState.Superseded,
            Version = correction.Version + 1,
            ChangedAt = transaction.Now,
            Identity = null,
            Code = Code,
            Reason = basis,
        });
        StepWriter.Update(transaction, correction, ended);
        StepWriter.Note(transaction, ended, correction.State, by, Statement.InARow(basis, reason ?? ""));
        return given;
    }
}
