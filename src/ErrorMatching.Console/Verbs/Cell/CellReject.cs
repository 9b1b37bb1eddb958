using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary><c>errormatch cell reject</c>.</summary>
internal sealed class CellReject() : CellDecisionVerb(
    "reject",
    "Decides against a correction that is not at its machine. An operator signs.",
    "errormatch cell reject samples/cell/cell.json 1 --user anna --reason remeasured",
    needsReason: true)
{
    protected override Act Act => Act.Reject;

    protected override VerbResult Decide(
        CellSettings settings, CellStore store, long id, string by, string? reason, CancellationToken cancellation) =>
        new CellDecisionAnswer("reject", new CorrectionDecisions(store).Reject(id, by, reason!), "is rejected");
}
