using System.CommandLine;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary><c>errormatch cell check</c>.</summary>
internal sealed class CellCheckVerb() : CellVerb(
    "check",
    "Says everything that is wrong in a cell's configuration, or what would happen: whose the waiting files are, whether each machine "
        + "lets the cell in, whether each job could start. Nothing is taken or sent, and at machines nothing is changed.",
    "errormatch cell check samples/cell/cell.json")
{
    protected override VerbResult Run(CellSettings settings, ParseResult arguments, CancellationToken cancellation)
    {
        cancellation.ThrowIfCancellationRequested();
        return new CellCheckAnswer(settings, CellCheck.OfAsync(settings, cancellation).GetAwaiter().GetResult());
    }
}
