using ErrorMatching.Cell;
using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>The job edited at this station, shared by both setup screens: the draft, undo history, problems, and the copy stored for
/// crash recovery.</summary>
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

    /// <summary>Starts without a job.</summary>
    /// <param name="station">The station.</param>
    /// <param name="who">Returns the signed-in user.</param>
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

        // While saving, nothing can be edited.
        Save.PropertyChanged += (_, _) => Refresh();
        PutInUse.PropertyChanged += (_, _) => Refresh();
    }

    /// <summary>Raised on the UI thread when the draft has changed.</summary>
    public event Action? Changed;

    /// <summary>Raised on the UI thread when something else to show has changed: problems, permissions, stored changes.</summary>
    public event Action? Shown;

    /// <summary>Raised to go to the first field that is wrong or needs to be filled in.</summary>
    public event Action? Wanted;

    /// <summary>Raised when a new job was started.</summary>
    public event Action? Begun;

    /// <summary>Raised when a job in use is to change: the user signs, and <see cref="SaveSigned"/> then saves it.</summary>
    public event Action<JobReplacement>? Asked;

    /// <summary>The cell's mating jobs, each file once. If several jobs share a file, as for part and counterpart, the name is that of
    /// the first that is not the counterpart's. Each is followed by its prepared jobs.</summary>
    public RowList<CellJobSettings> Jobs { get; } = [];

    /// <summary>The edited job; null before one is chosen.</summary>
    public CellJobSettings? Job { get; private set; }

    public MatingDraft Draft => _history.Draft;

    /// <summary>Known problems of the draft, including fields that need to be filled in.</summary>
    public IReadOnlyList<DraftProblem> Problems => _typed is { } typed ? [typed, .. _found] : _found;

    /// <summary>Known questions about valid but probably unintended input.</summary>
    public IReadOnlyList<DraftProblem> Doubts { get; private set; } = [];

    /// <summary>Number of fields to fill in.</summary>
    public int MissingCount => Problems.Count(p => p.IsMissing);

    /// <summary>Number of errors.</summary>
    public int WrongCount => Problems.Count - MissingCount;

    /// <summary>Text with the numbers of errors and fields to fill in on each screen; empty if there are none.</summary>
    public string CountText => Texts.Current.Listed(Problems
        .GroupBy(p => (p.IsMissing, ProblemPlace.Of(Draft, p.Field).ScreenKey))
        .OrderBy(g => g.Key.IsMissing).ThenBy(g => g.Key.ScreenKey == ScreenKeys.Points ? 0 : 1)
        .Select(g => Texts.Current.With(
            g.Key.IsMissing ? "Setup.MissingAt" : "Setup.WrongAt", g.Count(), Texts.Current["Screen." + g.Key.ScreenKey])));

    /// <summary>Problem with the last input that the draft cannot store, such as a count that is not a number. The next change clears
    /// it.</summary>
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

    /// <summary>True if <see cref="Problems"/> are those of the current draft.</summary>
    public bool IsChecked { get; private set; }

    /// <summary>True if mistakes are also shown at untouched empty fields: after a tap on the count or an attempt to save.</summary>
    public bool IsTold => _isTold;

    /// <summary>Earlier unsaved changes that wait for a decision, or null.</summary>
    public KeptDraft? Kept { get; private set; }

    /// <summary>True if the stored changes cannot be read.</summary>
    public bool IsKeptBroken { get; private set; }

    /// <summary>A failure or other message, or null.</summary>
    public string? Message
    {
        get => _message;
        private set => Set(ref _message, value);
    }

    /// <summary>Notice about what was saved and what follows, or null.</summary>
    public string? Notice => _notice?.Invoke();

    /// <summary>True if the job's file has comments, which saving a draft loses.</summary>
    public bool HasComments { get; private set; }

    /// <summary>True if the draft differs from the saved job.</summary>
    public bool IsChanged => _isLoaded && !Draft.IsSame(_base);

    /// <summary>True if the signed-in user may edit jobs.</summary>
    public bool MayEdit => _who() is { } who && Rights.Allows(who.Role, Act.EditJobs);

    public bool CanEdit => MayEdit && _isLoaded && Kept is null && !IsKeptBroken && !Save.IsRunning && !PutInUse.IsRunning;

    public Command Undo { get; }

    public Command Redo { get; }

    public Command BeginAnew { get; }

    /// <summary>Resets the draft to the saved job.</summary>
    public Command DiscardChanges { get; }

    /// <summary>Resumes the earlier unsaved changes.</summary>
    public Command ContinueKept { get; }

    /// <summary>Deletes the earlier unsaved changes.</summary>
    public LongCommand DiscardKept { get; }

    /// <summary>Saves a draft without problems: replaces the job, with a signature if it is in use; saves a new job as a prepared
    /// job.</summary>
    public LongCommand Save { get; }

    /// <summary>Completes when the chosen job is open.</summary>
    internal Task Loading { get; private set; } = Task.CompletedTask;

    /// <summary>Completes when no check or store operation is running.</summary>
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
    /// <param name="field">The field with the input; empty for a separate step.</param>
    /// <param name="change">The change.</param>
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

    /// <summary>Shows the result of the last change; the next change clears it.</summary>
    public void Note(Func<string>? notice)
    {
        (_notice, _waiting, _first) = (notice, [], null);
        Refresh();
    }

    /// <summary>Shows mistakes at every field and goes to the first; without mistakes, to the first question.</summary>
    public void Tell()
    {
        _isTold = true;
        Refresh();
        if (Problems.Count + Doubts.Count > 0)
        {
            Wanted?.Invoke();
        }
    }

    /// <summary>Updates for another user or language.</summary>
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

    /// <summary>Clears the notice about saving, because the user continues with something else.</summary>
    internal void ForgetNotice()
    {
        _notice = null;
        Say(nameof(Notice));
        Say(nameof(CanComputeAnew));
        Say(nameof(FirstWaiting));
    }

    /// <summary>Waits until the last input is stored.</summary>
    public void Dispose() => _keeping.Running.GetAwaiter().GetResult();

    /// <summary>Text with the numbers of errors and fields to fill in; empty if there are none.</summary>
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
