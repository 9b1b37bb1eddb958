using ErrorMatching.Cell;
using ErrorMatching.Jobs;
using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Refusals;

namespace ErrorMatching.Hmi;

/// <summary>The dry run: the draft's result for a measurement. Nothing is saved or sent.</summary>
internal sealed class DryRunning
{
    // Number of corrections in which the job's last measurement is searched.
    private const int Latest = 1000;
    private readonly SystemViewModel _screen;
    private readonly ShellViewModel _shell;
    private CorrectionDetail? _detail;

    /// <summary>Nothing was tried yet.</summary>
    /// <param name="screen">The screen that shows the result.</param>
    /// <param name="shell">Lets the user choose a measurement.</param>
    public DryRunning(SystemViewModel screen, ShellViewModel shell)
    {
        (_screen, _shell) = (screen, shell);
        Last = new(LastAsync, CanTry);
        File = new(FileAsync, CanTry);
    }

    /// <summary>Raised when there is another <see cref="Detail"/>.</summary>
    public event Action? Shown;

    /// <summary>The result; null while none is shown.</summary>
    public CorrectionDetail? Detail
    {
        get => _detail;
        set
        {
            if (_detail != value)
            {
                _detail = value;
                Shown?.Invoke();
            }
        }
    }

    /// <summary>Warning that the dry run probably used a drawing: every point is exactly as designed, which no measurement is. Null
    /// otherwise.</summary>
    public string? Doubt =>
        Detail?.Stored is { Report: { KeyPoints.Count: > 0 } report, Correction.FileName: var file }
            && report.KeyPoints.All(p => p.Actual == p.Theoretical)
            ? Texts.Current.With("System.DryRunDrawing", file)
            : null;

    /// <summary>Tries the draft with the job's last measurement in the store.</summary>
    public LongCommand Last { get; }

    /// <summary>Tries the draft with a measurement that the user chooses.</summary>
    public LongCommand File { get; }

    private JobEditing Editing => _screen.Editing;

    private Station Station => _screen.Station;

    /// <summary>Shows the result in the language of the screen.</summary>
    public void Translate() => Detail = Detail is null ? null : new(Detail.Stored, Station.Clock);

    private bool CanTry() => Editing.Job is not null && Editing.Problems.Count == 0 && Editing.IsChecked;

    private async Task LastAsync(CancellationToken cancellation)
    {
        Editing.ForgetNotice();
        var piece = Editing.Draft.Word(DraftPaths.From);
        (Correction Correction, byte[] Bytes, GivenFile? Part)? last = null;
        var job = Editing.Place!;
        if (!await _screen.TryAsync(() =>
        {
            if (Station.Store.Search(new() { Most = Latest }).Where(c => c.Job == job.Name && c.Piece == piece).MaxBy(c => c.Turn) is { } c)
            {
                last = (
                    c,
                    Station.Store.Content(c.MeasurementSha256),
                    c.PartSha256 is { } part ? new("part.csv", Station.Store.Content(part)) : null);
            }
        }))
        {
            _screen.Show();
        }
        else if (last is { } found)
        {
            await TryOutAsync(found.Correction, new(found.Correction.FileName, found.Bytes), found.Part, cancellation);
        }
        else
        {
            _screen.Report(() => Texts.Current["System.NoMeasurement"]);
            _screen.Show();
        }
    }

    private async Task FileAsync(CancellationToken cancellation)
    {
        if (await File.AskAsync(() => _shell.ChooseAsync(
            new(FileChoiceKind.Open, "System.ChooseMeasurement", [".csv", ".txt"]) { Sample = DemoCell.PartFile })) is not { } path)
        {
            return;
        }

        Editing.ForgetNotice();
        byte[] bytes = [];
        if (await _screen.TryAsync(() => bytes = InputFile.Bytes(path, JsonLimits.Default.MaxBytes)))
        {
            var name = Path.GetFileName(path);
            var given = new Correction(0, CorrectionState.Computed, 0, "", name, Station.Clock.GetUtcNow(), "", bytes.Length)
            {
                Job = Editing.Place!.Name
            };
            await TryOutAsync(given, new(name, bytes), null, cancellation);
        }

        _screen.Show();
    }

    private async Task TryOutAsync(Correction correction, GivenFile measurement, GivenFile? part, CancellationToken cancellation)
    {
        var (draft, job) = (Editing.Draft, Editing.Job!);
        var isOfPart = draft.Word(DraftPaths.From) == "part";
        var request = new MatingRequest
        {
            Part = isOfPart ? measurement : part,
            Counterpart = isOfPart ? null : measurement,
            Gain = (job.Policy ?? Station.Settings.Policy).Gain
        };
        StoredCorrection? kept = null;
        Func<string>? refusal = null;
        await _screen.TryAsync(() =>
        {
            try
            {
                var outcome = MatingDraftRun.Run(draft, job.File, request, cancellation);
                refusal = outcome.Result is null
                    ? () => Sentence.Joined(outcome.Refusals.Select(CodeText.Of))
                    : null;
                kept = outcome.Result is { } matched ? Stored(correction, matched) : null;
            }
            catch (InputException e)
            {
                refusal = () => Sentence.Joined(e.Refusals.Select(r => CodeText.Of(r.Code, r.Sentence)));
            }
        });
        if (refusal is not null)
        {
            _screen.Report(() => Texts.Current.With("System.DryRunRefused", refusal()));
        }

        Detail = kept is null ? null : new(kept, Station.Clock);
        _screen.Show();
    }

    private static StoredCorrection Stored(Correction correction, MatchedProgram matched)
    {
        // Rounded as a stored report is, so that the figures can be compared with those.
        var report = StoredReport.Read(matched.ReportJson()).Match!;

        // The stored result was computed with the previous job; show the figures of the dry run.
        var move = LargestMove.Of(matched);
        var offset = matched.Match is { Correction: { Program: not null } choice, Input.Job.Correction: var allowed }
            && !allowed.Allows(CorrectionKind.Blocks) ? choice : null;
        var computed = correction with
        {
            State = CorrectionState.Computed,
            Code = null,
            Reason = null,
            LargestMm = move.Mm,
            Offset = offset is null ? null : RecordedOffset.Of(offset),
        };
        var lines = offset is null
            ? new ProgramLines(matched.Match.Input.Program, matched.Program, report.Program.Blocks, report.Proof.Marker)
            : new ProgramLines(offset.Program, offset.Program, []);
        return new(computed, [], report, lines)
        {
            TriedAt = move.At
        };
    }
}
