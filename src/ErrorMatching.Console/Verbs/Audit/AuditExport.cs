using System.CommandLine;
using System.Globalization;
using System.Text;
using ErrorMatching.Cell;
using ErrorMatching.Jobs;

namespace ErrorMatching.Console;

/// <summary><c>errormatch audit export</c>.</summary>
internal sealed class AuditExport : CellVerb
{
    private readonly Option<string> _out = FileOption("--out", "The CSV file to write; without it, the entries go to standard output.");

    /// <summary>The verb.</summary>
    public AuditExport()
        : base("export", "Writes the audit trail as CSV that no spreadsheet executes.", "errormatch audit export samples/cell/cell.json --out out/audit.csv") => Options.Add(_out);

    /// <inheritdoc/>
    protected override Outcome Run(CellSettings settings, ParseResult arguments, CancellationToken cancellation)
    {
        DemandStore(settings);
        using var store = CellStore.OpenToRead(settings.Store, TimeProvider.System, AuditKey.Find(settings.KeysFolder));
        using var csv = new StringWriter(CultureInfo.InvariantCulture);
        long entries;
        using (var progress = new ProgressLine(ProgressTo))
        {
            entries = new AuditTrail(store, settings.KeysFolder).Export(csv, progress, cancellation);
        }

        if (arguments.GetValue(_out) is not { } file)
        {
            return new AuditExportAnswer(csv.ToString(), entries, null);
        }

        OutputFile.Write(file, Encoding.UTF8.GetBytes(csv.ToString()), [settings.File], cancellation);
        return new AuditExportAnswer(csv.ToString(), entries, file);
    }
}
