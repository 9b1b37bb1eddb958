using System.Collections.ObjectModel;
using ErrorMatching.Jobs;
using ErrorMatching.Mating;

namespace ErrorMatching.Hmi;

/// <summary>System setup: coordinates of each point, blocks of each feature, and how deviations are judged and compensated; tried out
/// before saving.</summary>
internal sealed class SystemViewModel : SetupViewModel
{
    // The number that fits in two lines; the others are marked at their fields.
    private const int MostCorners = 6;

    private readonly SystemFields _fields;
    private readonly BlockPicking _picking;
    private readonly DryRunning _running;
    private readonly DraftFiles _files;
    private int _side;

    public SystemViewModel(ShellViewModel shell)
        : base(shell)
    {
        _side = Shell.Looked.SystemSide;
        _fields = new(Editing);
        _picking = new(Editing, () => OnPropertyChanged(nameof(Picture)));
        _running = new(this, shell);
        _running.Shown += OnDetailChanged;
        _files = new(this, shell);
        Points = new(Editing, DraftPaths.Theoretical, "System.Coordinates");
        Program = new(Editing, DraftPaths.Program, "System.Program");
        Dialect = new(Editing, DraftPaths.Dialect, "System.Program");
        Rules = new(Editing, DraftPaths.Recognition, "System.Gauge");
        AddPoint = Doing(AddOtherPoint);
        RemovePoint = new(
            () => Editing.Change("", d => d with { OtherPoints = d.OtherPoints.Without(d.OtherPoints.Count - 1) }),
            () => Editing.CanEdit && Editing.Draft.OtherPoints.Count > 0);
        AddLink = Doing(() => Editing.Change("", d => d.WithItem(DraftPaths.Chain)));
        SameLimits = new(() => Editing.Change("", d => d.WithSameLimits()), () => Editing.CanEdit && Editing.Draft.Features.Count > 1);
        AddComparison = Doing(() => Editing.Change("", d => d.WithItem(DraftPaths.Comparisons)));
        AddContribution = Doing(() => Editing.Change("", WithContribution));
        Back = new(() => _running.Detail = null);
        Begin();
        Editing.Begun += GoToFirstSide;
    }

    public int Side
    {
        get => _side;
        set
        {
            // Clear the notice when another tab is opened, unless it offers an action.
            if (TurnTo(value) && Editing.FirstWaiting is null)
            {
                Editing.ForgetNotice();
            }
        }
    }

    /// <summary>The heads of the tabs, with what is to be corrected and filled in on each.</summary>
    public IReadOnlyList<SideHead> Heads { get; } = [
        new("System.Coordinates"), new("System.ProgramAndBlocks"), new("System.Tolerances"), new("System.Machine"), new("System.Gauge")];

    public ObservableCollection<CoordinateRow> Coordinates { get; } = [];

    /// <summary>The same points, arranged side by side.</summary>
    public ObservableCollection<CoordinatePair> Pairs { get; } = [];

    public bool HasZ => Coordinates.Any(c => c.HasZ);

    /// <summary>True before there are features, when coordinates have no points to go to.</summary>
    public bool NeedsFeatures => Editing.Job is not null && Editing.Draft.Features.Count == 0;

    /// <summary>Problems with the points as a whole.</summary>
    public NoteField Points { get; }

    /// <summary>Text with the points on rounded corners and how much farther from these their deviation can be compensated, or
    /// null.</summary>
    public string? Corners =>
        Editing.Doubts.Where(d => d.Code == WarningForms.PointOnCorner.Name)
            .Select(d => Texts.Current.With("System.Corner", d.Found, d.Amount))
            .ToArray() is { Length: > 0 } corners
        ? Texts.Current.With("System.Corners", TableText.Listed(corners, MostCorners)) : null;

    public NoteField Program { get; }

    public NoteField Dialect { get; }

    /// <summary>Problems with the source rules, which cannot be edited.</summary>
    public NoteField Rules { get; }

    public string ProgramText => Editing.Draft[DraftPaths.Program].Length == 0 ? Texts.Current["System.NoProgram"]
        : Editing.Draft.Program is { } program
            ? Texts.Current.With("System.ProgramImported", Editing.Draft[DraftPaths.Program], Shown.Count(program.Bytes.Length))
        : Editing.Draft[DraftPaths.Program];

    public string DialectText => Texts.Current.With("System.Dialect", Editing.Draft[DraftPaths.Dialect]);

    public IReadOnlyList<BlocksRow> Blocks => _picking.Rows;

    public IReadOnlyList<FieldRow> Tolerances { get; private set; } = [];

    public IReadOnlyList<FieldRow> Chain { get; private set; } = [];

    public IReadOnlyList<EditField> Frame { get; private set; } = [];

    public IReadOnlyList<EditField> Alignment { get; private set; } = [];

    public IReadOnlyList<EditField> Compensation { get; private set; } = [];

    public IReadOnlyList<EditField> Gauge { get; private set; } = [];

    public IReadOnlyList<FieldRow> Contributions { get; private set; } = [];

    /// <summary>Comparisons in addition to those of the features.</summary>
    public IReadOnlyList<FieldRow> Comparisons { get; private set; } = [];

    /// <summary>Adds a point without a feature.</summary>
    public Command AddPoint { get; }

    /// <summary>Removes the last of these points.</summary>
    public Command RemovePoint { get; }

    public Command AddLink { get; }

    /// <summary>Gives all features the limits of the first.</summary>
    public Command SameLimits { get; }

    public Command AddComparison { get; }

    public Command AddContribution { get; }

    public LongCommand ReadPoints => _files.ReadPoints;

    public LongCommand ReadProgram => _files.ReadProgram;

    /// <summary>Finds the blocks of features without blocks by their key points.</summary>
    public LongCommand FindBlocks => _picking.FindBlocks;

    /// <summary>The program; null while there is none, or while it is being opened.</summary>
    public ProgramPicture? Picture => _picking.Picture;

    /// <summary>The result of the dry run; null while none is shown.</summary>
    public CorrectionDetail? Detail => _running.Detail;

    /// <summary>True while the form is shown instead of a dry run.</summary>
    public bool IsForm => Detail is null;

    /// <summary>Warning that the dry run probably used a drawing; null otherwise.</summary>
    public string? DryRunDoubt => _running.Doubt;

    /// <summary>Tries the draft with the job's last measurement in the store.</summary>
    public LongCommand DryRun => _running.Last;

    public LongCommand DryRunFile => _running.File;

    /// <summary>Returns from the dry run to the form.</summary>
    public Command Back { get; }

    /// <summary>Completes when the program is open and its features are marked.</summary>
    internal Task Opening => _picking.Opening;

    protected override string Key => ScreenKeys.System;

    protected override int OpenSide => Side;

    protected internal override IEnumerable<EditField> Fields =>
    [
        Points, .. Coordinates.SelectMany(c => c.Fields), Program, Dialect, .. Blocks.Select(b => b.Blocks),
        .. Tolerances.Concat(Chain).SelectMany(r => r.Cells), .. Frame, .. Alignment, .. Compensation,
        .. Gauge, .. Contributions.Concat(Comparisons).SelectMany(r => r.Cells), Rules,
    ];

    public void Paste(string? text) => _files.Paste(text);

    public Task ImportProgramAsync(string path) => _files.ImportProgramAsync(path);

    /// <summary>The row of <see cref="Pairs"/> that contains a field; -1 if it is not a coordinate's.</summary>
    internal int RowOf(string automationId) => Pairs.ToList().FindIndex(
        p => new[] { p.First, p.Second }.OfType<CoordinateRow>().SelectMany(c => c.Fields).Any(f => f.AutomationId == automationId));

    protected override string ShapeOf(MatingDraft draft) =>
        string.Join('|', draft.Features.Select(f => $"{f.Kind} {f.Name} {f.Tolerance} {string.Join(' ', f.Flanks.Select(k => k.Count))}"))
        + $"/{draft.OtherPoints.Count}/{draft.Count(DraftPaths.Chain)}/{string.Join(' ', Quantities(draft))}"
        + $"/{draft.Count(DraftPaths.Uncertainty)}/{draft[DraftPaths.Format].StartsWith('{')}/{draft[DraftPaths.AlignmentKind]}"
        + $"/{draft[DraftPaths.Rule]}"
        + $"/{draft.Points.Any(p => p.Z.Length > 0) || draft.Features.Any(f => f.Plane != "XY")}";

    protected override void MakeRows()
    {
        Coordinates.Clear();
        foreach (var row in CoordinateRow.Of(Editing))
        {
            Coordinates.Add(row);
        }

        Pairs.Clear();
        foreach (var pair in CoordinatePair.Of(Coordinates))
        {
            Pairs.Add(pair);
        }

        _picking.MakeRows(_fields.Blocks());
        (Tolerances, Chain) = (_fields.Tolerances(), _fields.Chain());
        (Frame, Alignment, Compensation) = (_fields.Frame(), _fields.Alignment(), _fields.Compensation());
        (Gauge, Contributions, Comparisons) = (_fields.Gauge(), _fields.Contributions(), _fields.Comparisons());
    }

    protected override void ShowMore()
    {
        foreach (var command in new[]
        {
            AddPoint,
            RemovePoint,
            AddLink,
            SameLimits,
            AddComparison,
            AddContribution
        }.Concat(Chain.Concat(Contributions).Concat(Comparisons).Select(r => r.Remove!)))
        {
            command.Refresh();
        }

        foreach (var command in new[] { ReadPoints, ReadProgram, FindBlocks, DryRun, DryRunFile })
        {
            command.Refresh();
        }

        Decimals.Align(Coordinates.Select(c => c.X));
        Decimals.Align(Coordinates.Select(c => c.Y));
        Decimals.Align(Coordinates.Select(c => c.Z).OfType<TextField>());
        var sides = Editing.Problems.Select(p => (Problem: p, Place: ProblemPlace.Of(Editing.Draft, p.Field)))
            .Where(p => p.Place.ScreenKey == Key)
            .ToLookup(p => p.Place.Side);
        var asked = Editing.Doubts.Select(d => ProblemPlace.Of(Editing.Draft, d.Field))
            .Where(p => p.ScreenKey == Key)
            .ToLookup(p => p.Side);
        for (var side = 0; side < Heads.Count; side++)
        {
            Heads[side].Show(
                sides[side].Count(p => !p.Problem.IsMissing), sides[side].Count(p => p.Problem.IsMissing), asked[side].Count());
        }

        _picking.Show();
    }

    protected override void Turn(int side)
    {
        _running.Detail = null;
        TurnTo(side);
    }

    protected override void Translate()
    {
        _running.Translate();
        _picking.Continue(base.Translate);
    }

    private bool TurnTo(int side)
    {
        var isOther = Set(ref _side, side, nameof(Side));
        Shell.Looked.SystemSide = side;
        OnPropertyChanged(nameof(Told));
        return isOther;
    }

    protected override void Dispose(bool isDisposing)
    {
        Editing.Begun -= GoToFirstSide;
        base.Dispose(isDisposing);
    }

    // A new job starts on the first tab.
    private void GoToFirstSide() => Turn(0);

    private static IEnumerable<string> Quantities(MatingDraft draft) =>
        Enumerable.Range(0, draft.Count(DraftPaths.Comparisons))
            .Select(i => draft[DraftPaths.Item(DraftPaths.Comparisons, i, DraftPaths.Quantity)]);

    // What was stated as a whole becomes the first contribution.
    private static MatingDraft WithContribution(MatingDraft draft) =>
        draft.Count(DraftPaths.Uncertainty) is var count && draft.WithItem(DraftPaths.Uncertainty) is var added && count > 0
            ? added
            : added.With(DraftPaths.Item(DraftPaths.Uncertainty, 0, DraftPaths.ContributionValue), draft[DraftPaths.Uncertainty]);

    private Command Doing(Action act) => new(act, () => Editing.CanEdit);

    // Go to the new point: it is at the end of the list, usually out of sight, and has no label yet.
    private void AddOtherPoint()
    {
        Editing.Change("", d => d with { OtherPoints = [.. d.OtherPoints, new("")] });
        GoTo(Coordinates[^1].Label);
    }

    private void OnDetailChanged()
    {
        OnPropertyChanged(nameof(Detail));
        OnPropertyChanged(nameof(IsForm));
        OnPropertyChanged(nameof(DryRunDoubt));
    }
}

/// <summary>Points side by side in the system setup, so that a small screen shows twice as many.</summary>
/// <param name="First">The first one.</param>
/// <param name="Second">The next one; null if there is none, or if three coordinates take up the width.</param>
/// <param name="Columns">Number that fits side by side.</param>
internal sealed record CoordinatePair(CoordinateRow First, CoordinateRow? Second, int Columns)
{
    /// <summary>Arranges points side by side, line by line in order.</summary>
    public static IEnumerable<CoordinatePair> Of(IReadOnlyCollection<CoordinateRow> rows)
    {
        var columns = rows.Any(r => r.HasZ) ? 1 : 2;
        return rows.Chunk(columns).Select(r => new CoordinatePair(r[0], r.Length > 1 ? r[1] : null, columns));
    }
}
