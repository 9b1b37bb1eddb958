using ErrorMatching.Cell;
using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>What both setup screens share: edited job, undo, problems, and saving.</summary>
internal abstract class SetupViewModel : ScreenViewModel
{
    private readonly ShellViewModel _shell;
    private string _shape = "";
    private string? _at;

    protected SetupViewModel(ShellViewModel shell)
        : base((shell ?? throw new ArgumentNullException(nameof(shell))).Station)
    {
        _shell = shell;
        Editing = shell.Editing;
        TellProblems = new(Editing.Report, () => IsIncomplete || HasAsked);
        LookAtWaiting = new(() =>
        {
            if (Editing.FirstWaiting is { } first)
            {
                _shell.Look(first);
            }
        });
        Step = new(() => _shell.Go(Key == ScreenKeys.Points ? ScreenKeys.System : ScreenKeys.Points));
    }

    /// <summary>Raised to go to a field, by its AutomationId.</summary>
    public event Action<string>? FieldWanted;

    public JobEditing Editing { get; }

    /// <summary>The edited job, by its name in the cell.</summary>
    public CellJobSettings? Job
    {
        get => Editing.Job;
        set => Editing.Choose(value);
    }

    /// <summary>Shows problems at every field and goes to the first.</summary>
    public Command TellProblems { get; }

    /// <summary>Goes to the first correction in the notice.</summary>
    public Command LookAtWaiting { get; }

    public bool HasWaiting => Editing.FirstWaiting is not null;

    /// <summary>The job's displayed name; its name in the cell while it has none.</summary>
    public string JobTitle =>
        Editing.Job is not { } job
            ? ""
            : Editing.Draft.Name.Trim() is { Length: > 0 } name
            ? name
            : Editing.Draft.IsBegunAnew
            ? Texts.Current["Setup.NewJob"]
            : job.Name;

    /// <summary>The cell's job that it belongs to or may replace, and whether it is saved and in use there.</summary>
    public string JobState => Editing.Place is not { } job ? "" : Editing.IsChanged ? Texts.Current.With("Setup.JobUnsaved", job.Name)
        : Editing.IsBeside ? Texts.Current.With("Setup.JobBeside", job.Name) : job.Name;

    /// <summary>Goes to the other setup screen, the other step of the setup.</summary>
    public Command Step { get; }

    /// <summary>Name of the other step, and how much is to be filled in there.</summary>
    public string StepText
    {
        get
        {
            var (key, there) = Key == ScreenKeys.Points ? ("Setup.Next", ScreenKeys.System) : ("Setup.Back", ScreenKeys.Points);
            var name = Texts.Current["Screen." + there];
            return Texts.Current.With(key, MissingThere > 0 ? Texts.Current.With("Setup.MissingAt", MissingThere, name) : name);
        }
    }

    /// <summary>True if only the other screen has fields to fill in.</summary>
    public bool IsStepNext => MissingThere > 0 && !IsIncomplete;

    /// <summary>Text with the numbers of errors and fields to fill in here; otherwise the number of questions.</summary>
    public string ProblemCount =>
        IsIncomplete ? DraftProblems.CountOf(Editing.WrongCount, MissingHere) : HasAsked ? AskedText : Texts.Current["Setup.NothingWrong"];

    public string AskedText => Texts.Current.With("Setup.Asked", Editing.Doubts.Count);

    /// <summary>True if only questions are left before saving.</summary>
    public bool HasAsked => !HasProblems && Editing.Doubts.Count > 0;

    /// <summary>True if there is nothing to report on the draft.</summary>
    public bool IsComplete => !IsIncomplete && !HasAsked;

    public string WrongText => Texts.Current.With("Setup.Problems", Editing.WrongCount);

    /// <summary>Text with the number of fields to fill in on this screen. Consequences on the other screen do not count.</summary>
    public string MissingText => Texts.Current.With("Setup.Missing", MissingHere);

    public bool HasWrong => Editing.WrongCount > 0;

    public bool HasMissing => MissingHere > 0;

    public bool IsIncomplete => HasWrong || HasMissing;

    /// <summary>True if something is wrong or needs to be filled in on any screen.</summary>
    public bool HasProblems => Editing.Problems.Count > 0;

    /// <summary>Whether the draft differs from the saved job.</summary>
    public string StateText => Editing.Place is not { } job ? ""
        : !Editing.IsChanged ? Texts.Current.With(Editing.IsBeside ? "Setup.Beside" : "Setup.AsSaved", job.Machine, job.Slot, job.Name)
        : Sentence.Joined(
            Texts.Current.With("Setup.Unsaved", job.Machine, job.Slot, job.Name),
            Editing.HasComments && !Editing.Draft.IsBegunAnew ? Texts.Current["Setup.CommentsLost"] : "");

    /// <summary>What a new job is for, and what happens to the existing one.</summary>
    public string? AnewHelp => Editing.Place is { } job ? Texts.Current.With("Setup.BeginAnewHelp", job.Name, job.Machine, job.Slot) : null;

    /// <summary>Which job putting this one in use replaces; null before one is chosen.</summary>
    public string? PutInUseHelp =>
        Editing.Place is { } job ? Texts.Current.With("Setup.ReplaceHelp", job.Name, job.Machine, job.Slot) : null;

    /// <summary>True if nothing replaces <see cref="StateText"/>.</summary>
    public bool IsQuiet => Trouble is null && Editing.Notice is null && !HasKept;

    /// <summary>Why nothing can be edited, or null.</summary>
    public string? Forbidden =>
        Editing.Jobs.Count == 0 ? Texts.Current["Setup.NoJobs"] : Editing.MayEdit ? null : Texts.Current["Setup.TakesSetter"];

    /// <summary>True if earlier unsaved changes wait for a decision.</summary>
    public bool HasKept => Editing.Stored is not null || Editing.IsKeptBroken;

    /// <summary>Whose changes they are.</summary>
    public string StoredText => Editing.Stored is { } stored
        ? Texts.Current.With("Setup.Stored", stored.By, Shown.Time(stored.At, Station.Clock))
        : "";

    /// <summary>A failure or message of the screen, otherwise of the job.</summary>
    public string? Trouble => Message ?? Editing.Message;

    /// <summary>The field whose problem is shown: the one with the current or last focus if it has a problem, otherwise the first one
    /// with a problem on the open tab. Null if there is none.</summary>
    public EditField? Told =>
        TellableFields() is var fields && fields.FirstOrDefault(f => f.AutomationId == _at) is { } at
            ? at
            : fields.FirstOrDefault(f => f.IsToMend);

    /// <summary>True if nothing covers the screen.</summary>
    public virtual bool IsInFront => _shell.IsFree && !_shell.IsLocked;

    /// <summary>The fields of the screen, in reading order.</summary>
    protected internal abstract IEnumerable<EditField> Fields { get; }

    protected ShellViewModel Shell => _shell;

    protected abstract string Key { get; }

    /// <summary>The open tab (<see cref="ProblemPlace"/>).</summary>
    protected virtual int OpenSide => 0;

    private int MissingHere => Editing.Problems.Count(p => p.IsMissing && ProblemPlace.Of(Editing.Draft, p.Field).ScreenKey == Key);

    private int MissingThere => Editing.MissingCount - MissingHere;

    internal EditField FieldOf(string automationId) => Fields.First(f => f.AutomationId == automationId);

    /// <summary>Reports which field has the focus.</summary>
    /// <param name="automationId">The field's AutomationId.</param>
    internal void Look(string automationId)
    {
        _at = automationId;
        OnPropertyChanged(nameof(Told));
    }

    /// <summary>Starts to follow the draft, once the fields exist.</summary>
    protected void Begin()
    {
        Editing.Changed += Forget;
        Editing.Shown += Show;
        Editing.Wanted += GoToFirst;
        Editing.Choose(Editing.Job ?? (Editing.Jobs is [var first, ..] ? first : null));
        Show();
    }

    protected override void Dispose(bool isDisposing)
    {
        Editing.Changed -= Forget;
        Editing.ForgetNotice();
        Editing.Shown -= Show;
        Editing.Wanted -= GoToFirst;
        base.Dispose(isDisposing);
    }

    protected override void Follow()
    {
        // The edited job does not change with the cell.
    }

    protected override void Translate()
    {
        _shape = "";
        Editing.Refresh();
    }

    /// <summary>Opens another tab.</summary>
    protected virtual void Turn(int side)
    {
    }

    /// <summary>What the rows depend on: while it is unchanged, rows and their focus stay.</summary>
    protected abstract string ShapeOf(MatingDraft draft);

    /// <summary>Recreates the rows for a draft with different ones.</summary>
    protected abstract void MakeRows();

    /// <summary>Shows what depends on the draft in addition to its fields.</summary>
    protected virtual void ShowMore()
    {
    }

    protected internal void Show()
    {
        var shape = ShapeOf(Editing.Draft);
        if (shape != _shape)
        {
            _shape = shape;
            MakeRows();
        }

        ShowFields();
        ShowMore();
        TellProblems.Refresh();
        OnPropertyChanged();
    }

    /// <summary>Moves the user to a field of the screen.</summary>
    protected void GoTo(EditField field)
    {
        ArgumentNullException.ThrowIfNull(field);
        FieldWanted?.Invoke(field.AutomationId);
    }

    // Fields with input only; other problems are shown in their places.
    private EditField[] TellableFields() =>
        [
            .. Fields.Where(
                f => f.HasProblem
                    && f is not NoteField
                    && (Key == ScreenKeys.Points || ProblemPlace.Of(Editing.Draft, f.Path).Side == OpenSide))];

    // Messages about the previous draft no longer apply.
    private void Forget()
    {
        Message = null;
        Show();
    }

    private void ShowFields()
    {
        var fields = Fields.ToArray();
        var (problems, doubts) = (ByField(fields, Editing.Problems), ByField(fields, Editing.Doubts));
        foreach (var field in fields)
        {
            field.Show(problems[field], doubts[field]);
        }
    }

    // A problem belongs to the field with the longest matching path.
    private ILookup<EditField?, DraftProblem> ByField(EditField[] fields, IEnumerable<DraftProblem> problems) =>
        problems.Where(p => ProblemPlace.Of(Editing.Draft, p.Field).ScreenKey == Key).ToLookup(
            p => fields.Where(f => Leads(f, p.Field)).MaxBy(f => f.Path.Length));

    private static bool Leads(EditField field, string path) =>
        path == field.Path
            || (field is not NoteField && path.StartsWith(field.Path, StringComparison.Ordinal) && path[field.Path.Length] is '[' or '.');

    // In reading order: screen by screen, tabs from the left, fields from the top.
    private void GoToFirst()
    {
        var places = (
            Editing.Problems.Count > 0 ? Editing.Problems : Editing.Doubts)
            .Select(p => (p.Field, Place: ProblemPlace.Of(Editing.Draft, p.Field))).ToLookup(p => p.Place, p => p.Field);
        var first = places.MinBy(p => (p.Key.ScreenKey == ScreenKeys.Points ? 0 : 1, p.Key.Side));
        if (first is null)
        {
            return;
        }

        if (first.Key.ScreenKey != Key)
        {
            if (_shell.Current == this)
            {
                _shell.Go(first.Key.ScreenKey);
                (_shell.Current as SetupViewModel)?.GoToFirst();
            }

            return;
        }

        Turn(first.Key.Side);
        if (Fields.FirstOrDefault(f => f.HasProblem && first.Any(path => Leads(f, path))) is { } field)
        {
            GoTo(field);
        }
    }
}
