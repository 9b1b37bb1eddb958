using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>On-line compensation: what will change at the machine, before it changes, and the decision about it.</summary>
public sealed class CompensationViewModel : ScreenViewModel, ILooksAt
{
    private readonly ShellViewModel _shell;
    private CorrectionRow? _chosen;
    private long? _looked;
    private CorrectionDetail? _detail;
    private (long Id, int Version) _shown = (0, -1);
    private int _tab;

    /// <summary>The screen.</summary>
    public CompensationViewModel(ShellViewModel shell)
        : base((shell ?? throw new ArgumentNullException(nameof(shell))).Station)
    {
        _shell = shell;
        Approve = Decision(Act.Approve, needsReason: false, (id, by, reason, _) => Do(() => new CorrectionDecisions(Station.Store).Approve(id, by, reason)));
        Reject = Decision(Act.Reject, needsReason: true, (id, by, reason, _) => Do(() => new CorrectionDecisions(Station.Store).Reject(id, by, reason!)));
        Release = Decision(Act.Release, needsReason: false, (id, by, reason, _) => Do(() => new CorrectionDecisions(Station.Store).Release(id, by, reason)));
        Revert = Decision(Act.Revert, needsReason: true, (id, by, reason, cancellation) => new SlotReversal(Station.Settings, Station.Store, Station.Open, Station.Clock).RevertAsync(id, by, reason!, cancellation));
        Refresh();
    }

    /// <summary>What can be decided about, and what is on its way or at a machine.</summary>
    public RowList<CorrectionRow> Rows { get; } = [];

    /// <summary>True if there is nothing in <see cref="Rows"/>.</summary>
    public bool IsEmpty => Rows.Count == 0;

    /// <summary>The correction that is looked at. Until a person chooses one, it is the one that came last.</summary>
    public CorrectionRow? Chosen
    {
        get => _chosen;
        set
        {
            if (value is not null && value != _chosen)
            {
                _looked = value.Id;
                Choose(value);
            }
        }
    }

    /// <summary>What is known of it; null while nothing is chosen.</summary>
    public CorrectionDetail? Detail
    {
        get => _detail;
        private set => Set(ref _detail, value);
    }

    /// <summary>Which side of it is looked at: points, lengths and angles, program, gap, decisions, course.</summary>
    public int Tab
    {
        get => _tab;
        set => Set(ref _tab, value);
    }

    /// <summary>Lets it go to its machine.</summary>
    public Command Approve { get; }

    /// <summary>Decides against it.</summary>
    public Command Reject { get; }

    /// <summary>Says that the piece is cut.</summary>
    public Command Release { get; }

    /// <summary>Brings back the program before.</summary>
    public Command Revert { get; }

    /// <summary>True where it can be approved or rejected, by whoever may.</summary>
    public bool IsUndecided => State is CorrectionState.Proposed or CorrectionState.Failed or CorrectionState.Approved;

    /// <summary>True where it is at its machine.</summary>
    public bool IsAtMachine => State is CorrectionState.Verified or CorrectionState.Reverted;

    /// <summary>Why a button cannot be pressed by who sits here; null if none is.</summary>
    public string? Forbidden => Detail is null || _shell.Who is not { } who ? null
        : State is CorrectionState.Proposed or CorrectionState.Failed && !Rights.Allows(who.Role, Act.Approve) ? Texts.Current["Compensation.ApproveTakesSetter"]
        : State is CorrectionState.Verified && !Rights.Allows(who.Role, Act.Revert) ? Texts.Current["Compensation.RevertTakesSetter"]
        : null;

    /// <summary>Done when what is chosen is shown.</summary>
    internal Task Loading { get; private set; } = Task.CompletedTask;

    private CorrectionState? State => Detail?.Kept.Correction.State;

    /// <inheritdoc/>
    public void LookAt(long correction)
    {
        _looked = correction;
        Refresh();
    }

    /// <inheritdoc/>
    protected override void Follow() => Refresh();

    /// <inheritdoc/>
    protected override void Translate()
    {
        // What is shown is made anew, in other words.
        _shown = (0, -1);
        Refresh();
    }

    private static Task Do(Action act)
    {
        act();
        return Task.CompletedTask;
    }

    private Command Decision(Act act, bool needsReason, Func<long, string, string?, CancellationToken, Task> carryOut) => new(
        () =>
        {
            var correction = Detail!.Kept.Correction;
            _shell.Sign(new(Station, _shell.Who!, act, CorrectionLabel.Of(correction), needsReason, (by, reason, cancellation) => carryOut(correction.Id, by.Name, reason, cancellation)));
        },
        () => _shell.Who is { } who && Rights.Allows(who.Role, act) && Detail?.Kept.Correction is { } c && act switch
        {
            Act.Approve => c.State is CorrectionState.Proposed || (c.State is CorrectionState.Failed && c.ProgramSha256 is not null),
            Act.Reject => IsUndecided,
            Act.Revert => c is { State: CorrectionState.Verified, PreviousSha256: not null },
            _ => IsAtMachine,
        });

    private void Refresh()
    {
        if (Station.State.Status is not { } status)
        {
            return;
        }

        Rows.Show([.. status.Failed.Select(c => Row(c, Severity.Alarm)), .. status.Proposed.Select(c => Row(c, Severity.Attention)), .. status.Slots.SelectMany(s => s.Next.Where(c => c.State == CorrectionState.Approved)).Select(c => Row(c, Severity.Quiet)), .. status.Slots.Where(s => s.Held is not null).Select(s => Row(s.Held!, Severity.Quiet))]);
        Say(nameof(IsEmpty));

        // What a person looks at stays, also when it has left the list; else it is what the gauge delivered last.
        var row = Rows.FirstOrDefault(r => r.Id == _looked) ?? (_looked is null ? Rows.Where(r => r.Severity != Severity.Quiet).MaxBy(r => r.Id) ?? Rows.FirstOrDefault() : null);
        Choose(row);
    }

    private void Choose(CorrectionRow? row)
    {
        _chosen = row;
        Say(nameof(Chosen));
        if ((row?.Id ?? _looked) is { } id)
        {
            Loading = LoadAsync(id).Watched();
        }
    }

    private async Task LoadAsync(long id)
    {
        KeptCorrection? kept = null;
        var (shown, detail) = (_shown, Detail);
        var isRead = await TryAsync(() =>
        {
            if (Station.Store.Find(id) is { } correction && (correction.Id, correction.Version) != shown)
            {
                kept = detail?.Kept is { } known && known.Correction.Id == id && known.Correction.Version == correction.Version ? known : KeptCorrection.Read(Station.Store, correction);
            }
        });

        // Somebody may have chosen another one meanwhile.
        if (isRead && kept is not null && (_chosen?.Id ?? _looked) == id)
        {
            _shown = (id, kept.Correction.Version);
            Detail = new(kept, Station.Clock);
            Say(nameof(IsUndecided));
            Say(nameof(IsAtMachine));
            Say(nameof(Forbidden));
            foreach (var command in new[] { Approve, Reject, Release, Revert })
            {
                command.Refresh();
            }
        }
    }

    private static CorrectionRow Row(Correction c, Severity severity) =>
        new(c.Id, CorrectionLabel.Of(c), Texts.Current.Word(c.State), c.LargestMm is { } mm ? Shown.Mm(mm) + " mm" : "", severity);
}
