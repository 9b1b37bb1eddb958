using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary><c>errormatch cell approve</c>.</summary>
internal sealed class CellApprove() : CellDecisionVerb(
    "approve",
    "Lets a correction that waits, or failed at its machine, go to the machine. A setter signs.",
    "errormatch cell approve samples/cell/cell.json 1 --user anna",
    needsReason: false)
{
    protected override Act Act => Act.Approve;

    protected override VerbResult Decide(
        CellSettings settings, CellStore store, long id, string by, string? reason, CancellationToken cancellation) =>
        new CellDecisionAnswer(
            "approve",
            new CorrectionDecisions(store).Approve(id, by, reason),
            "is approved and goes to its machine as soon as its slot is free");
}
