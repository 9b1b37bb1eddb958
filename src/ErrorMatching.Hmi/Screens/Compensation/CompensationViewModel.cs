using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>On-line compensation: shows the change at the machine before it happens, and takes the decision about it.</summary>
internal sealed class CompensationViewModel : ScreenViewModel, ILooksAt
{
    private readonly ShellViewModel _shell;
    private readonly LookedCorrection _choice;
    private readonly Pause _pause;
    private string? _undone;
    private ListedCorrection? _chosen;
    private bool _isExpected = true;
    private CorrectionDetail? _detail;
    private (long Id, int Version, bool IsOfChangedJob) _shown = (0, -1, false);
    private bool _isAtWarnings;
    private HashSet<long> _heldUp = [];
    private string _filter = "";
    private int _all;
    private Correction[] _rejectable = [];
    private (Act Act, string Title)? _decided;

    public CompensationViewModel(ShellViewModel shell)
        : base((shell ?? throw new ArgumentNullException(nameof(shell))).Station)
    {
        _shell = shell;
        _choice = new(shell);
        _pause = new(Station.Clock, OnDecisionsChanged);
        (Approve, Reject) = (Decision(Act.Approve), Decision(Act.Reject));
        Release = new(
            () => Sign(kept => new(
                Station,
                _shell.Who!,
                Act.Release,
                kept.Subject,
                needsReason: false,
                (by, reason, cancellation) => Task.Run(
                    () => new SlotRelease(Station.Settings, Station.Store, Station.Open)
                        .ReleaseAsync(kept.Correction.Id, by.Name, reason, cancellation),
                    cancellation))
            {
                Correction = kept.Correction,
            }),
            () => IsDecidable && _shell.Who is { } who && Rights.Allows(who.Role, Act.Release) && IsAtMachine);
        Recalculate = new(_ => RecalculateAsync(), () => IsDecidable && IsOutdated);
        LookAtFirst = new(() =>
        {
            if (Wait is { } wait)
            {
                LookAt(wait.First);
            }
        });
        Revert = new(
            () => Sign(k => RevertSigning.Of(_shell, k)),
            () => IsDecidable && _shell.Who is { } who && Rights.Allows(who.Role, Act.Revert) && RevertSigning.IsPossible(Detail?.Stored));
        RejectShown = new(SignRejections, () => CanRejectShown);
        Refresh();
    }

    /// <summary>What the numbers, serial numbers, files, jobs, machines, slots or states of the listed corrections must contain; empty
    /// for all corrections.</summary>
    public string Filter
    {
        get => _filter;
        set
        {
            if (Set(ref _filter, value ?? ""))
            {
                Refresh();
            }
        }
    }

    /// <summary>How many of all are listed, in words; null without a filter.</summary>
    public string? Listed => IsFiltered ? Texts.Current.With("Compensation.Listed", Shown.Count(Rows.Count), Shown.Count(_all)) : null;

    /// <summary>Rejects all that are listed and not decided, with one reason. Approving stays one by one: each is looked at.</summary>
    public Command RejectShown { get; }

    /// <summary>True if the filter lists several that this user may reject.</summary>
    public bool CanRejectShown =>
        IsFiltered && _rejectable.Length > 1 && _shell.Who is { } who && Rights.Allows(who.Role, Act.Reject);

    /// <summary>Corrections waiting for a decision, on their way to a machine, or at one.</summary>
    public RowList<ListedCorrection> Rows { get; } = [];

    /// <summary>True if <see cref="Rows"/> is known to be empty.</summary>
    public bool IsEmpty => Station.State is { Status: not null, StoreTrouble: null } && Rows.Count == 0;

    /// <summary>The selected correction. Until the user selects one or decides, it is the longest-waiting one; a newer arrival
    /// does not replace it.</summary>
    public ListedCorrection? Chosen
    {
        get => _chosen;
        set
        {
            if (value is not null && value != _chosen)
            {
                Look(value.Id);
                Choose(value.Id);
            }
        }
    }

    /// <summary>Its details; null while nothing is selected.</summary>
    public CorrectionDetail? Detail
    {
        get => _detail;
        private set => Set(ref _detail, value);
    }

    /// <summary>What it waits for before it can go to its machine; null if only for a decision about itself.</summary>
    public string? Waits => Wait?.Text;

    /// <summary>Severity of that wait.</summary>
    public Severity WaitsSeverity => Wait?.Severity ?? Severity.Quiet;

    /// <summary>Opens the correction that it waits for.</summary>
    public Command LookAtFirst { get; }

    /// <summary>Approves it for its machine.</summary>
    public Command Approve { get; }

    /// <summary>Rejects it.</summary>
    public Command Reject { get; }

    /// <summary>Recalculates it with the current job, without a confirmation: this sends nothing and loses nothing.</summary>
    public LongCommand Recalculate { get; }

    /// <summary>Reports that the piece is cut.</summary>
    public Command Release { get; }

    /// <summary>Restores the previous program.</summary>
    public Command Revert { get; }

    /// <summary>True if it can be approved or rejected by a user who has the right.</summary>
    public bool IsUndecided => State is { } state && CorrectionSteps.Allows(state, CorrectionState.Rejected);

    /// <summary>True if it was computed with an earlier version of the job and is not sent yet, for a user who may reject it.</summary>
    public bool IsOutdated => IsUndecided && Detail!.IsOfChangedJob && _shell.Who is { } who && Rights.Allows(who.Role, Act.Reject);

    /// <summary>True if it is at its machine.</summary>
    public bool IsAtMachine => Detail?.Stored.Correction is { WaitsForRelease: true } correction
        && (correction.State != CorrectionState.Reverted || HasSlot(correction.Id));

    /// <summary>Why a button is disabled or missing; null if no explanation is needed.</summary>
    public string? Forbidden => Detail is null || _shell.Who is not { } who ? null
        : !IsUndecided && !IsAtMachine ? Ended
        : _pause.IsOn ? Texts.Current["Compensation.Changed"]
        : Detail.Stored.Correction.IsUndecided && !Rights.Allows(who.Role, Act.Approve)
            ? Texts.Current["Compensation.ApproveTakesSetter"]
        : State is CorrectionState.Verified && !Rights.Allows(who.Role, Act.Revert) ? Texts.Current["Compensation.RevertTakesSetter"]
        : State is CorrectionState.Verified && Detail.Stored.Correction.PreviousSha256 is null ? Texts.Current["Compensation.NothingBefore"]
        : null;

    /// <summary>The next step, who takes it, and what a person has to do; null if that is a decision here, if <see cref="Waits"/>
    /// tells it, or if there is no next step.</summary>
    public string? Next => Detail?.Stored.Correction switch
    {
        null or { State: CorrectionState.Proposed } => null,
        _ when Waits is not null => null,
        { State: CorrectionState.Released } cut when !IsToBeMeasured(cut) => null,
        { State: CorrectionState.Verified, Machine: { } machine } when Detail.Stored.LacksToolCall =>
            Texts.Current.With("Next.NoToolCall", machine),
        var correction => NextStep.Of(Station.Settings, Station.State.Status, correction),
    };

    // Why there is nothing to decide; null while it is being sent.
    private string? Ended => State is not { } state ? null : state switch
    {
        CorrectionState.Uploading => null,
        CorrectionState.Archived or CorrectionState.Recognized or CorrectionState.Computed => Texts.Current["Compensation.Computing"],
        CorrectionState.Proposed or CorrectionState.Approved or CorrectionState.Verified or CorrectionState.Released
            or CorrectionState.Superseded or CorrectionState.Recorded or CorrectionState.Refused or CorrectionState.Rejected
            or CorrectionState.Failed or CorrectionState.Reverted => Texts.Current["Compensation.Done"],
    };

    /// <summary>What was decided about the correction before this one; null if this one was not opened by that.</summary>
    public string? Decided => _decided is var (act, title) ? Texts.Current.With("Compensation.Decided." + act, title) : null;

    /// <summary>Why the user's last action failed; null if there is no message. It stays until another correction is selected.</summary>
    public string? Undone
    {
        get => _undone;
        private set => Set(ref _undone, value);
    }

    /// <summary>Completes when the selection is shown.</summary>
    internal Task Loading { get; private set; } = Task.CompletedTask;

    // The last piece cut with it, whose counterpart is not measured yet.
    private bool IsToBeMeasured(Correction cut) =>
        Station.State.LastCut.GetValueOrDefault((cut.Machine!, cut.Slot!)) is { IsMating: true, Counterpart: null } last
            && last.Correction.Id == cut.Id;

    // Not part of the details: the correction ahead of it can change while it stays the same.
    private WaitReason? Wait => Detail is { } detail ? WaitOf(detail.Stored.Correction) : null;

    private WaitReason? WaitOf(Correction correction) => Station.State.Status is { } status ? WaitReason.Of(status, correction.Id) : null;

    private CorrectionState? State => Detail?.Stored.Correction.State;

    /// <inheritdoc/>
    public void LookAt(long correction)
    {
        _choice.Open();
        Look(correction);
        Refresh();
    }

    /// <summary>Shows it with its warnings first.</summary>
    /// <param name="correction">Its number.</param>
    public void LookAtWarnings(long correction)
    {
        // Rebuild it even if it is already shown.
        (_isAtWarnings, _shown) = (true, (0, -1, false));
        LookAt(correction);
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
        // Rebuild the view in the other language.
        _shown = (0, -1, false);
        Refresh();
    }

    private Command Decision(Act act) => new(
        () =>
        {
            var detail = Detail!;
            Sign(kept =>
            {
                var signing = DecisionSigning.Of(_shell, act, kept, () => detail.Now().Facts);
                signing.Signed += () => OpenNext(act, kept.Correction.Id);
                return signing;
            });
        },
        () => IsDecidable && DecisionSigning.IsPossible(_shell, act, Detail!.Stored.Correction));

    // The next one down the list that waits for this user's decision, or the first one. It is not what the user tapped, so it takes no
    // decision for a moment. If none waits, the decided one stays, so that the user sees what becomes of it.
    private void OpenNext(Act act, long decided)
    {
        if (_choice.Next(Rows, decided) is not { } next)
        {
            return;
        }

        _choice.Look(next);
        (_isExpected, Undone) = (false, null);
        Choose(next);
        _decided = (act, Rows.First(r => r.Id == decided).Title);
        OnPropertyChanged(nameof(Decided));
    }

    private async Task RecalculateAsync()
    {
        var (id, by) = (Detail!.Stored.Correction.Id, _shell.Who!);
        _choice.Look(id);
        Undone = null;
        Correction? given = null;
        var failure = await Failures.OfAsync(
            () =>
            {
                Station.Users.Demand(by, Act.Reject);
                given = new Recalculation(Station.Settings, Station.Store).Recalculate(id, by.Name, null);
            },
            Station.Clock);
        if (_choice.Current != id)
        {
            return;
        }

        if (failure is not null)
        {
            Undone = failure;
            return;
        }

        // Wait for the new result.
        Look(given!.Id);
        Choose(given.Id);
    }

    // The decision applies to what is shown. Keep it selected, so that the user sees the outcome.
    private void Sign(Func<StoredCorrection, SigningViewModel> signing)
    {
        var kept = Detail!.Stored;
        _choice.Look(kept.Correction.Id);
        _shell.Sign(signing(kept));
    }

    // The selected correction is shown, and has been for a while.
    private bool IsDecidable => !_pause.IsOn && Detail is { } detail && detail.Stored.Correction.Id == _choice.Current;

    private void Refresh()
    {
        if (Station.State.Status is not { } status)
        {
            OnPropertyChanged(nameof(IsEmpty));
            return;
        }

        _heldUp = [.. status.Slots.SelectMany(s => s.HeldUp).Select(h => h.Correction.Id)];

        // In the order of measuring, whatever their state, so that no row moves under a finger.
        Correction[] undecided = [.. status.Failed, .. status.Proposed], held = [.. status.Slots.Select(s => s.Held).OfType<Correction>()];
        Correction[] all = [
            .. undecided.Concat(held)
                .Concat(status.Slots.SelectMany(s => s.Approved))
                .OrderBy(c => c.Turn)
                .ThenBy(c => c.Id)];
        var listed = IsFiltered ? [.. all.Where(IsMeant)] : all;
        _all = all.Length;
        _rejectable = [.. listed.Where(c => CorrectionSteps.Allows(c.State, CorrectionState.Rejected))];
        Rows.Show([.. listed.Select(Row)]);
        OnPropertyChanged(nameof(IsEmpty));
        OnPropertyChanged(nameof(Listed));
        OnPropertyChanged(nameof(CanRejectShown));
        RejectShown.Refresh();
        var waiting = _shell.Who is { } who && !Rights.Allows(who.Role, Act.Approve) ? undecided.Concat(held) : undecided;
        Choose(_choice.Follow(Rows, waiting, status.InWork));
    }

    private bool IsFiltered => !string.IsNullOrWhiteSpace(Filter);

    // Each word is somewhere in what the row says, or in where the program goes.
    private bool IsMeant(Correction c)
    {
        string[] said = [
            CorrectionLabel.Of(c), Station.JobNames.Of(c) ?? "", c.Job ?? "", Texts.Current.Word(c.State), c.Machine ?? "", c.Slot ?? ""];
        return Filter.Split(' ', StringSplitOptions.RemoveEmptyEntries)
            .All(w => said.Any(s => s.Contains(w, StringComparison.OrdinalIgnoreCase)));
    }

    private void SignRejections()
    {
        const int Most = 20;
        var (meant, changed) = (_rejectable, 0);
        var signing = new SigningViewModel(
            Station,
            _shell.Who!,
            Act.Reject,
            Texts.Current.With("Compensation.Corrections", Shown.Count(meant.Length)),
            needsReason: true,
            (by, reason, cancellation) =>
            {
                changed = 0;
                foreach (var correction in meant)
                {
                    cancellation.ThrowIfCancellationRequested();

                    // What somebody decided or recalculated meanwhile is not what was listed.
                    if (Station.Store.Find(correction.Id)?.Version != correction.Version)
                    {
                        changed++;
                        continue;
                    }

                    try
                    {
                        new CorrectionDecisions(Station.Store).Reject(correction.Id, by.Name, reason!);
                    }
                    catch (DecisionException)
                    {
                        changed++;
                    }
                }

                return Task.CompletedTask;
            })
        {
            TitleKey = "Compensation.RejectShown",
            Known = () => [
                .. meant.Take(Most).Select(
                    c => new Fact(string.Join(" · ", [CorrectionLabel.Of(c), Station.JobNames.Of(c) ?? ""]), Severity.Quiet)),
                .. meant.Length > Most
                    ? [new Fact(Texts.Current.With("Compensation.AndMore", Shown.Count(meant.Length - Most)), Severity.Attention)]
                    : Array.Empty<Fact>(),
            ],
        };
        signing.Signed += () => Undone = changed == 0 ? null
            : Texts.Current.With("Compensation.NotAllRejected", Shown.Count(changed), Shown.Count(meant.Length));
        _shell.Sign(signing);
    }

    private bool IsOfChangedJob(long id) => Station.State.OfChangedJob.Contains(id);

    private bool HasSlot(long id) => Station.State.Status?.Slots.Any(s => s.Held?.Id == id) == true;

    // The user's own choice needs no pause.
    private void Look(long id)
    {
        _choice.Look(id);
        (_isExpected, Undone, _decided) = (true, null, null);
        OnPropertyChanged(nameof(Decided));
    }

    private void Choose(long? id)
    {
        _chosen = Rows.FirstOrDefault(r => r.Id == id);
        OnPropertyChanged(nameof(Chosen));
        OnDecisionsChanged();
        if (id is { } shown)
        {
            Loading = LoadAsync(shown).Watched();
        }
        else
        {
            // The first one to arrive appears on an empty screen.
            _isExpected = false;
        }
    }

    private async Task LoadAsync(long id)
    {
        CorrectionDetail? read = null;
        var (shown, detail, isOfChangedJob) = (_shown, Detail, IsOfChangedJob(id));
        var isRead = await TryAsync(() =>
        {
            if (Station.Store.Find(id) is { } correction && (correction.Id, correction.Version, isOfChangedJob) != shown)
            {
                var kept = detail?.Stored is { } known && known.Correction.Id == id && known.Correction.Version == correction.Version
                    ? known
                    : StoredCorrection.Read(Station.Store, correction).With(Station.Settings);
                read = new(kept, Station.Clock) { IsOfChangedJob = isOfChangedJob };
            }
        });

        // Another one may have been selected meanwhile.
        if (!isRead || _choice.Current != id)
        {
            return;
        }

        // Of several concurrent loads, the first one to finish is shown and stays.
        if (read is not null && (id, read.Stored.Correction.Version, isOfChangedJob) != _shown)
        {
            _shown = (id, read.Stored.Correction.Version, isOfChangedJob);
            if (!_isExpected && (Detail is not { Stored.Correction: var was } || (was.Id, was.Version, Detail.IsOfChangedJob) != _shown))
            {
                _pause.Begin();
            }

            var now = read.Now();
            (now.IsAtWarnings, _isAtWarnings) = (_isAtWarnings, false);
            Detail = now;
        }

        _isExpected = false;
        OnDecisionsChanged();

        // Not if the screen is only being rehearsed.
        if (_shell.Current == this)
        {
            _choice.Remember();
        }
    }

    private void OnDecisionsChanged()
    {
        OnPropertyChanged(nameof(IsUndecided));
        OnPropertyChanged(nameof(IsOutdated));
        OnPropertyChanged(nameof(IsAtMachine));
        OnPropertyChanged(nameof(Forbidden));
        OnPropertyChanged(nameof(Waits));
        OnPropertyChanged(nameof(WaitsSeverity));
        OnPropertyChanged(nameof(Next));
        foreach (var command in new[] { Approve, Reject, Release, Revert })
        {
            command.Refresh();
        }

        Recalculate.Refresh();
    }

    private ListedCorrection Row(Correction c) => new(
        c.Id,
        CorrectionLabel.Of(c),
        Station.JobNames.Of(c) ?? "",
        Texts.Current.Word(c.State),
        c.LargestMm is { } mm ? Shown.Mm(mm) : "",
        _heldUp.Contains(c.Id) ? Severity.Attention : CorrectionLabel.SeverityOf(c.State),
        IsOfChangedJob(c.Id));
}
