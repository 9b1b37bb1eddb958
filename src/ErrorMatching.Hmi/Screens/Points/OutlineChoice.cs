using ErrorMatching.Jobs;
using ErrorMatching.Refusals;

namespace ErrorMatching.Hmi;

/// <summary>The outline of a drawing, laid on what a program cuts, before the edited job takes it: which layer mates, and both in one
/// picture.</summary>
internal sealed class OutlineChoice : Observable
{
    private readonly JobEditing _editing;
    private readonly MatingDraft _draft;
    private readonly TimeProvider _clock;
    private readonly Action _closed;
    private OutlineRequest _request;
    private LayerChoice? _layer;
    private OutlineJob? _job;
    private Func<string>? _refused;
    private string? _otherUnit;
    private string _lower = "", _upper = "", _uncertainty = "";

    /// <summary>Shows the layers. If there is only one, it is laid on the program at once.</summary>
    /// <param name="editing">The edited job.</param>
    /// <param name="request">The drawing and the program.</param>
    /// <param name="program">The program.</param>
    /// <param name="layers">The layers of the drawing.</param>
    /// <param name="clock">For messages.</param>
    /// <param name="closed">Called when the outline was taken, or is not wanted.</param>
    public OutlineChoice(
        JobEditing editing,
        OutlineRequest request,
        OpenedProgram program,
        IReadOnlyList<OutlineLayer> layers,
        TimeProvider clock,
        Action closed)
    {
        (_editing, _draft, _request, _clock, _closed) = (editing, editing.Draft, request, clock, closed);
        Picture = new(program) { IsReadOnly = true };
        Layers = [.. layers.Select((l, i) => new LayerChoice(l, i))];
        Uncertainty = editing.Draft.Count(DraftPaths.Uncertainty) == 0 ? editing.Draft[DraftPaths.Uncertainty] : "";
        Take = new(TakeIt, () => _job is not null && editing.CanEdit);
        TakeUnit = new(TakeOtherUnit, () => _otherUnit is not null);
        Leave = new(closed);
        Layer = Layers is [var only] ? only : null;
    }

    /// <summary>The program's path, with the outline over it.</summary>
    public ProgramPicture Picture { get; }

    /// <summary>The layers, the longest outline first.</summary>
    public IReadOnlyList<LayerChoice> Layers { get; }

    /// <summary>The layer that mates; null before one is chosen.</summary>
    public LayerChoice? Layer
    {
        get => _layer;
        set
        {
            if (Set(ref _layer, value))
            {
                Laying = LayAsync().Watched();
            }
        }
    }

    /// <summary>The lower limit of all features, as typed.</summary>
    public string Lower
    {
        get => _lower;
        set => Set(ref _lower, value);
    }

    /// <summary>The upper limit of all features, as typed.</summary>
    public string Upper
    {
        get => _upper;
        set => Set(ref _upper, value);
    }

    /// <summary>The standard uncertainty of the gauge, as typed.</summary>
    public string Uncertainty
    {
        get => _uncertainty;
        set => Set(ref _uncertainty, value);
    }

    /// <summary>The gauge's uncertainty is a list in the job, which stays.</summary>
    public bool AsksUncertainty => _editing.Draft.Count(DraftPaths.Uncertainty) == 0;

    /// <summary>Name of both files.</summary>
    public string Files => Texts.Current.With("Outline.Files", Path.GetFileName(_request.Drawing), Path.GetFileName(_request.Program));

    /// <summary>What was found; before that, what to do.</summary>
    public string Found => _job is not { } job
        ? Texts.Current[_layer is null ? "Outline.ChooseLayer" : _refused is null ? "Outline.Laying" : "Outline.NotLaid"]
        : Texts.Current.With(
            "Outline.Found",
            job.Features.Count,
            Shown.Percent(100 * job.CoveredShare),
            Shown.Mm(job.RmsMm),
            Shown.Mm(job.LargestMm),
            Shown.Number(job.ToolDiameterMm));

    /// <summary>Asks whether the drawing is in another unit, in which it lies on the program; null if it is not.</summary>
    public string? OtherUnit =>
        _otherUnit is { } unit ? Texts.Current.With("Outline.TakeUnit", Texts.Current["Outline.Unit." + unit]) : null;

    /// <summary>Why the outline does not lie on the program, or null.</summary>
    public string? Refused => _refused?.Invoke();

    /// <summary>What may be otherwise; empty if nothing.</summary>
    public IReadOnlyList<string> Doubts => _job is not { } job ? [] : [
        .. job.IsToolFound ? [Texts.Current.With("Outline.ToolFound", Shown.Number(job.ToolDiameterMm))] : Array.Empty<string>(),
        .. job.IsUnitAssumed ? [Texts.Current["Outline.UnitAssumed"]] : Array.Empty<string>(),
        .. job.OtherWays > 0 ? [Texts.Current.With("Outline.OtherWays", job.OtherWays + 1)] : Array.Empty<string>()];

    /// <summary>What was passed over or left out, in the words of the reader.</summary>
    public IReadOnlyList<string> Remarks => _job?.Remarks ?? [];

    /// <summary>Puts the features into the edited job.</summary>
    public Command Take { get; }

    /// <summary>Reads the drawing in that unit.</summary>
    public Command TakeUnit { get; }

    /// <summary>Goes back without them.</summary>
    public Command Leave { get; }

    /// <summary>Completes when the chosen layer is laid on the program.</summary>
    internal Task Laying { get; private set; } = Task.CompletedTask;

    /// <summary>Updates all texts after a change of language.</summary>
    public void Translate()
    {
        Picture.Translate();
        foreach (var layer in Layers)
        {
            layer.Translate();
        }

        OnPropertyChanged();
    }

    private async Task LayAsync()
    {
        Show(null, null, null);
        if (_layer is not { } layer)
        {
            return;
        }

        var request = _request with { Layer = layer.Layer.Name };
        OutlineJob? job = null;
        Refusal? refusal = null;
        var failure = await Failures.OfAsync(
            () =>
            {
                var outcome = OutlineJob.Make(request, CancellationToken.None);
                (job, refusal) = (outcome.Result, outcome.Refusal);
            },
            _clock);
        if (layer == _layer)
        {
            if (failure is null && job is not null)
            {
                layer.Layer = layer.Layer with { IsTried = true, CoveredShare = job.CoveredShare };
            }

            Show(
                failure is null ? job : null,
                failure is not null ? () => failure : refusal is null ? null : () => CodeText.Of(refusal),
                failure is null && refusal is { Code: OutlineJob.OtherUnit, Values: [var unit] } ? unit : null);
            await Picture.MarkAsync([.. _job?.Features.Select(f => new FeatureBlocks(f.Name, f.Blocks)) ?? []]);
        }
    }

    private void TakeOtherUnit()
    {
        _request = _request with { UnitMm = _otherUnit == "inch" ? 25.4 : 1 };

        // What was found in the other unit says nothing.
        foreach (var layer in Layers)
        {
            layer.Layer = layer.Layer with { IsTried = false, CoveredShare = null };
        }

        Laying = LayAsync().Watched();
    }

    private void Show(OutlineJob? job, Func<string>? refused, string? otherUnit)
    {
        (_job, _refused, _otherUnit) = (job, refused, otherUnit);
        Picture.Outline = job?.Outline ?? [];
        Take.Refresh();
        TakeUnit.Refresh();
        OnPropertyChanged();
    }

    private void TakeIt()
    {
        if (!ReferenceEquals(_draft, _editing.Draft))
        {
            Show(null, () => Texts.Current["Outline.JobChanged"], null);
            return;
        }

        var job = _job!;
        _editing.Change("", draft =>
        {
            var taken = job.Into(draft);
            taken = taken with
            {
                Features = [.. taken.Features.Select(f => f with { Lower = Lower.Trim(), Upper = Upper.Trim() })],
            };
            return AsksUncertainty ? taken.With(DraftPaths.Uncertainty, Uncertainty.Trim()) : taken;
        });
        _closed();
        if (!ReferenceEquals(_draft, _editing.Draft))
        {
            _editing.Note(() => Texts.Current.With("Outline.Taken", job.Features.Count, Path.GetFileName(_request.Drawing)));
        }
    }
}

/// <summary>A layer of a drawing, to be chosen.</summary>
internal sealed class LayerChoice(OutlineLayer layer, int index) : Observable
{
    private OutlineLayer _layer = layer;

    /// <summary>Its AutomationId.</summary>
    public string Id { get; } = "outline-layer-" + Shown.Id(index);

    /// <summary>The layer, with what is known of it.</summary>
    public OutlineLayer Layer
    {
        get => _layer;
        set
        {
            _layer = value;
            OnPropertyChanged();
        }
    }

    /// <summary>Its name.</summary>
    public string Name => Layer.Name;

    /// <summary>The number of its curves, where it is, and what the program cuts of it.</summary>
    public string Text => Sentence.Joined(
        Texts.Current.With("Outline.LayerCurves", Shown.Count(Layer.Curves)),
        Layer.Place.Trim() is { Length: > 0 } place ? Texts.Current.With("Outline.LayerPlace", place) : "",
        Layer.CoveredShare is { } share ? Texts.Current.With("Outline.LayerCut", Shown.Percent(100 * share))
            : Layer.IsTried ? Texts.Current["Outline.LayerNotLaid"] : "");

    /// <summary>Updates all texts after a change of language.</summary>
    public void Translate() => OnPropertyChanged();
}
