using ErrorMatching.Cell;
using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>The job edited at this station, shared by both setup screens: the draft with its undo history, and what is known of
/// it.</summary>
public sealed class JobEditing : Observable, IDisposable
{
    private readonly Station _station;
    private readonly Func<SignedIn?> _who;
    private readonly EditHistory _history = new();
    private readonly DraftProblems _problems;
    private readonly SavedVersions _versions;
    private readonly JobSaving _saving;
    private readonly JobEdits _edits;
    private string? _message;
    private Func<string>? _notice;
    private bool _isLoaded;
    private bool _isTold;

    /// <summary>Starts without a job.</summary>
    /// <param name="station">The station.</param>
    /// <param name="who">Returns the signed-in user.</param>
    public JobEditing(Station station, Func<SignedIn?> who)
    {
        _station = station ?? throw new ArgumentNullException(nameof(station));
        _who = who;
        _ = SynchronizationContext.Current ?? throw new InvalidOperationException("Jobs are edited on the screen's thread.");
        _edits = new(station.Settings, station.Store, station.Users);
        _problems = new(station, () => Draft, Refresh);
        _versions = new(this, _edits, station.Clock);
        _saving = new(this, _edits, who, replacement => Asked?.Invoke(replacement));
        Recovery = new(station, told => Message = told);
        Earlier = new(station, who);
        Jobs.Show([.. InUse(station.Settings)]);
        Undo = new(() => Go(_history.Undo), () => CanEdit && _history.CanUndo);
        Redo = new(() => Go(_history.Redo), () => CanEdit && _history.CanRedo);
        BeginAnew = new(BeginNew, () => CanEdit);
        DiscardChanges = new(() => Change("", _ => Base), () => CanEdit && IsChanged);
        ContinueKept = new(TakeKept, () => Stored is not null && MayEdit);
        DiscardKept = new(_ => ForgetKeptAsync(), () => (Stored is not null || IsKeptBroken) && MayEdit);
        Recalculate = new(_ => RecalculateAsync(), () => CanRecalculate);

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
    public IReadOnlyList<DraftProblem> Problems => _problems.All;

    /// <summary>Known questions about valid but probably unintended input.</summary>
    public IReadOnlyList<DraftProblem> Doubts => _problems.Doubts;

    /// <summary>Number of fields to fill in.</summary>
    public int MissingCount => _problems.MissingCount;

    /// <summary>Number of errors.</summary>
    public int WrongCount => _problems.WrongCount;

    /// <summary>Text with the numbers of errors and fields to fill in on each screen; empty if there are none.</summary>
    public string CountText => _problems.CountText;

    /// <summary>Problem with the last input that the draft cannot store, such as a count that is not a number. The next change clears
    /// it.</summary>
    public DraftProblem? Typed
    {
        get => _problems.Typed;
        set
        {
            if (_problems.Typed != value)
            {
                _problems.Typed = value;
                Refresh();
            }
        }
    }

    /// <summary>True if <see cref="Problems"/> are those of the current draft.</summary>
    public bool IsChecked => _problems.IsChecked;

    /// <summary>True if mistakes are also shown at untouched empty fields: after a tap on the count or an attempt to save.</summary>
    public bool IsTold => _isTold;

    /// <summary>Earlier unsaved changes that wait for a decision, or null.</summary>
    public StoredDraft? Stored { get; private set; }

    /// <summary>True if the stored changes cannot be read.</summary>
    public bool IsKeptBroken { get; private set; }

    /// <summary>A failure or other message, or null.</summary>
    public string? Message
    {
        get => _message;
        internal set => Set(ref _message, value);
    }

    /// <summary>Notice about what was saved and what follows, or null.</summary>
    public string? Notice => _notice?.Invoke();

    /// <summary>True if the job's file has comments, which saving a draft loses.</summary>
    public bool HasComments { get; private set; }

    /// <summary>True if the draft differs from the saved job.</summary>
    public bool IsChanged => _isLoaded && !Draft.IsSame(Base);

    /// <summary>True if the signed-in user may edit jobs.</summary>
    public bool MayEdit => _who() is { } who && Rights.Allows(who.Role, Act.EditJobs);

    public bool CanEdit => MayEdit && _isLoaded && Stored is null && !IsKeptBroken && !Save.IsRunning && !PutInUse.IsRunning;

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
    public LongCommand Save => _saving.Save;

    /// <summary>Replaces the job in use with this one, once all changes are saved.</summary>
    public LongCommand PutInUse => _saving.PutInUse;

    /// <summary>The saved versions of the job, the latest first; empty until they are read.</summary>
    public RowList<VersionRow> Versions => _versions.Rows;

    /// <summary>True while a prepared job is edited.</summary>
    public bool IsBeside => Job is { } job && !_edits.IsInUse(job);

    /// <summary>The cell's job that the edited job belongs to or may replace; null before one is chosen.</summary>
    public CellJobSettings? Place => Job is { } job ? _edits.PlaceOf(job) : null;

    /// <summary>Recalculates the corrections that are waiting, approved or failed with the current job.</summary>
    public LongCommand Recalculate { get; }

    /// <summary>True while the notice about saving is shown and the user may recalculate.</summary>
    public bool CanRecalculate => _notice is not null && Earlier.CanCompute;

    /// <summary>Button text with the number of corrections.</summary>
    public string RecalculateText => Texts.Current.With("Setup.Recalculate", Earlier.Waiting.Count);

    /// <summary>The first correction in the notice about saving or recalculating; null if there is none.</summary>
    public long? FirstWaiting => _notice is null ? null : Earlier.First;

    /// <summary>The saved job that the draft was made from.</summary>
    internal MatingDraft Base { get; private set; } = new();

    /// <summary>Hash of the saved job.</summary>
    internal string BaseSha256 { get; private set; } = "";

    /// <summary>The stored copy of unsaved changes.</summary>
    internal DraftRecovery Recovery { get; }

    /// <summary>Corrections computed with the job before it was saved.</summary>
    internal EarlierCorrections Earlier { get; }

    /// <summary>Completes when the chosen job is open.</summary>
    internal Task Loading { get; private set; } = Task.CompletedTask;

    /// <summary>Completes when no check is running.</summary>
    internal Task Checking => _problems.Running;

    /// <summary>Completes when no check or store operation is running.</summary>
    internal Task Behind => Task.WhenAll(Checking, Recovery.Running);

    /// <summary>Completes when the chosen version is in the form.</summary>
    internal Task Restoring => _versions.Restoring;

    /// <summary>Opens a job, unless it is open.</summary>
    public void Choose(CellJobSettings? job)
    {
        job = Jobs.FirstOrDefault(j => j.File == job?.File) ?? job;
        if (job is not null && job != Job)
        {
            (Job, _isLoaded, Stored, IsKeptBroken, _notice) = (job, false, null, false, null);
            _problems.Clear();
            _versions.Clear();
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
            (_notice, _problems.Typed) = (null, null);
            Follow();
        }
    }

    /// <summary>Shows the result of the last change; the next change clears it.</summary>
    public void Note(Func<string>? notice) => Note(notice, []);

    /// <summary>Shows mistakes at every field and goes to the first; without mistakes, to the first question.</summary>
    public void Report()
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
        _versions.Refresh();
        Save.Refresh();
        PutInUse.Refresh();
        Recalculate.Refresh();
        OnPropertyChanged();
        Shown?.Invoke();
    }

    /// <summary>Clears the notice about saving, because the user continues with something else.</summary>
    internal void ForgetNotice()
    {
        _notice = null;
        OnPropertyChanged(nameof(Notice));
        OnPropertyChanged(nameof(CanRecalculate));
        OnPropertyChanged(nameof(FirstWaiting));
    }

    /// <summary>Waits until the last input is stored.</summary>
    public void Dispose() => Recovery.Running.GetAwaiter().GetResult();

    /// <summary>Shows the result of saving, and offers to recalculate corrections.</summary>
    internal void Note(Func<string>? notice, IReadOnlyList<Correction> waiting)
    {
        _notice = notice;
        Earlier.Offer(waiting);
        Refresh();
    }

    /// <summary>Goes on with the requested signature (<see cref="Asked"/>).</summary>
    internal void SaveSigned(SignedIn by) => _saving.Sign(by);

    /// <summary>Continues from a saved draft.</summary>
    internal void TakeSaved(MatingDraft draft, string sha256)
    {
        // The imported program is now the job's own.
        (Base, BaseSha256, HasComments) = (draft with { Program = null }, sha256, false);
        _history.Begin(Base);
    }

    /// <summary>Shows that a job was saved.</summary>
    internal async Task ShowSavedAsync(CellJobSettings job)
    {
        Changed?.Invoke();
        await _versions.ReadAsync(job);
    }

    /// <summary>Lists the jobs in use and the prepared ones. If these cannot be listed, it reports that and keeps the list.</summary>
    internal async Task ReadJobsAsync()
    {
        IReadOnlyList<CellJobSettings> jobs = [];
        var read = () => { jobs = [.. InUse(_station.Settings).SelectMany(j => _edits.PreparedFor(j).Prepend(j))]; };
        if (await Failures.OfAsync(read, _station.Clock) is { } failure)
        {
            Message = failure;
            return;
        }

        Jobs.Show(jobs);
    }

    /// <summary>Runs work off the UI thread. Failures set <see cref="Message"/>.</summary>
    /// <returns>True if it succeeded.</returns>
    internal async Task<bool> TryAsync(Action work)
    {
        Message = null;
        if (await Failures.OfAsync(work, _station.Clock) is not { } failure)
        {
            return true;
        }

        Message = failure;
        return false;
    }

    // If several jobs share a file, as for part and counterpart, use the first that is not the counterpart's.
    private static IEnumerable<CellJobSettings> InUse(CellSettings settings) => settings.Jobs.Where(j => !j.IsFreeform)
        .GroupBy(j => j.File, StringComparer.Ordinal).Select(g => g.FirstOrDefault(j => j.Piece != PieceWords.Counterpart) ?? g.First());

    private async Task LoadAsync(CellJobSettings job)
    {
        var opened = await Task.Run(() => OpenedJob.Read(job, Recovery, _station.Clock));
        if (job != Job)
        {
            return;
        }

        (BaseSha256, Base, HasComments) = (opened.Sha256, opened.Draft ?? new(), opened.HasComments);
        (Stored, IsKeptBroken, _isLoaded, _isTold) = (opened.Stored, opened.IsKeptBroken, opened.Draft is not null, false);
        Message = opened.Message;
        _history.Begin(Base);
        _problems.Check(new(job, Base, Base, BaseSha256, "", default));
        Changed?.Invoke();
        Refresh();
        await ReadJobsAsync();
        await _versions.ReadAsync(job);
    }

    private void TakeKept()
    {
        if (Stored is { } kept)
        {
            Stored = null;

            // Saving reports a change made in the meantime.
            BaseSha256 = kept.BaseSha256;
            _history.Begin(Base);
            _history.Change(kept.Draft, "");
            Follow();
        }
    }

    private async Task ForgetKeptAsync()
    {
        var job = Job!;
        if (await TryAsync(() => Recovery.Forget(job)))
        {
            (Stored, IsKeptBroken) = (null, false);
            Refresh();
        }
    }

    private async Task RecalculateAsync()
    {
        _notice = await Earlier.ComputeAsync();
        Refresh();
    }

    private void BeginNew()
    {
        Change("", d => d.Emptied());
        Begun?.Invoke();
    }

    private void Go(Action way)
    {
        way();
        (_notice, _problems.Typed) = (null, null);
        Follow();
    }

    private void Follow()
    {
        var snapshot = new DraftSnapshot(Job!, Draft, Base, BaseSha256, _who()?.Name ?? "", _station.Clock.GetUtcNow());
        _problems.Check(snapshot);
        Recovery.Keep(snapshot);
        Changed?.Invoke();
        Refresh();
    }
}
