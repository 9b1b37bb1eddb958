using ErrorMatching.Cell;
using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>What both set-up screens share: which job is edited, the way back, what is wrong, and saving.</summary>
public abstract class SetupViewModel : ScreenViewModel
{
    private readonly ShellViewModel _shell;
    private string _shape = "";
    private string? _at;

    /// <summary>A screen at the job that is edited.</summary>
    protected SetupViewModel(ShellViewModel shell)
        : base((shell ?? throw new ArgumentNullException(nameof(shell))).Station)
    {
        _shell = shell;
        Editing = shell.Editing;
        TellProblems = new(Editing.Tell, () => IsIncomplete || HasAsked);
        LookAtWaiting = new(() =>
        {
            if (Editing.FirstWaiting is { } first)
            {
                _shell.Look(first);
            }
        });
        Step = new(() => _shell.Go(Key == Screens.Points ? Screens.System : Screens.Points));
    }

    /// <summary>Said when a field is to be gone to, by its AutomationId.</summary>
    public event Action<string>? FieldWanted;

    /// <summary>The job that is edited.</summary>
    public JobEditing Editing { get; }

    /// <summary>The job that is edited, by its name in the cell.</summary>
    public CellJobSettings? Job
    {
        get => Editing.Job;
        set => Editing.Choose(value);
    }

    /// <summary>Tells what is wrong at every field, and goes to the first.</summary>
    public Command TellProblems { get; }

    /// <summary>Goes to the first of the corrections that the notice speaks of.</summary>
    public Command LookAtWaiting { get; }

    /// <summary>True where it speaks of any.</summary>
    public bool HasWaiting => Editing.FirstWaiting is not null;

    /// <summary>What the job is called, as it is on the screen; by its name in the cell while it has none.</summary>
    public string JobTitle =>
        Editing.Job is not { } job
            ? ""
            : Editing.Draft.Name.Trim() is { Length: > 0 } name
            ? name
            : Editing.Draft.IsBegunAnew
            ? Texts.Current["Setup.NewJob"]
            : job.Name;

    /// <summary>In which of the cell's jobs it stands or may come, and whether it is saved and in use there.</summary>
    public string JobState => Editing.Place is not { } job ? "" : Editing.IsChanged ? Texts.Current.With("Setup.JobUnsaved", job.Name)
        : Editing.IsBeside ? Texts.Current.With("Setup.JobBeside", job.Name) : job.Name;

    /// <summary>To the other one of both screens: they are two steps of one thing.</summary>
    public Command Step { get; }

    /// <summary>Which one that is, in words, and how much is still to be filled in there.</summary>
    public string StepText
    {
        get
        {
            var (key, there) = Key == Screens.Points ? ("Setup.Next", Screens.System) : ("Setup.Back", Screens.Points);
            var name = Texts.Current["Screen." + there];
            return Texts.Current.With(key, MissingThere > 0 ? Texts.Current.With("Setup.MissingAt", MissingThere, name) : name);
        }
    }

    /// <summary>True where the other screen is what is left to fill in.</summary>
    public bool IsStepNext => MissingThere > 0 && !IsIncomplete;

    /// <summary>How much is wrong, and how much is still to be filled in here; else how much is asked about, in words.</summary>
    public string ProblemCount =>
        IsIncomplete ? JobEditing.CountOf(Editing.WrongCount, MissingHere) : HasAsked ? AskedText : Texts.Current["Setup.NothingWrong"];

    /// <summary>How much is asked about, in words.</summary>
    public string AskedText => Texts.Current.With("Setup.Asked", Editing.Doubts.Count);

    /// <summary>True where nothing has to be done before it is saved, and something is asked about.</summary>
    public bool HasAsked => !HasProblems && Editing.Doubts.Count > 0;

    /// <summary>True where nothing is to be said of the draft.</summary>
    public bool IsComplete => !IsIncomplete && !HasAsked;

    /// <summary>How much is wrong, in words.</summary>
    public string WrongText => Texts.Current.With("Setup.Problems", Editing.WrongCount);

    /// <summary>How much is still to be filled in on this screen, in words: what is done here does not let the number of this screen grow
    /// by what follows from it on the other.</summary>
    public string MissingText => Texts.Current.With("Setup.Missing", MissingHere);

    /// <summary>True if something is wrong.</summary>
    public bool HasWrong => Editing.WrongCount > 0;

    /// <summary>True if something is still to be filled in on this screen.</summary>
    public bool HasMissing => MissingHere > 0;

    /// <summary>True if something is wrong, or still to be filled in on this screen.</summary>
    public bool IsIncomplete => HasWrong || HasMissing;

    /// <summary>True if something is wrong or still to be filled in, wherever.</summary>
    public bool HasProblems => Editing.Problems.Count > 0;

    /// <summary>Whether the draft is what stands there.</summary>
    public string StateText => Editing.Place is not { } job ? ""
        : !Editing.IsChanged ? Texts.Current.With(Editing.IsBeside ? "Setup.Beside" : "Setup.AsSaved", job.Machine, job.Slot, job.Name)
        : Sentence.Joined(
            Texts.Current.With("Setup.Unsaved", job.Machine, job.Slot, job.Name),
            Editing.HasComments && !Editing.Draft.IsBegunAnew ? Texts.Current["Setup.CommentsLost"] : "");

    /// <summary>What a new job is for, and what becomes of the one that is there.</summary>
    public string? AnewHelp => Editing.Place is { } job ? Texts.Current.With("Setup.BeginAnewHelp", job.Name, job.Machine, job.Slot) : null;

    /// <summary>In whose place the job comes where it is put in use; null before one is chosen.</summary>
    public string? PutInUseHelp =>
        Editing.Place is { } job ? Texts.Current.With("Setup.ReplaceHelp", job.Name, job.Machine, job.Slot) : null;

    /// <summary>True where nothing is said in the place of <see cref="StateText"/>.</summary>
    public bool IsQuiet => Trouble is null && Editing.Notice is null && !HasKept;

    /// <summary>Why nothing can be edited; null if it can.</summary>
    public string? Forbidden =>
        Editing.Jobs.Count == 0 ? Texts.Current["Setup.NoJobs"] : Editing.MayEdit ? null : Texts.Current["Setup.TakesSetter"];

    /// <summary>True if there are unsaved changes from before to decide about.</summary>
    public bool HasKept => Editing.Kept is not null || Editing.IsKeptBroken;

    /// <summary>Whose changes they are.</summary>
    public string KeptText => Editing.Kept is { } kept ? Texts.Current.With("Setup.Kept", kept.By, Shown.Time(kept.At, Station.Clock)) : "";

    /// <summary>What did not work or is to be known: of the screen, else of the job.</summary>
    public string? Trouble => Message ?? Editing.Message;

    /// <summary>
    /// The field that is spoken of: the one with the focus, or that had it last, where something is wrong with it; else the first such one
    /// of what is open of the screen. Null if there is none.
    /// </summary>
    public EditField? Told =>
        TellableFields() is var fields && fields.FirstOrDefault(f => f.AutomationId == _at) is { } at
            ? at
            : fields.FirstOrDefault(f => f.IsToMend);

    /// <summary>True if nothing is in front of the screen.</summary>
    public bool IsInFront => _shell.IsFree && !_shell.IsLocked;

    /// <summary>The fields of the screen, as they are read.</summary>
    protected abstract IEnumerable<EditField> Fields { get; }

    /// <summary>The frame.</summary>
    protected ShellViewModel Shell => _shell;

    /// <summary>Key of the screen.</summary>
    protected abstract string Key { get; }

    /// <summary>Which side of the screen is open (<see cref="ProblemPlace"/>).</summary>
    protected virtual int OpenSide => 0;

    private int MissingHere => Editing.Problems.Count(p => p.IsMissing && ProblemPlace.Of(Editing.Draft, p.Field).Screen == Key);

    private int MissingThere => Editing.MissingCount - MissingHere;

    /// <summary>A field by its AutomationId.</summary>
    internal EditField FieldOf(string automationId) => Fields.First(f => f.AutomationId == automationId);

    /// <summary>Says where the focus is now.</summary>
    /// <param name="automationId">Of the field.</param>
    internal void Look(string automationId)
    {
        _at = automationId;
        Say(nameof(Told));
    }

    /// <summary>Begins to follow the draft, once the fields are made.</summary>
    protected void Begin()
    {
        Editing.Changed += Forget;
        Editing.Shown += Show;
        Editing.Wanted += GoToFirst;
        Editing.Choose(Editing.Job ?? (Editing.Jobs is [var first, ..] ? first : null));
        Show();
    }

    /// <inheritdoc/>
    protected override void Dispose(bool isDisposing)
    {
        Editing.Changed -= Forget;
        Editing.ForgetNotice();
        Editing.Shown -= Show;
        Editing.Wanted -= GoToFirst;
        base.Dispose(isDisposing);
    }

    /// <inheritdoc/>
    protected override void Follow()
    {
        // What is edited does not change with the cell.
    }

    /// <inheritdoc/>
    protected override void Translate()
    {
        _shape = "";
        Editing.Refresh();
    }

    /// <summary>Shows another side of the screen.</summary>
    protected virtual void Turn(int side)
    {
    }

    /// <summary>What the rows hang on: while it is the same, rows and the focus in them stay.</summary>
    protected abstract string ShapeOf(MatingDraft draft);

    /// <summary>Makes rows anew, for a draft that has others.</summary>
    protected abstract void MakeRows();

    /// <summary>Shows what follows from the draft beside its fields.</summary>
    protected virtual void ShowMore()
    {
    }

    /// <summary>Shows the draft.</summary>
    protected void Show()
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
        Say();
    }

    /// <summary>Lets the person go on in a field of the screen.</summary>
    /// <param name="field">The field.</param>
    protected void GoTo(EditField field)
    {
        ArgumentNullException.ThrowIfNull(field);
        FieldWanted?.Invoke(field.AutomationId);
    }

    // What is typed itself: of everything else is spoken where it stands.
    private EditField[] TellableFields() =>
        [
            .. Fields.Where(
                f => f.HasProblem
                    && f is not NoteField
                    && (Key == Screens.Points || ProblemPlace.Of(Editing.Draft, f.Path).Side == OpenSide))];

    // What was said of the draft as it was is over.
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

    // Each problem stands at the field with the longest path that leads to it.
    private ILookup<EditField?, DraftProblem> ByField(EditField[] fields, IEnumerable<DraftProblem> problems) =>
        problems.Where(p => ProblemPlace.Of(Editing.Draft, p.Field).Screen == Key).ToLookup(
            p => fields.Where(f => Leads(f, p.Field)).MaxBy(f => f.Path.Length));

    private static bool Leads(EditField field, string path) =>
        path == field.Path
            || (field is not NoteField && path.StartsWith(field.Path, StringComparison.Ordinal) && path[field.Path.Length] is '[' or '.');

    // As they are read: this screen after the other, its sides from the left, its fields from above.
    private void GoToFirst()
    {
        var places = (
            Editing.Problems.Count > 0 ? Editing.Problems : Editing.Doubts)
            .Select(p => (p.Field, Place: ProblemPlace.Of(Editing.Draft, p.Field))).ToLookup(p => p.Place, p => p.Field);
        var first = places.MinBy(p => (p.Key.Screen == Screens.Points ? 0 : 1, p.Key.Side));
        if (first is null)
        {
            return;
        }

        if (first.Key.Screen != Key)
        {
            if (_shell.Current == this)
            {
                _shell.Go(first.Key.Screen);
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
