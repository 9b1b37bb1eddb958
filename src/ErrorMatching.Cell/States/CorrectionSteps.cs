namespace ErrorMatching.Cell;

/// <summary>The table of states and allowed steps. Any other step is rejected.</summary>
internal static class CorrectionSteps
{
    private static readonly Dictionary<CorrectionState, CorrectionState[]> Table = new()
    {
        [CorrectionState.Archived] = [CorrectionState.Recognized, CorrectionState.Refused, CorrectionState.Failed],
        [CorrectionState.Recognized] = [
            CorrectionState.Computed, CorrectionState.Recorded, CorrectionState.Refused, CorrectionState.Failed],
        [CorrectionState.Computed] = [CorrectionState.Proposed, CorrectionState.Refused, CorrectionState.Superseded],
        [CorrectionState.Proposed] = [CorrectionState.Approved, CorrectionState.Rejected, CorrectionState.Superseded],
        [CorrectionState.Approved] = [CorrectionState.Uploading, CorrectionState.Rejected, CorrectionState.Superseded],
        [CorrectionState.Uploading] = [CorrectionState.Verified, CorrectionState.Approved, CorrectionState.Failed],
        [CorrectionState.Verified] = [CorrectionState.Released, CorrectionState.Reverted],
        [CorrectionState.Released] = [CorrectionState.Reverted],
        [CorrectionState.Failed] = [CorrectionState.Approved, CorrectionState.Rejected, CorrectionState.Superseded],
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
