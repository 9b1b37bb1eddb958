using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <content>Resubmitted measurements.</content>
public sealed partial class CellStore
{
    /// <summary>Resubmits the measurement of a correction that is not at its machine, in the same place in line, and ends that correction.
    /// Both changes and their audit entries are one transaction.</summary>
    /// <param name="correction">The correction as it was read.</param>
    /// <param name="by">The user's name.</param>
    /// <param name="reason">Why, in a person's words; null if none are given.</param>
    /// <returns>The new correction, which is archived.</returns>
    /// <exception cref="StoreException">With <see cref="StoreError.Conflict"/> if someone else changed it first, or no step leads to its
    /// end.</exception>
    public Correction GiveAgain(Correction correction, string by, string? reason)
    {
        ArgumentNullException.ThrowIfNull(correction);
        return Write(transaction =>
        {
            // Before anything is written, so that the later of two callers sees the result of the first.
            if (!CorrectionSteps.Allows(correction.State, CorrectionState.Superseded)
                || transaction.Value<long>("SELECT version FROM correction WHERE id = @Id", new { correction.Id }) != correction.Version)
            {
                throw Conflict(transaction, correction, CorrectionState.Superseded);
            }

            var given = Arrive(
                transaction,
                New(
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
            var ended = CorrectionRow.Kept(correction with
            {
                State = CorrectionState.Superseded,
                Version = correction.Version + 1,
                ChangedAt = transaction.Now,
                Identity = null,
                Code = CellCodes.ComputedAnew,
                Reason = basis,
            });
            DemandKept(transaction, correction, ended);
            var code = transaction.CodeOf(CorrectionRow.Coded(ended));
            if (transaction.Execute(CorrectionRow.Update, CorrectionRow.Parameters(ended, correction.State, code)) != 1)
            {
                throw Conflict(transaction, correction, CorrectionState.Superseded);
            }

            Note(transaction, ended, correction.State, by, Statement.InARow(basis, reason ?? ""));
            return given;
        });
    }
}
