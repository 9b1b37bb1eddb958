using System.Collections.ObjectModel;
using ErrorMatching.Jobs;
using ErrorMatching.Mating;

namespace ErrorMatching.Hmi;

/// <summary>Point setup: the part's features and their numbers of points, with a drawing of the part as it grows.</summary>
internal sealed class PointsViewModel : SetupViewModel, ITakesCodes
{
    private readonly ITimer _minute;
    private readonly SynchronizationContext _screen = SynchronizationContext.Current!;
    private readonly NoteField _features;
    private readonly OutlineTaking _outline;
    private MatingDraft? _drawn;

    public PointsViewModel(ShellViewModel shell)
        : base(shell)
    {
        WorkOrder = new(Editing, DraftPaths.WorkOrder, "Points.WorkOrder");
        Workpiece = new(Editing, DraftPaths.Name, "Points.Workpiece");
        _features = new(Editing, DraftPaths.Features, "Points.Features");
        _outline = new(this, shell);
        _outline.Shown += OnOutlineShown;
        Adds = [.. FeatureKinds.All.Select(k => new KindChoice(k, Adding(k)))];
        _minute = Station.Clock.CreateTimer(
            _ => _screen.Post(_ => OnPropertyChanged(nameof(Time)), null), null, TimeSpan.FromSeconds(1), TimeSpan.FromSeconds(1));
        Editing.Begun += GoToFirstField;
        Begin();
    }

    public TextField WorkOrder { get; }

    /// <summary>The workpiece: the job's name.</summary>
    public TextField Workpiece { get; }

    public string Operator => Shell.UserName;

    public string Time => Shown.Time(Station.Clock.GetUtcNow(), Station.Clock);

    /// <summary>The features in the order of cutting.</summary>
    public ObservableCollection<FeatureEdit> Features { get; } = [];

    /// <summary>Problems with the list as a whole.</summary>
    public NoteField FeaturesNote => _features;

    public bool IsEmpty => Features.Count == 0;

    public IReadOnlyList<KindChoice> Adds { get; }

    /// <summary>Makes features, blocks, frame and tool of the job from a drawing and a program.</summary>
    public LongCommand FromDrawing => _outline.FromDrawing;

    /// <summary>The outline of a drawing that is looked at before the job takes it; null while none is.</summary>
    public OutlineChoice? Outline => _outline.Choice;

    /// <summary>True while the form is shown instead of an outline.</summary>
    public bool IsForm => Outline is null;

    /// <inheritdoc/>
    public override bool IsInFront => IsForm && base.IsInFront;

    /// <summary>A scanned code becomes the work order.</summary>
    public void TakeCode(string code)
    {
        if (Editing.CanEdit)
        {
            WorkOrder.Text = code;
        }
    }

    /// <summary>The part, as far as it is known.</summary>
    public PartDrawing Drawing { get; private set; } = PartDrawing.Of(new());

    /// <summary>Caption that explains how the part is drawn.</summary>
    public string DrawingCaption => Drawing switch
    {
        { Total: 0 } => Texts.Current["Points.DrawnNothing"],
        { IsSchematic: true } => Texts.Current.With("Points.DrawnSchematic", Drawing.Total),
        { Known: var known } when known < Drawing.Total => Texts.Current.With("Points.DrawnPartly", known, Drawing.Total),
        _ => Texts.Current.With("Points.DrawnTrue", Drawing.Total),
    };

    protected override string Key => ScreenKeys.Points;

    protected internal override IEnumerable<EditField> Fields => [WorkOrder, Workpiece, _features, .. Features.SelectMany(f => f.Fields)];

    protected override void Dispose(bool isDisposing)
    {
        _minute.Dispose();
        Editing.Begun -= GoToFirstField;
        base.Dispose(isDisposing);
    }

    protected override string ShapeOf(MatingDraft draft) => string.Join(' ', draft.Features.Select(f => f.Kind));

    protected override void MakeRows()
    {
        Features.Clear();
        for (var i = 0; i < Editing.Draft.Features.Count; i++)
        {
            Features.Add(new(Editing, i));
        }
    }

    protected override void ShowMore()
    {
        if (!ReferenceEquals(_drawn, Editing.Draft))
        {
            // Keep a zoomed view while nothing changes.
            (_drawn, Drawing) = (Editing.Draft, PartDrawing.Of(Editing.Draft));
        }

        foreach (var feature in Features)
        {
            feature.Refresh();
        }

        foreach (var choice in Adds)
        {
            choice.Refresh();
        }

        FromDrawing.Refresh();
    }

    protected override void Translate()
    {
        Outline?.Translate();
        base.Translate();
    }

    private void OnOutlineShown()
    {
        OnPropertyChanged(nameof(Outline));
        OnPropertyChanged(nameof(IsForm));
        OnPropertyChanged(nameof(IsInFront));
    }

    // A new job starts at its first field.
    private void GoToFirstField()
    {
        if (Shell.Current == this)
        {
            GoTo(WorkOrder);
        }
    }

    private Command Adding(FeatureKind kind) => new(
        () => Editing.Change("", d =>
        {
            var number = 1;
            while (d.Features.Any(f => f.Name == kind.Letter + Shown.Id(number)))
            {
                number++;
            }

            return d with { Features = [.. d.Features, FeatureDraft.New(kind, kind.Letter + Shown.Id(number), d)] };
        }),
        () => Editing.CanEdit);
}

/// <summary>A kind of feature that can be added.</summary>
/// <param name="kind">The kind.</param>
/// <param name="add">Adds a feature of it.</param>
internal sealed class KindChoice(FeatureKind kind, Command add) : Observable
{
    public Command Add { get; } = add;

    public string Name => Texts.Current["Points.Add." + kind];

    public string Icon => "Icon.kind-" + kind;

    public string Id => "add-" + kind;

    /// <summary>Updates its availability and its text in the display language.</summary>
    internal void Refresh()
    {
        Add.Refresh();
        OnPropertyChanged(nameof(Name));
    }
}
