using ErrorMatching.Cell;
using ErrorMatching.Jobs;
using ErrorMatching.Refusals;

namespace ErrorMatching.Hmi;

/// <summary>Free-form surfaces: where a surface is probed, where its error is, what either way of compensation leaves of it, and
/// the finishing program, which is approved or rejected here as in the on-line compensation.</summary>
internal sealed class FreeformViewModel : ScreenViewModel, ILooksAt
{
    private const int Most = 60;
    private long _older;
    private readonly Dictionary<string, StoredSurface?> _read = new(StringComparer.Ordinal);
    private readonly ShellViewModel _shell;
    private readonly Pause _pause;
    private bool _isExpected = true;
    private long? _current;
    private SurfaceJobChoice? _job;
    private SurfaceRow? _chosen;
    private long? _looked;
    private SurfaceDetail? _detail;
    private SurfacePlan? _plan;
    private (long Id, int Version, bool IsOfChangedJob) _shown = (0, -1, false);
    private bool _isPlanned;
    private int _load;

    public FreeformViewModel(ShellViewModel shell)
        : base((shell ?? throw new ArgumentNullException(nameof(shell))).Station)
    {
        _shell = shell;
        _pause = new(Station.Clock, OnDecisionsChanged);
        Approve = Decision(Act.Approve);
        Reject = Decision(Act.Reject);
        Jobs = [.. Station.Settings.Jobs.Where(j => j.IsFreeform).Select(j => new SurfaceJobChoice(j.Name, j))];
        _job = Jobs.FirstOrDefault(j => j.Name == shell.Looked.SurfaceJob) ?? (Jobs is [var first, ..] ? first : null);
        _looked = shell.Looked.Surface;
        Refresh();
    }

    /// <summary>The cell's free-form jobs.</summary>
    public IReadOnlyList<SurfaceJobChoice> Jobs { get; }

    /// <summary>True if there is a choice.</summary>
    public bool HasJobs => Jobs.Count > 1;

    public bool IsWithoutJobs => Jobs.Count == 0;

    /// <summary>The selected job.</summary>
    public SurfaceJobChoice? Job
    {
        get => _job;
        set
        {
            if (value is not null && Set(ref _job, value))
            {
                (_looked, _current, _shown, _isExpected) = (null, null, (0, -1, false), true);
                (_shell.Looked.SurfaceJob, _shell.Looked.Surface) = (value.Name, null);
                (Detail, Plan, _isPlanned) = (null, null, false);
                Refresh();
            }
        }
    }

    /// <summary>The last measured surfaces, newest first.</summary>
    public RowList<SurfaceRow> Rows { get; } = [];

    /// <summary>How many earlier measurements are not listed, in words; null if none.</summary>
    public string? Older => _older > 0 ? Texts.Current.With("List.Older", Shown.Count(_older)) : null;

    /// <summary>True once the list is known to be empty.</summary>
    public bool IsEmpty { get; private set; }

    /// <summary>The selected surface. Until the user selects one, it is the one measured last.</summary>
    public SurfaceRow? Chosen
    {
        get => _chosen;
        set
        {
            if (value is not null && value != _chosen)
            {
                Look(value.Id);
                Refresh();
            }
        }
    }

    /// <summary>Its details; null if none is measured.</summary>
    public SurfaceDetail? Detail
    {
        get => _detail;
        private set => Set(ref _detail, value);
    }

    /// <summary>Approves its program for its machine.</summary>
    public Command Approve { get; }

    /// <summary>Rejects it.</summary>
    public Command Reject { get; }

    /// <summary>True if the shown surface can be approved or rejected by a user who has the right.</summary>
    public bool IsUndecided =>
        Detail is { Stored.Correction.State: var state } && CorrectionSteps.Allows(state, CorrectionState.Rejected);

    /// <summary>Why a button is disabled; null if no explanation is needed.</summary>
    public string? Forbidden => !IsUndecided || _shell.Who is not { } who ? null
        : _pause.IsOn ? Texts.Current["Compensation.Changed"]
        : Detail!.Stored.Correction.IsUndecided && !Rights.Allows(who.Role, Act.Approve)
            ? Texts.Current["Compensation.ApproveTakesSetter"]
        : null;

    /// <summary>The probing plan; null once a surface is measured.</summary>
    public SurfacePlan? Plan
    {
        get => _plan;
        private set => Set(ref _plan, value);
    }

    /// <summary>Completes when the content is shown.</summary>
    internal Task Loading { get; private set; } = Task.CompletedTask;

    /// <inheritdoc/>
    public void LookAt(long correction)
    {
        Look(correction);
        Refresh();
    }

    /// <inheritdoc/>
    protected override void Dispose(bool isDisposing)
    {
        base.Dispose(isDisposing);
        _pause.Dispose();
    }

    /// <inheritdoc/>
    protected override void Follow() => Refresh();

    /// <inheritdoc/>
    protected override void Translate()
    {
        // Rebuild the view in the other language; until then, the old content stays.
        (_shown, _isPlanned) = ((0, -1, false), false);
        Refresh();
    }

    // The user's own choice needs no pause.
    private void Look(long id)
    {
        _shell.Looked.Surface = _looked = _current = id;
        _isExpected = true;
        OnDecisionsChanged();
    }

    // The decision applies to what is shown. Keep it selected, so that the user sees the outcome.
    private Command Decision(Act act) => new(
        () =>
        {
            var (kept, detail) = (Detail!.Stored, Detail);
            _shell.Looked.Surface = _looked = kept.Correction.Id;
            _shell.Sign(DecisionSigning.Of(_shell, act, kept, () => detail.Now().Facts));
        },
        () => !_pause.IsOn
            && Detail is { Stored.Correction: var correction }
            && correction.Id == _current
            && DecisionSigning.IsPossible(_shell, act, correction));

    private void OnDecisionsChanged()
    {
        OnPropertyChanged(nameof(IsUndecided));
        OnPropertyChanged(nameof(Forbidden));
        Approve.Refresh();
        Reject.Refresh();
    }

    private void Refresh()
    {
        if (_job is not null)
        {
            Loading = LoadAsync(_job.Settings, ++_load).Watched();
        }
    }

    private async Task LoadAsync(CellJobSettings job, int load)
    {
        IReadOnlyList<(Correction Correction, StoredSurface Surface)> measured = [];
        (StoredCorrection Stored, SurfaceDetail Detail)? read = null;
        SurfacePlan? plan = null;
        string? trouble = null;
        Correction? selected = null;
        var (looked, shown, isPlanned, older, changed) = (_looked, _shown, _isPlanned, 0L, Station.State.OfChangedJob);
        var isRead = await TryAsync(() =>
        {
            measured = Measured(job);
            older = Station.Store.Corrections.CountReported([job.Name]) - Most;
            selected = measured.FirstOrDefault(m => m.Correction.Id == looked).Correction
                ?? (measured is [var newest, ..] ? newest.Correction : null);
            if (selected is { } correction)
            {
                var isOfChangedJob = changed.Contains(correction.Id);
                if ((correction.Id, correction.Version, isOfChangedJob) != shown)
                {
                    var kept = StoredCorrection.Read(Station.Store, correction);
                    read = (kept, new(kept, Station.Clock, () => PathOf(job, correction)) { IsOfChangedJob = isOfChangedJob });
                }
            }
            else if (!isPlanned)
            {
                (plan, trouble) = PlanOf(job);
            }
        });

        // Another one may have been selected meanwhile.
        if (load != _load)
        {
            return;
        }

        if (!isRead)
        {
            if (Detail is null)
            {
                // The old surfaces belong to the other job, and those of this job are not known yet.
                ShowRows([], isKnown: false);
            }

            return;
        }

        _older = older;
        ShowRows([.. measured.Select(m => Row(m.Correction, m.Surface))], isKnown: true);
        Message = trouble;
        if (read is { } it)
        {
            _shown = (it.Stored.Correction.Id, it.Stored.Correction.Version, it.Detail.IsOfChangedJob);
            if (!_isExpected && (Detail is not { Stored.Correction: var was } || (was.Id, was.Version, Detail.IsOfChangedJob) != _shown))
            {
                _pause.Begin();
            }

            var now = it.Detail.Now();
            now.IsPathShown = Detail?.IsPathShown == true;
            (Detail, Plan) = (now, null);
        }

        (_current, _isExpected) = (selected?.Id, false);

        Plan = plan ?? Plan;
        _isPlanned = Plan is not null;
        _chosen = Rows.FirstOrDefault(r => r.Id == _shown.Id);
        OnPropertyChanged(nameof(Chosen));
        OnDecisionsChanged();
    }

    private SurfacePath PathOf(CellJobSettings job, Correction correction) =>
        SurfacePath.Of(Station.Store.Content(correction.ProgramSha256!), new FreeformFiles(job.File).ToolpathDialect());

    private void ShowRows(IReadOnlyList<SurfaceRow> rows, bool isKnown)
    {
        Rows.Show(rows);
        IsEmpty = isKnown && rows.Count == 0;
        OnPropertyChanged(nameof(IsEmpty));
        OnPropertyChanged(nameof(Older));
    }

    private List<(Correction Correction, StoredSurface Surface)> Measured(CellJobSettings job)
    {
        var measured = new List<(Correction, StoredSurface)>();
        foreach (var correction in Station.Store.Corrections.Reported([job.Name], Most))
        {
            if (!_read.TryGetValue(correction.ReportSha256!, out var surface))
            {
                _read[correction.ReportSha256!] = surface = StoredReport.Read(Station.Store.Content(correction.ReportSha256!)).Surface;
            }

            if (surface is not null)
            {
                measured.Add((correction, surface));
            }
        }

        return measured;
    }

    // An unreadable job is not a defect of the station.
    private (SurfacePlan? Plan, string? Trouble) PlanOf(CellJobSettings job)
    {
        try
        {
            return (SurfacePlan.Of(job), null);
        }
        catch (InputException e)
        {
            return (null, Failures.Of(e, Station.Clock));
        }
    }

    private static SurfaceRow Row(Correction c, StoredSurface surface) =>
        new(
            c.Id,
            CorrectionLabel.Of(c),
            surface.JobName,
            Texts.Current.Word(c.State),
            Shown.Micrometers(surface.Findings.Before.ProfileIsoMm),
            CorrectionLabel.SeverityOf(c.State));
}

/// <summary>A measured surface in a list.</summary>
/// <param name="Id">Number of its correction.</param>
/// <param name="Title">Number and serial number or file.</param>
/// <param name="Job">The workpiece's name.</param>
/// <param name="State">Its state.</param>
/// <param name="Profile">Its measured profile.</param>
/// <param name="Severity">Its severity.</param>
internal sealed record SurfaceRow(long Id, string Title, string Job, string State, string Profile, Severity Severity)
{
    public string AutomationId => "surface-" + Shown.Id(Id);
}

/// <summary>A free-form job of the cell.</summary>
/// <param name="Name">Its display name.</param>
/// <param name="Settings">The job.</param>
internal sealed record SurfaceJobChoice(string Name, CellJobSettings Settings);
