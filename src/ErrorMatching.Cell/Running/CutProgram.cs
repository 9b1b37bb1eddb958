using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Determines which program cut a measured counterpart, if corrections accumulate.</summary>
/// <param name="By">The correction that made it; null for the original program.</param>
/// <param name="Undecided">The correction for which it is not recorded yet whether the piece was cut before or after it; null if
/// known.</param>
internal sealed record CutProgram(Correction? By, Correction? Undecided)
{
    /// <summary>The last program for the piece's own serial number, otherwise the last one of the job. A released correction's program has
    /// cut a piece. While a correction is verified, or was reverted and still has the slot, either its program or the one before may have
    /// cut the measured piece.</summary>
    /// <param name="store">The store.</param>
    /// <param name="counterpart">The correction of the measured piece, with job, serial number, machine and slot.</param>
    public static CutProgram Of(CellStore store, Correction counterpart)
    {
        var job = counterpart.Job!;
        var own = counterpart.Serial is { } serial ? store.Corrections.LastSent(job, serial) : null;
        var last = own ?? store.Corrections.LastSent(job, null);
        if (last is { State: CorrectionState.Verified })
        {
            return new(null, last);
        }

        var holder = store.Slot(counterpart.Machine!, counterpart.Slot!).Correction is { } id ? store.Find(id) : null;
        return holder is { State: CorrectionState.Reverted } && holder.Job == job && (own is null || holder.Serial == counterpart.Serial)
            ? new(null, holder)
            : new(last, null);
    }

    /// <summary>The program that cut the piece of a correction that is already computed: it no longer changes.</summary>
    /// <param name="store">The store.</param>
    /// <param name="made">A correction that was computed for a job that accumulates.</param>
    /// <returns>The correction whose program it adds to; null for the original program.</returns>
    public static Correction? Before(CellStore store, Correction made) =>
        made is not { BaseSha256: { } program, SumsSha256: not null, Job: { } job }
        ? null
        : store.Corrections.OfProgram(job, program).LastOrDefault(
            c => c.Id < made.Id
                && c.SumsSha256 is not null
                && (CorrectionSteps.Of(c.State).IsSent || c.State == CorrectionState.Reverted));

    /// <summary>Why nothing is computed until it is known, and what to do.</summary>
    public Statement Reason => Undecided is not { } held ? "" : held.State == CorrectionState.Reverted
        ? Recorded.NotReleasedReverted.With(held.Id, held.Slot, held.Machine, held.Id)
        : Recorded.NotReleased.With(held.Id, held.Slot, held.Machine, held.Id);
}
