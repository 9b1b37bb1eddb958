using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>One step of a correction.</summary>
/// <param name="Correction">Its number.</param>
/// <param name="From">The state before; null for the arrival.</param>
/// <param name="To">The state after.</param>
/// <param name="At">When.</param>
/// <param name="By">The user's name, or <c>cell</c> for what the cell does by its policy.</param>
/// <param name="Basis">The basis: the policy's rule, a person's reason, the machine's response.</param>
public sealed record CorrectionStep(long Correction, CorrectionState? From, CorrectionState To, DateTimeOffset At, string By,
    Statement Basis);
