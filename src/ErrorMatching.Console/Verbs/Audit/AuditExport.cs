using System.CommandLine;
using System.Security.Cryptography;
using System.Text;
using ErrorMatching.Cell;
using ErrorMatching.Jobs;

namespace ErrorMatching.Console;

/// <summary><c>errormatch audit export</c>.</summary>
internal sealed class AuditExport : CellVerb
{
    private const int BufferLength = 64 * 1024;
    private readonly Option<string> _out = FileOption("--out", "The CSV file to write; without it, the entries go to standard output.");

    public AuditExport()
        : base(
            "export",
            "Writes the audit trail as CSV that no spreadsheet executes.",
            "errormatch audit export samples/cell/cell.json --out out/audit.csv") =>
            Options.Add(_out);

    protected override VerbResult Run(CellSettings settings, ParseResult arguments, CancellationToken cancellation)
    {
        DemandStore(settings);
        using var store = CellStore.OpenToRead(settings.Store, TimeProvider.System, AuditKey.Find(settings.KeysFolder));
        using var progress = new CellProgressLine(ProgressTo);
        var trail = new AuditTrail(store, settings);
        if (arguments.GetValue(_out) is { } file)
        {
            var (written, hash) = (0L, "");
            OutputFile.Write(file, stream => (written, hash) = Export(stream), [settings.File], cancellation);
            return new AuditExportAnswer(written, hash, file, null);
        }

        // All or nothing: a failure halfway must not leave half of the entries printed.
        var kept = Unnamed();
        var (entries, sha256) = Export(kept);
        return new AuditExportAnswer(entries, sha256, null, kept);

        (long Entries, string Sha256) Export(Stream stream)
        {
            using var sums = SHA256.Create();
            using var hashed = new CryptoStream(stream, sums, CryptoStreamMode.Write, leaveOpen: true);
            using var csv = new StreamWriter(hashed, new UTF8Encoding(encoderShouldEmitUTF8Identifier: false), BufferLength);
            var count = trail.Export(csv, progress, cancellation);
            csv.Flush();
            hashed.FlushFinalBlock();
            return (count, Convert.ToHexStringLower(sums.Hash!));
        }
    }

    // A file that no other process can open, and that disappears with the process, however it ends.
    private static FileStream Unnamed()
    {
        var path = Path.Combine(Path.GetTempPath(), "errormatch-" + Path.GetRandomFileName());
        var options = new FileStreamOptions
        {
            Mode = FileMode.CreateNew,
            Access = FileAccess.ReadWrite,
            Share = FileShare.None,
            Options = FileOptions.DeleteOnClose
        };
        if (OperatingSystem.IsWindows())
        {
            return new(path, options);
        }

        options.UnixCreateMode = UnixFileMode.UserRead | UnixFileMode.UserWrite;
        var stream = new FileStream(path, options);
        File.Delete(path);
        return stream;
    }
}
