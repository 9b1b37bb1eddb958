using ErrorMatching.Cell;
using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>The job that is being edited at this station, shared by both set-up screens: the draft, the way back, what is wrong with it,
/// and what is kept of it in case of a crash.</summary>
public sealed partial class JobEditing : Observable, IDisposable
{
    private readonly Station _station;
    private readonly Func<SignedIn?> _who;
    private readonly SynchronizationContext _screen;
    private readonly EditHistory _history = new();
    private readonly Latest<Snapshot> _checking;
    private readonly Latest<Snapshot> _keeping;
    private readonly DraftFolder _drafts;
    private MatingDraft _base = new();
    private string _baseSha256 = "";
    private string? _message;
    private Func<string>? _notice;
    private bool _isLoaded;
    private bool _isTold;
    private IReadOnlyList<DraftProblem> _found = [];
    private DraftProblem? _typed;

    /// <summary>No job yet.</summary>
    /// <param name="station">The station.</param>
    /// <param name="who">Who is signed in.</param>
    public JobEditing(Station station, Func<SignedIn?> who)
    {
        _station = station ?? throw new ArgumentNullException(nameof(station));
        _who = who;
        _screen = SynchronizationContext.Current ?? throw new InvalidOperationException("Jobs are edited on the screen's thread.");
        _drafts = new(Path.Combine(Path.GetDirectoryName(Path.GetFullPath(station.Settings.File))!, "drafts"));
        Jobs.Show([.. InUse(station.Settings)]);
        _checking = new(LookThrough);
        _keeping = new(KeepAway);
        Undo = new(() => Go(_history.Undo), () => CanEdit && _history.CanUndo);
        Redo = new(() => Go(_history.Redo), () => CanEdit && _history.CanRedo);
        BeginAnew = new(BeginNew, () => CanEdit);
        DiscardChanges = new(() => Change("", _ => _base), () => CanEdit && IsChanged);
        ContinueKept = new(TakeKept, () => Kept is not null && MayEdit);
        DiscardKept = new(_ => ForgetKeptAsync(), () => (Kept is not null || IsKeptBroken) && MayEdit);
        Save = new(_ => SaveAsync(), () => CanEdit && IsChanged);
        PutInUse = new(_ => PutInUseAsync(), () => CanEdit && IsBeside && !IsChanged);
        ComputeAnew = new(_ => ComputeAnewAsync(), () => CanComputeAnew);

        // While it is saved nothing can be edited.
        Save.PropertyChanged += (_, _) => Refresh();
        PutInUse.PropertyChanged += (_, _) => Refresh();
    }

    /// <summary>Said on the screen's thread when the draft is another one.</summary>
    public event Action? Changed;

    /// <summary>Said on the screen's thread when something else is to be shown: what is wrong, who may edit, what was kept.</summary>
    public event Action? Shown;

    /// <summary>Said when the first field is to be gone to that something is wrong with or that is still to be filled in.</summary>
    public event Action? Wanted;

    /// <summary>Said when a new job was begun.</summary>
    public event Action? Begun;

    /// <summary>Said when what a gauge runs is to change: a person signs that, and then <see cref="SaveSigned"/> saves it.</summary>
    public event Action<JobReplacement>? Asked;

    /// <summary>The cell's mating jobs, each file once: where several take their measurements by the same file, as those of part and
    /// counterpart do, by the name of the first that is not the counterpart's. Behind each those that are saved beside it.</summary>
    public RowList<CellJobSettings> Jobs { get; } = [];

    /// <summary>The job that is edited; null before one is chosen.</summary>
    public CellJobSettings? Job { get; private set; }

    /// <summary>The draft.</summary>
    public MatingDraft Draft => _history.Draft;

    /// <summary>What is wrong with the draft or still to be filled in, as far as it is known.</summary>
    public IReadOnlyList<DraftProblem> Problems => _typed is { } typed ? [typed, .. _found] : _found;

    /// <summary>What can be saved and is hardly meant, as far as it is known.</summary>
    public IReadOnlyList<DraftProblem> Doubts { get; private set; } = [];

    /// <summary>How much is still to be filled in.</summary>
    public int MissingCount => Problems.Count(p => p.IsMissing);

    /// <summary>How much is wrong.</summary>
    public int WrongCount => Problems.Count - MissingCount;

    /// <summary>How much is to be corrected and to be filled in on which screen, in words, as far as there is any.</summary>
    public string CountText => Texts.Current.Listed(Problems
        .GroupBy(p => (p.IsMissing, ProblemPlace.Of(Draft, p.Field).Screen))
        .OrderBy(g => g.Key.IsMissing).ThenBy(g => g.Key.Screen == Screens.Points ? 0 : 1)
        .Select(g => Texts.Current.With(
            g.Key.IsMissing ? "Setup.MissingAt" : "Setup.WrongAt", g.Count(), Texts.Current["Screen." + g.Key.Screen])));

    /// <summary>What is wrong with what was typed last, where the draft has no place for it: a count that is no number.
    /// It goes with the next change.</summary>
    public DraftProblem? Typed
    {
        get => _typed;
        set
        {
            if (_typed != value)
            {
                _typed = value;
                Refresh();
            }
        }
    }

    /// <summary>True once <see cref="Problems"/> are those of the draft as it is now.</summary>
    public bool IsChecked { get; private set; }

    /// <summary>True if mistakes are told at fields that nobody has filled in yet:
    /// after the count was tapped, or saving was tried.</summary>
    public bool IsTold => _isTold;

    /// <summary>Unsaved changes from before that wait for a decision; null if there are none.</summary>
    public KeptDraft? Kept { get; private set; }

    /// <summary>True if what was kept cannot be read.</summary>
    public bool IsKeptBroken { get; private set; }

    /// <summary>What did not work or is to be known, in words; null for nothing.</summary>
    public string? Message
    {
        get => _message;
        private set => Set(ref _message, value);
    }

    /// <summary>What was saved and what follows, in words; null for nothing.</summary>
    public string? Notice => _notice?.Invoke();

    /// <summary>True if the job's file has comments, which are lost when a draft takes its place.</summary>
    public bool HasComments { get; private set; }

    /// <summary>True if the draft is not what stands there.</summary>
    public bool IsChanged => _isLoaded && !Draft.IsSame(_base);

    /// <summary>True if whoever sits here may edit jobs.</summary>
    public bool MayEdit => _who() is { } who && Rights.Allows(who.Role, Act.EditJobs);

    /// <summary>True if the draft can be edited now.</summary>
    public bool CanEdit => MayEdit && _isLoaded && Kept is null && !IsKeptBroken && !Save.IsRunning && !PutInUse.IsRunning;

    /// <summary>A step back.</summary>
    public Command Undo { get; }

    /// <summary>A step forth.</summary>
    public Command Redo { get; }

    /// <summary>Empties the draft.</summary>
    public Command BeginAnew { get; }

    /// <summary>Makes the draft what stands there.</summary>
    public Command DiscardChanges { get; }

    /// <summary>Goes on with the unsaved changes from before.</summary>
    public Command ContinueKept { get; }

    /// <summary>Forgets the unsaved changes from before.</summary>
    public LongCommand DiscardKept { get; }

    /// <summary>Saves the draft, if nothing is wrong with it: in the place of the job, by a signature where that is in use;
    /// a new job beside it.</summary>
    public LongCommand Save { get; }

    /// <summary>Done when a job that was chosen is opened.</summary>
    internal Task Loading { get; private set; } = Task.CompletedTask;

    /// <summary>Done when nothing is checked and nothing is kept any more.</summary>
    internal Task Behind => Task.WhenAll(_checking.Running, _keeping.Running);

    /// <summary>Opens a job, unless it is open.</summary>
    public void Choose(CellJobSettings? job)
    {
        job = Jobs.FirstOrDefault(j => j.File == job?.File) ?? job;
        if (job is not null && job != Job)
        {
            (Job, _isLoaded, Kept, IsKeptBroken, _notice, _found, Doubts, _typed) = (job, false, null, false, null, [], [], null);
            ShowVersions([]);
            Refresh();
            Loading = LoadAsync(job).Watched();
        }
    }

    /// <summary>Changes the draft.</summary>
    /// <param name="field">The field that is typed into; empty for a step of its own.</param>
    /// <param name="change">What the draft becomes.</param>
    public void Change(string field, Func<MatingDraft, MatingDraft> change)
    {
        ArgumentNullException.ThrowIfNull(change);
        if (CanEdit && change(Draft) is var draft && !draft.IsSame(Draft))
        {
            _history.Change(draft, field);
            (_notice, _typed) = (null, null);
            Follow();
        }
    }

    /// <summary>Says what came of the last change; it goes with the next.</summary>
    public void Note(Func<string>? notice)
    {
        (_notice, _waiting, _first) = (notice, [], null);
        Refresh();
    }

    /// <summary>Tells mistakes at every field, and goes to the first; where there is none, to the first that is asked about.</summary>
    public void Tell()
    {
        _isTold = true;
        Refresh();
        if (Problems.Count + Doubts.Count > 0)
        {
            Wanted?.Invoke();
        }
    }

    /// <summary>Says that somebody else sits here, or that the language is another one.</summary>
    public void Refresh()
    {
        foreach (var command in new[] { Undo, Redo, BeginAnew, DiscardChanges, ContinueKept })
        {
            command.Refresh();
        }

        DiscardKept.Refresh();
        foreach (var row in Versions)
        {
            row.Restore.Refresh();
        }

        Save.Refresh();
        PutInUse.Refresh();
        ComputeAnew.Refresh();
        Say();
        Shown?.Invoke();
    }

    /// <summary>Takes back what was said about saving: something else is done now.</summary>
    internal void ForgetNotice()
    {
        _notice = null;
        Say(nameof(Notice));
        Say(nameof(CanComputeAnew));
        Say(nameof(FirstWaiting));
    }

    /// <summary>Waits for what is being kept: what was typed last is not lost.</summary>
    public void Dispose() => _keeping.Running.GetAwaiter().GetResult();

    /// <summary>In words how much is to be corrected and to be filled in, as far as there is any.</summary>
    internal static string CountOf(int wrong, int missing) => string.Join(
        " · ",
        new[]
        {
            wrong > 0 ? Texts.Current.With("Setup.Problems", wrong) : "",
            missing > 0 ? Texts.Current.With("Setup.Missing", missing) : ""
        }.Where(t => t.Length > 0));

    private void BeginNew()
    {
        Change("", d => d.Emptied());
        Begun?.Invoke();
    }

    private void Go(Action way)
    {
        way();
        (_notice, _typed) = (null, null);
        Follow();
    }

    private void Follow()
    {
        var snapshot = new Snapshot(Job!, Draft, _base, _baseSha256, _who()?.Name ?? "", _station.Clock.GetUtcNow());
        IsChecked = false;
        _checking.Give(snapshot);
        _keeping.Give(snapshot);
        Changed?.Invoke();
        Refresh();
    }

    private void LookThrough(Snapshot snapshot)
    {
        var check = new JobEdits(_station.Settings, _station.Store, _station.Users).Check(snapshot.Job, snapshot.Draft);
        _screen.Post(
            _ =>
            {
                if (ReferenceEquals(snapshot.Draft, Draft))
                {
                    (_found, Doubts, IsChecked) = (check.Problems, check.Doubts, true);
                    Refresh();
                }
            },
            null);
    }

    private void KeepAway(Snapshot snapshot)
    {
        try
        {
            if (snapshot.Draft.IsSame(snapshot.Base))
            {
                Forget(snapshot.Job);
            }
            else
            {
                _drafts.Keep(
                    new()
                    {
                        Job = snapshot.Job.Name,
                        By = snapshot.By,
                        At = snapshot.At,
                        BaseSha256 = snapshot.BaseSha256,
                        Draft = snapshot.Draft
                    });
            }
        }
        catch (OutputException e)
        {
            _screen.Post(_ => Message = Texts.Current.With("Setup.NotKept", Failures.Of(e, _station.Clock)), null);
        }
    }

    private sealed record Snapshot(
        CellJobSettings Job, MatingDraft Draft, MatingDraft Base, string BaseSha256, string By, DateTimeOffset At);
}
