using System.Globalization;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary><c>errormatch cell again</c>: people and scripts know the verb by this name, so that it stays.</summary>
internal sealed class CellRecalculate() : CellDecisionVerb(
    "again",
    "Computes a correction anew that was made before its job was changed: from the measurement that is kept, in the same place in line. "
        + "An operator signs.",
    "errormatch cell again samples/cell/cell.json 2 --user anna",
    needsReason: false)
{
    protected override Act Act => Act.Reject;

    protected override VerbResult Decide(
        CellSettings settings, CellStore store, long id, string by, string? reason, CancellationToken cancellation) =>
        new CellDecisionAnswer(
            "again",
            new Recalculation(settings, store).Recalculate(id, by, reason),
            string.Create(
                CultureInfo.InvariantCulture,
                $"is computed in the place of correction {id}, which is superseded, with the job as it is now"));
}
