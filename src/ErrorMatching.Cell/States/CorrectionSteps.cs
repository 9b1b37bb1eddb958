using Serilog.Events;

namespace ErrorMatching.Cell;

/// <summary>The life of a correction: the table of states, with what is true of a correction in each and the allowed steps, each with
/// the worker or decision that takes it. Any other step is rejected.</summary>
/// <remarks>A correction begins as archived: its file arrived (<see cref="SourceWorker"/>), or it recalculates an earlier one
/// (<see cref="Recalculation"/>). A file that is too large to be stored begins as refused. A worker finds its work in the store by state,
/// so that any process can take the next step.</remarks>
public static class CorrectionSteps
{
    private static readonly Dictionary<CorrectionState, StateRow> Table = new()
    {
        [CorrectionState.Archived] = new(
            Level: LogEventLevel.Debug, TakenBy: StateWorker.Recognize, MayBegin: true, IsInLine: true, IsUndecided: false,
            NamesProgram: false, HasSlot: false, WaitsForRelease: false, IsSent: false,
            IsSettled: false, IsSetAside: false, EndsTampered: false,
            To:
            [
                CorrectionState.Recognized, // RecognizeWorker.Begin
                CorrectionState.Refused, // RecognizeWorker.Refuse
                CorrectionState.Failed, // CellFlow.FailingAlone
            ]),
        [CorrectionState.Recognized] = new(
            Level: LogEventLevel.Debug, TakenBy: StateWorker.Compute, MayBegin: false, IsInLine: true, IsUndecided: false,
            NamesProgram: false, HasSlot: false, WaitsForRelease: false, IsSent: false,
            IsSettled: false, IsSetAside: false, EndsTampered: false,
            To:
            [
                CorrectionState.Computed, // ComputeWorker.Keep
                CorrectionState.Recorded, // ComputeWorker.Record
                CorrectionState.Refused, // ComputeWorker.Refuse
                CorrectionState.Failed, // ComputeWorker.Compute, CellFlow.FailingAlone
            ]),
        [CorrectionState.Computed] = new(
            Level: LogEventLevel.Debug, TakenBy: StateWorker.Propose, MayBegin: false, IsInLine: true, IsUndecided: false,
            NamesProgram: false, HasSlot: false, WaitsForRelease: false, IsSent: false,
            IsSettled: false, IsSetAside: false, EndsTampered: false,
            To:
            [
                CorrectionState.Proposed, // ProposeWorker.Propose
                CorrectionState.Refused, // ProposeWorker.Propose, ProposeWorker.WorkAsync
                CorrectionState.Superseded, // ProposeWorker.Supersede
            ]),
        [CorrectionState.Proposed] = new(
            Level: LogEventLevel.Information, TakenBy: StateWorker.Propose, MayBegin: false, IsInLine: true, IsUndecided: true,
            NamesProgram: true, HasSlot: false, WaitsForRelease: false, IsSent: false,
            IsSettled: false, IsSetAside: false, EndsTampered: false,
            To:
            [
                CorrectionState.Approved, // ProposeWorker.ApproveByPolicy, CorrectionDecisions.Approve
                CorrectionState.Rejected, // CorrectionDecisions.Reject
                CorrectionState.Superseded, // ProposeWorker.Supersede, Recalculation.Recalculate
            ]),
        [CorrectionState.Approved] = new(
            Level: LogEventLevel.Debug, TakenBy: StateWorker.Slot, MayBegin: false, IsInLine: true, IsUndecided: false,
            NamesProgram: true, HasSlot: false, WaitsForRelease: false, IsSent: false,
            IsSettled: false, IsSetAside: false, EndsTampered: false,
            To:
            [
                CorrectionState.Uploading, // SlotWorker.TakeAsync
                CorrectionState.Rejected, // CorrectionDecisions.Reject
                CorrectionState.Superseded, // ProposeWorker.Supersede, Recalculation.Recalculate
            ]),
        [CorrectionState.Uploading] = new(
            Level: LogEventLevel.Debug, TakenBy: StateWorker.Slot, MayBegin: false, IsInLine: false, IsUndecided: false,
            NamesProgram: true, HasSlot: true, WaitsForRelease: false, IsSent: false,
            IsSettled: false, IsSetAside: false, EndsTampered: false,
            To:
            [
                CorrectionState.Verified, // SlotWorker.Verify
                CorrectionState.Approved, // SlotWorker.GiveBackAsync
                CorrectionState.Failed, // SlotWorker.Fail
            ]),
        [CorrectionState.Verified] = new(
            Level: LogEventLevel.Information, TakenBy: null, MayBegin: false, IsInLine: false, IsUndecided: false,
            NamesProgram: true, HasSlot: true, WaitsForRelease: true, IsSent: true,
            IsSettled: false, IsSetAside: false, EndsTampered: false,
            To:
            [
                CorrectionState.Released, // HeldProgram.LookForReadyAsync, CorrectionDecisions.Release
                CorrectionState.Reverted, // SlotReversal.RevertAsync
            ]),
        [CorrectionState.Released] = new(
            Level: LogEventLevel.Information, TakenBy: null, MayBegin: false, IsInLine: false, IsUndecided: false,
            NamesProgram: true, HasSlot: false, WaitsForRelease: false, IsSent: true,
            IsSettled: true, IsSetAside: false, EndsTampered: false,
            To:
            [
                CorrectionState.Reverted, // SlotReversal.RevertAsync
            ]),
        [CorrectionState.Failed] = new(
            Level: LogEventLevel.Error, TakenBy: null, MayBegin: false, IsInLine: true, IsUndecided: true,
            NamesProgram: false, HasSlot: false, WaitsForRelease: false, IsSent: false,
            IsSettled: false, IsSetAside: false, EndsTampered: false,
            To:
            [
                CorrectionState.Approved, // CorrectionDecisions.Approve
                CorrectionState.Rejected, // CorrectionDecisions.Reject
                CorrectionState.Superseded, // ProposeWorker.Supersede, Recalculation.Recalculate
            ]),
        [CorrectionState.Superseded] = new(
            Level: LogEventLevel.Warning, TakenBy: null, MayBegin: false, IsInLine: false, IsUndecided: false,
            NamesProgram: false, HasSlot: false, WaitsForRelease: false, IsSent: false,
            IsSettled: true, IsSetAside: true, EndsTampered: true,
            To: []),
        [CorrectionState.Recorded] = new(
            Level: LogEventLevel.Information, TakenBy: null, MayBegin: false, IsInLine: false, IsUndecided: false,
            NamesProgram: false, HasSlot: false, WaitsForRelease: false, IsSent: false,
            IsSettled: true, IsSetAside: false, EndsTampered: false,
            To: []),
        [CorrectionState.Refused] = new(
            Level: LogEventLevel.Warning, TakenBy: null, MayBegin: true, IsInLine: false, IsUndecided: false,
            NamesProgram: false, HasSlot: false, WaitsForRelease: false, IsSent: false,
            IsSettled: true, IsSetAside: false, EndsTampered: true,
            To: []),
        [CorrectionState.Rejected] = new(
            Level: LogEventLevel.Warning, TakenBy: null, MayBegin: false, IsInLine: false, IsUndecided: false,
            NamesProgram: false, HasSlot: false, WaitsForRelease: false, IsSent: false,
            IsSettled: true, IsSetAside: true, EndsTampered: true,
            To: []),
        [CorrectionState.Reverted] = new(
            Level: LogEventLevel.Warning, TakenBy: null, MayBegin: false, IsInLine: false, IsUndecided: false,
            NamesProgram: true, HasSlot: false, WaitsForRelease: true, IsSent: false,
            IsSettled: true, IsSetAside: false, EndsTampered: false,
            To: []),
    };

    /// <summary>The states that one step leads to.</summary>
    public static IReadOnlyList<CorrectionState> From(CorrectionState state) => Table[state].To;

    /// <summary>The states from which one step leads to a state.</summary>
    public static IReadOnlyList<CorrectionState> Before(CorrectionState to) => Where(r => r.To.Contains(to));

    /// <summary>True if the step is allowed.</summary>
    public static bool Allows(CorrectionState from, CorrectionState to) => Table[from].To.Contains(to);

    /// <summary>True if no step leads out of the state.</summary>
    public static bool IsEnd(CorrectionState state) => Table[state].To is [];

    /// <summary>The row of a state.</summary>
    internal static StateRow Of(CorrectionState state) => Table[state];

    /// <summary>The states of some rows, in the order of the enumeration.</summary>
    internal static IReadOnlyList<CorrectionState> Where(Func<StateRow, bool> isMeant) =>
        [.. Enum.GetValues<CorrectionState>().Where(s => isMeant(Table[s]))];
}

/// <summary>What is true of every correction in a state. A new state answers each question that a place of the cell, the console or the
/// station asks.</summary>
/// <param name="Level">How loudly a step to it is logged.</param>
/// <param name="TakenBy">The worker that takes it from here, so it is woken; null if the cell waits for a machine or a person, or for
/// nothing. Then the slot's worker is woken: the line that it was in may move.</param>
/// <param name="MayBegin">True if an arrival may have it.</param>
/// <param name="IsInLine">True if it is in line for its slot. One that failed is only if it has a program.</param>
/// <param name="IsUndecided">True if it waits for a person's decision, and in line nobody overtakes it.</param>
/// <param name="NamesProgram">True if the audit entry of a step to it names the computed program.</param>
/// <param name="HasSlot">True if it has its slot.</param>
/// <param name="WaitsForRelease">True if, while it has its slot, an operator may free it.</param>
/// <param name="IsSent">True if its program was verified at the machine and not reverted.</param>
/// <param name="IsSettled">True if nobody waits for it any more: what it names may be archived, and its row is compared with the trail
/// once.</param>
/// <param name="IsSetAside">True if a person or a newer measurement decided against it, so that its piece does not count.</param>
/// <param name="EndsTampered">True if a step to it may start from a row that somebody else wrote: this is how a person gets rid of
/// it.</param>
/// <param name="To">The states that one step leads to.</param>
internal sealed record StateRow(
    LogEventLevel Level,
    StateWorker? TakenBy,
    bool MayBegin,
    bool IsInLine,
    bool IsUndecided,
    bool NamesProgram,
    bool HasSlot,
    bool WaitsForRelease,
    bool IsSent,
    bool IsSettled,
    bool IsSetAside,
    bool EndsTampered,
    CorrectionState[] To)
{
    /// <summary>True if it has arrived and is not computed yet.</summary>
    public bool IsInWork => TakenBy is StateWorker.Recognize or StateWorker.Compute;
}

/// <summary>The workers that take corrections on by their state.</summary>
internal enum StateWorker
{
    /// <summary>Determines the piece and the job.</summary>
    Recognize,

    /// <summary>Makes the program.</summary>
    Compute,

    /// <summary>Proposes, and approves by the policy.</summary>
    Propose,

    /// <summary>Sends it to its slot.</summary>
    Slot,
}
