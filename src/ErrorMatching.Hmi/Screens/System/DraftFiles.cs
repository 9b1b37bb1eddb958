using System.Text;
using ErrorMatching.Jobs;
using ErrorMatching.Measurement;

namespace ErrorMatching.Hmi;

/// <summary>Takes files and pasted tables into the draft: the coordinates of its points, and its program.</summary>
internal sealed class DraftFiles
{
    private readonly SystemViewModel _screen;
    private readonly ShellViewModel _shell;

    /// <summary>Takes nothing yet.</summary>
    /// <param name="screen">The screen that tells the result.</param>
    /// <param name="shell">Lets the user choose a file.</param>
    public DraftFiles(SystemViewModel screen, ShellViewModel shell)
    {
        (_screen, _shell) = (screen, shell);
        ReadPoints = new(_ => ReadPointsAsync(), () => Editing.CanEdit);
        ReadProgram = new(
            async _ => await ReadAsync(FileChoice.OfProgram(DemoCell.ProgramFile), ImportProgramAsync),
            () => Editing.CanEdit);
    }

    public LongCommand ReadPoints { get; }

    public LongCommand ReadProgram { get; }

    private JobEditing Editing => _screen.Editing;

    public void Paste(string? text)
    {
        if (Editing.CanEdit)
        {
            Take(PointTable.Read(text ?? ""));
        }
    }

    public async Task ImportProgramAsync(string path)
    {
        DraftProgram? program = null;
        if (await _screen.TryAsync(() => program = DraftProgram.Of(InputFile.Program(path))))
        {
            Editing.Change("", d => MatingDraftBlocks.WithProgram(d, program!, Path.GetFileName(path)));
        }
    }

    private async Task ImportPointsAsync(string path)
    {
        PointTable? table = null;
        if (await _screen.TryAsync(
            () => table = PointTable.Read(
                Encoding.UTF8.GetString(InputFile.Bytes(path, MeasurementFormat.Points.MaxBytes)).TrimStart('\uFEFF'))))
        {
            Take(table!, Path.GetFileName(path));
        }
    }

    private async Task ReadAsync(FileChoice choice, Func<string, Task> import)
    {
        if (await _shell.ChooseAsync(choice) is { } path)
        {
            await import(path);
        }
    }

    // Without features, do not ask for a file.
    private async Task ReadPointsAsync()
    {
        if (_screen.NeedsFeatures)
        {
            _screen.Report(() => Texts.Current["System.NoFeatures"]);
            _screen.Show();
            return;
        }

        await ReadAsync(
            new(FileChoiceKind.Open, "System.ChooseDrawing", [".csv", ".txt"]) { Sample = DemoCell.DrawingFile }, ImportPointsAsync);
    }

    private void Take(PointTable table, string? file = null)
    {
        var taken = table.Into(Editing.Draft);
        Editing.Change("", _ => taken.Draft);
        var refused = TableText.Refused(table, taken);
        _screen.Report(refused);

        // Clear the note on the previous table even if nothing was taken from this one.
        Editing.Note(refused is not null ? null : () => Sentence.Joined(
            file is not null && IsMeasurement(file) ? Texts.Current.With("System.TableMeasured", file) : "",
            TableText.Taken(table, taken)));

        _screen.Show();
    }

    // A measurement has the format of a drawing but must not be used as one. The job names its measurements.
    private bool IsMeasurement(string file) =>
        new[]
        {
            Editing.Draft[DraftPaths.Measured],
            Editing.Draft[DraftPaths.CounterpartMeasured]
        }.Any(m => string.Equals(Path.GetFileName(m.Trim()), file, StringComparison.OrdinalIgnoreCase));
}
