using System.CommandLine;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary><c>errormatch cell status</c>.</summary>
internal sealed class CellStatusVerb() : CellVerb(
    "status",
    "Says how a cell is, what waits, and what to do next. Ends with 0 if it is well, with 3 if something needs help.",
    "errormatch cell status samples/cell/cell.json")
{
    protected override VerbResult Run(CellSettings settings, ParseResult arguments, CancellationToken cancellation) =>
        WithStoreToRead(settings, store =>
        {
            var status = CellStatus.Of(settings, store, TimeProvider.System);

            // A cell that does not run counts nothing, and misses nothing.
            return new CellStatusAnswer(settings, status.IsRunning ? status : status with
            {
                Backlog = GaugeBacklog.Of(settings, store, TimeProvider.System),
                MissingArchives = store.MissingArchives(),
            });
        });
}
