using System.CommandLine;
using ErrorMatching.Cell;

namespace ErrorMatching.Console;

/// <summary><c>errormatch cell restore</c>.</summary>
internal sealed class CellRestore : CellVerb
{
    private readonly Argument<string> _file = new("FILE") { Description = "The copy that cell backup made." };

    public CellRestore()
        : base(
            "restore",
            "Puts a copy of the store in the store's place, while the cell does not run. What was there is kept beside it.",
            "errormatch cell restore samples/cell/cell.json out/cell-backup.db") =>
            Arguments.Add(_file);

    protected override VerbResult Run(CellSettings settings, ParseResult arguments, CancellationToken cancellation)
    {
        var file = arguments.GetRequiredValue(_file);
        var by = SystemUser.Name(Environment.GetEnvironmentVariable);
        string? kept;
        using (var progress = new CellProgressLine(ProgressTo))
        {
            kept = CellStore.Restore(
                settings.Store, file, TimeProvider.System, by, AuditKey.Open(settings.KeysFolder), progress, cancellation);
        }

        using (var store = CellStore.Open(settings.Store, TimeProvider.System, AuditKey.OpenFor(settings), inspect: false))
        {
            new AuditTrail(store, settings).TakeOver(by, Recorded.BackupBroughtBack.With(file));
        }

        return new CellFileAnswer(
            "restore",
            file,
            $"The store is the one of {file} again.{(kept is null ? "" : $" What was there is {kept}.")} Start the cell: programs at "
                + $"machines that this store does not know are not overwritten without a setter.");
    }
}
