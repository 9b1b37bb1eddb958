using System.CommandLine;
using ErrorMatching.Cell;
using ErrorMatching.Refusals;

namespace ErrorMatching.Console;

/// <summary><c>errormatch cell backup</c>.</summary>
internal sealed class CellBackup : CellVerb
{
    private readonly Argument<string> _file = new("FILE") { Description = "The copy; it must not be there yet." };

    public CellBackup()
        : base(
            "backup",
            "Copies the whole store, as it is at one moment, while the cell goes on.",
            "errormatch cell backup samples/cell/cell.json out/cell-backup.db") =>
            Arguments.Add(_file);

    protected override VerbResult Run(CellSettings settings, ParseResult arguments, CancellationToken cancellation) =>
        WithExistingStore(settings, store =>
    {
        var file = arguments.GetRequiredValue(_file);
        if (File.Exists(file))
        {
            return new Failure(
                ExitCode.WrongInput,
                new Refusal(
                    "output-exists",
                    $"{file} is there already: a backup replaces nothing. Name another file.",
                    new() { File = file }));
        }

        Directory.CreateDirectory(Path.GetDirectoryName(Path.GetFullPath(file))!);
        using (var progress = new CellProgressLine(ProgressTo))
        {
            store.Backup(file, progress, cancellation);
        }

        return new CellFileAnswer(
            "backup",
            file,
            $"The store is copied to {file}, {new FileInfo(file).Length} bytes. Keep it with the folder of the keys, "
                + $"{settings.KeysFolder}.");
    });
}
