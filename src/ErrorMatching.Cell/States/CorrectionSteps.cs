namespace ErrorMatching.Cell;

/// <summary>The life of a correction: the table of states and allowed steps, each with the worker or decision that takes it. Any other
/// step is rejected.</summary>
/// <remarks>A correction begins as archived: its file arrived (<see cref="SourceWorker"/>), or it recalculates an earlier one
/// (<see cref="Recalculation"/>). A file that is too large to be stored begins as refused. A worker finds its work in the store by state,
/// so that any process can take the next step.</remarks>
internal static class CorrectionSteps
{
    private static readonly Dictionary<CorrectionState, CorrectionState[]> Table = new()
    {
        [CorrectionState.Archived] =
        [
            CorrectionState.Recognized, // RecognizeWorker.Begin
            CorrectionState.Refused, // RecognizeWorker.Refuse
            CorrectionState.Failed, // CellFlow.FailingAlone
        ],
        [CorrectionState.Recognized] =
        [
            CorrectionState.Computed, // ComputeWorker.Keep
            CorrectionState.Recorded, // ComputeWorker.Record
            CorrectionState.Refused, // ComputeWorker.Refuse
            CorrectionState.Failed, // ComputeWorker.Compute, CellFlow.FailingAlone
        ],
        [CorrectionState.Computed] =
        [
            CorrectionState.Proposed, // ProposeWorker.Propose
            CorrectionState.Refused, // ProposeWorker.Propose, ProposeWorker.WorkAsync
            CorrectionState.Superseded, // ProposeWorker.Supersede
        ],
        [CorrectionState.Proposed] =
        [
            CorrectionState.Approved, // ProposeWorker.ApproveByPolicy, CorrectionDecisions.Approve
            CorrectionState.Rejected, // CorrectionDecisions.Reject
            CorrectionState.Superseded, // ProposeWorker.Supersede, Recalculation.Recalculate
        ],
        [CorrectionState.Approved] =
        [
            CorrectionState.Uploading, // SlotWorker.TakeAsync
            CorrectionState.Rejected, // CorrectionDecisions.Reject
            CorrectionState.Superseded, // ProposeWorker.Supersede, Recalculation.Recalculate
        ],
        [CorrectionState.Uploading] =
        [
            CorrectionState.Verified, // SlotWorker.Verify
            CorrectionState.Approved, // SlotWorker.GiveBackAsync
            CorrectionState.Failed, // SlotWorker.Fail
        ],
        [CorrectionState.Verified] =
        [
            CorrectionState.Released, // HeldProgram.LookForReadyAsync, CorrectionDecisions.Release
            CorrectionState.Reverted, // SlotReversal.RevertAsync
        ],
        [CorrectionState.Released] =
        [
            CorrectionState.Reverted, // SlotReversal.RevertAsync
        ],
        [CorrectionState.Failed] =
        [
            CorrectionState.Approved, // CorrectionDecisions.Approve
            CorrectionState.Rejected, // CorrectionDecisions.Reject
            CorrectionState.Superseded, // ProposeWorker.Supersede, Recalculation.Recalculate
        ],
        [CorrectionState.Superseded] = [],
        [CorrectionState.Recorded] = [],
        [CorrectionState.Refused] = [],
        [CorrectionState.Rejected] = [],
        [CorrectionState.Reverted] = [],
    };

    /// <summary>The states that one step leads to.</summary>
    public static IReadOnlyList<CorrectionState> From(CorrectionState state) => Table[state];

    /// <summary>True if the step is allowed.</summary>
    public static bool Allows(CorrectionState from, CorrectionState to) => Table[from].Contains(to);

    /// <summary>True if no step leads out of the state.</summary>
    public static bool IsEnd(CorrectionState state) => Table[state].Length == 0;
}
