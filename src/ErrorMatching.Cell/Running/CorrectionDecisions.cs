using System.Globalization;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>People's decisions about corrections. The caller must check the person's rights; each decision is one step in the store, under
/// the person's name.</summary>
/// <param name="store">The store.</param>
public sealed class CorrectionDecisions(CellStore store)
{
    /// <summary>Approves a correction for its machine: one that waits for approval, or one that failed at the machine.</summary>
    /// <param name="id">Its number.</param>
    /// <param name="by">The user's name.</param>
    /// <param name="reason">Why; null if no reason is given.</param>
    /// <exception cref="DecisionException">It cannot be approved.</exception>
    public Correction Approve(long id, string by, string? reason)
    {
        var correction = Demand(id, "approved", CorrectionSteps.Where(s => s.IsUndecided));
        if (correction.ProgramSha256 is null)
        {
            throw new DecisionException(
                DecisionException.NothingToSend,
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"Correction {id} failed before it had a program: {correction.Reason} Reject it, put that right and measure again."));
        }

        return Step(
            correction, CorrectionState.Approved, by, reason ?? Recorded.Approved.With(), c => c with { Code = null, Reason = null });
    }

    /// <summary>Rejects a correction that is not at its machine.</summary>
    /// <param name="id">Its number.</param>
    /// <param name="by">The user's name.</param>
    /// <param name="reason">Why.</param>
    /// <exception cref="DecisionException">It cannot be rejected.</exception>
    public Correction Reject(long id, string by, string reason)
    {
        var correction = Demand(id, "rejected", CorrectionSteps.Before(CorrectionState.Rejected));
        return Step(correction, CorrectionState.Rejected, by, reason, c => c with { Code = "rejected", Reason = reason });
    }

    /// <summary>Records that the piece is cut, which frees the slot for the next.</summary>
    /// <param name="id">Number of the correction that has the slot.</param>
    /// <param name="by">The user's name.</param>
    /// <param name="reason">Why; null if no reason is given.</param>
    /// <exception cref="DecisionException">It cannot be released.</exception>
    public Correction Release(long id, string by, string? reason)
    {
        var correction = Demand(id, "released", CorrectionSteps.Where(s => s.WaitsForRelease));
        if (correction.State == CorrectionState.Verified)
        {
            return Step(correction, CorrectionState.Released, by, reason ?? Recorded.PieceCut.With(), null);
        }

        if (store.Slot(correction.Machine!, correction.Slot!).Correction != id)
        {
            throw new DecisionException(
                DecisionException.WrongState,
                FormattableString.Invariant(
                    $"Correction {id} is reverted and does not have its slot any more: there is nothing to release."));
        }

        store.FreeSlot(correction.Machine!, correction.Slot!, id, by, reason ?? Recorded.SlotUsable.With());
        return correction;
    }

    /// <summary>The correction with a given number.</summary>
    /// <exception cref="DecisionException">There is none.</exception>
    public Correction Demand(long id) =>
        store.Find(id)
            ?? throw new DecisionException(
                DecisionException.UnknownCorrection,
                FormattableString.Invariant($"There is no correction {id}. errormatch cell history lists those that there are."));

    internal Correction Demand(long id, string done, IReadOnlyList<CorrectionState> states)
    {
        var correction = Demand(id);
        return states.Contains(correction.State) ? correction : throw new DecisionException(
            DecisionException.WrongState,
            string.Create(
                CultureInfo.InvariantCulture,
                $"Correction {id} is {Word(correction.State)}, and only one that is {string.Join(" or ", states.Select(Word))} can be "
                    + $"{done}."));
    }

    internal Correction Step(Correction correction, CorrectionState to, string by, Statement basis, Func<Correction, Correction>? with)
    {
        try
        {
            return store.Step(correction, to, by, basis, with);
        }
        catch (StoreException e) when (e.Error == StoreError.Conflict)
        {
            throw ChangedMeanwhile(correction.Id);
        }
    }

    internal static DecisionException ChangedMeanwhile(long id) => new(
        DecisionException.ChangedMeanwhile,
        FormattableString.Invariant($"Correction {id} changed meanwhile: look at it again with errormatch cell show."));

    private static string Word(CorrectionState state) => state.ToString().ToLowerInvariant();
}

/// <summary>A person's decision cannot be carried out. Nothing was changed.</summary>
/// <param name="code">Stable code: one of the constants.</param>
/// <param name="message">A sentence for the person: the obstacle and what to do.</param>
public sealed class DecisionException(string code, string message) : Exception(message)
{
    /// <summary>The store has no correction of this number.</summary>
    public const string UnknownCorrection = "unknown-correction";

    /// <summary>The correction's state does not allow the decision.</summary>
    public const string WrongState = "wrong-state";

    /// <summary>Someone else decided first.</summary>
    public const string ChangedMeanwhile = "changed-meanwhile";

    /// <summary>There is no program to send.</summary>
    public const string NothingToSend = "nothing-to-send";

    /// <summary>It was made with the job's current version: recalculated, it would be the same.</summary>
    public const string JobUnchanged = "job-unchanged";

    /// <summary>Its job is unusable, or no longer in the configuration.</summary>
    public const string JobUnusable = "job-unusable";

    /// <summary>Another correction was made from the same measurement with the job's current version.</summary>
    public const string AlreadyKnown = CellCodes.AlreadyKnown;

    /// <summary>There was no program in the slot before.</summary>
    public const string NothingBefore = "nothing-before";

    /// <summary>The slot has another correction, or a transfer to it is in progress.</summary>
    public const string SlotTaken = "slot-taken";

    /// <summary>The slot's program is not the one to be reverted.</summary>
    public const string ChangedAtMachine = CellCodes.ChangedAtMachine;

    /// <summary>The machine runs the program, or may run it.</summary>
    public const string MachineBusy = CellCodes.MachineBusy;

    /// <summary>The machine started the program while it was being replaced.</summary>
    public const string StartedMeanwhile = CellCodes.StartedMeanwhile;

    /// <summary>There is no such alarm now.</summary>
    public const string UnknownAlarm = "unknown-alarm";

    /// <summary>An alarm of high priority cannot be shelved.</summary>
    public const string StaysInSight = "stays-in-sight";

    /// <summary>Stable code.</summary>
    public string Code => code;
}
