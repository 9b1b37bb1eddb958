using ErrorMatching.Cell;
using ErrorMatching.Jobs;
using ErrorMatching.Json;
using ErrorMatching.Refusals;

namespace ErrorMatching.Hmi;

/// <content>The dry run: the draft's result for a measurement. Nothing is saved or sent.</content>
public sealed partial class SystemViewModel
{
    private const int Latest = 1000;
    private CorrectionDetail? _detail;

    /// <summary>The result of the dry run; null while none is shown.</summary>
    public CorrectionDetail? Detail
    {
        get => _detail;
        private set
        {
            if (Set(ref _detail, value))
            {
                Say(nameof(IsForm));
                Say(nameof(DryRunDoubt));
            }
        }
    }

    /// <summary>True while the form is shown instead of a dry run.</summary>
    public bool IsForm => Detail is null;

    /// <summary>Warning that the dry run probably used a drawing: every point is exactly as designed, which no measurement is. Null
    /// otherwise.</summary>
    public string? DryRunDoubt =>
        Detail?.Kept is { Report: { KeyPoints.Count: > 0 } report, Correction.FileName: var file }
            && report.KeyPoints.All(p => p.Actual == p.Theoretical)
            ? Texts.Current.With("System.DryRunDrawing", file)
            : null;

    /// <summary>Tries the draft with the job's last measurement in the store.</summary>
    public LongCommand DryRun { get; }

    public LongCommand DryRunFile { get; }

    public Command Back { get; }

    protected override void Translate()
    {
        Detail = Detail is null ? null : new(Detail.Kept, Station.Clock);

        // Rows are recreated in the new language; picking blocks for a feature continues.
        var picked = _picked;
        base.Translate();
        _picked = picked;
        ShowPicture();
    }

    private bool CanTry() => Editing.Job is not null && Editing.Problems.Count == 0 && Editing.IsChecked;

    private async Task DryRunAsync(CancellationToken cancellation)
    {
        Editing.ForgetNotice();
        var piece = Editing.Draft.Compensation.From;
        (Correction Correction, byte[] Bytes, GivenFile? Part)? last = null;
        var job = Editing.Place!;
        if (!await TryAsync(() =>
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
            Show();
        }
        else if (last is { } found)
        {
            await TryOutAsync(found.Correction, new(found.Correction.FileName, found.Bytes), found.Part, cancellation);
        }
        else
        {
            Tell(() => Texts.Current["System.NoMeasurement"]);
            Show();
        }
    }

    private async Task DryRunFileAsync(CancellationToken cancellation)
    {
        if (await DryRunFile.AskAsync(() => Shell.ChooseAsync(
            new(FileChoiceKind.Open, "System.ChooseMeasurement", [".csv", ".txt"]) { Sample = DemoCell.PartFile })) is not { } path)
        {
            return;
        }

        Editing.ForgetNotice();
        byte[] bytes = [];
        if (await TryAsync(() => bytes = InputFile.Bytes(path, JsonLimits.Default.MaxBytes)))
        {
            var name = Path.GetFileName(path);
            var given = new Correction(0, CorrectionState.Computed, 0, "", name, Station.Clock.GetUtcNow(), "", bytes.Length)
            {
                Job = Editing.Place!.Name
            };
            await TryOutAsync(given, new(name, bytes), null, cancellation);
        }

        Show();
    }

    private async Task TryOutAsync(Correction correction, GivenFile measurement, GivenFile? part, CancellationToken cancellation)
    {
        var (draft, job) = (Editing.Draft, Editing.Job!);
        var isOfPart = draft.Compensation.From == "part";
        var request = new MatingRequest
        {
            Part = isOfPart ? measurement : part,
            Counterpart = isOfPart ? null : measurement,
            Gain = (job.Policy ?? Station.Settings.Policy).Gain
        };
        StoredCorrection? kept = null;
        Func<string>? refusal = null;
        await TryAsync(() =>
        {
            try
            {
                var outcome = MatingDraftRun.Of(draft, job.File, request, cancellation);
                refusal = outcome.Result is null
                    ? () => Sentence.Joined(outcome.Refusals.Select(r => CodeText.Of(r.Code, r.Message)))
                    : null;
                kept = outcome.Result is { } matched ? Kept(correction, matched) : null;
            }
            catch (InputException e)
            {
                refusal = () => Sentence.Joined(e.Refusals.Select(r => CodeText.Of(r.Code, r.Sentence)));
            }
        });
        if (refusal is not null)
        {
            Tell(() => Texts.Current.With("System.DryRunRefused", refusal()));
        }

        Detail = kept is null ? null : new(kept, Station.Clock);
        Show();
    }

    private static StoredCorrection Kept(Correction correction, MatchedProgram matched)
    {
        // Rounded as a stored report is, so that the figures can be compared with those.
        var report = StoredReport.Read(matched.ReportJson()).Match!;

        // The stored result was computed with the previous job; show the figures of the dry run.
        var move = LargestMove.Of(matched);
        var computed = correction with { State = CorrectionState.Computed, Code = null, Reason = null, LargestMm = move.Mm };
        return new(computed, [], report, new(matched.Match.Input.Program, matched.Program, report.Program.Blocks, report.Proof.Marker))
        {
            TriedAt = move.At
        };
    }
}
