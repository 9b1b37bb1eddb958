using System.Text.RegularExpressions;
using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Alarms and audit trail: what is abnormal or waits, what to do next, and what happened.</summary>
internal sealed partial class MessagesViewModel : ScreenViewModel
{
    private const int Page = 200;

    // More than anybody reads at once: all corrections that wait are in the on-line compensation.
    private const int Most = 100;

    private const int Digits = 8;
    private readonly ShellViewModel _shell;
    private IReadOnlyList<AuditEntry> _entries = [];
    private TrailQuery _asked = new();
    private TrailQuery _read = new() { Most = 0 };
    private long _newest = -1;
    private bool _isReading;
    private AuditFinding? _finding;
    private string? _shelving;
    private string? _undone;
    private AlarmFilter _filter;
    private string _who = "";
    private string _about = "";
    private string _from = "";
    private string _to = "";
    private bool _isOnlyAlarms;
    private bool _isWrongDay;

    /// <summary>Creates the screen.</summary>
    /// <param name="shell">The shell.</param>
    public MessagesViewModel(ShellViewModel shell)
        : base((shell ?? throw new ArgumentNullException(nameof(shell))).Station)
    {
        _shell = shell;
        LookAtAll = new(() => shell.Go(ScreenKeys.Compensation));
        Filters = [.. Enum.GetValues<AlarmFilter>().Select(f => new AlarmFilterChoice(f))];
        Verify = new(async cancellation =>
        {
            AuditFinding? finding = null;
            if (await TryAsync(() => finding = new AuditTrail(Station.Store, Station.Settings).Verify(null, cancellation)))
            {
                _finding = finding;
                OnPropertyChanged(nameof(Finding));
                OnPropertyChanged(nameof(FindingSeverity));
            }
        });
        More = new(_ => ReadAsync(_entries.Count + Page), () => _entries.Count > 0 && _entries.Count == _read.Most);
        Search = new(_ => Ask() ? ReadAsync(Page) : Task.CompletedTask);
        Refresh();
    }

    /// <summary>Alarms, worst first, and below them what waits: the first hundred.</summary>
    public RowList<MessageRow> Messages { get; } = [];

    /// <summary>How many more there are, and where their corrections are listed; null if <see cref="Messages"/> has all.</summary>
    public string? Left { get; private set; }

    /// <summary>Opens the list of all corrections.</summary>
    public Command LookAtAll { get; }

    /// <summary>True if there are known to be no messages.</summary>
    public bool IsQuiet => Station.State is { Status: not null, StoreTrouble: null } && Messages.Count == 0;

    /// <summary>Why there are no messages.</summary>
    public string Quiet => Texts.Current[Filter.Filter == AlarmFilter.Now ? "Messages.Quiet" : "Messages.NoneShown"];

    /// <summary>What may be listed.</summary>
    public IReadOnlyList<AlarmFilterChoice> Filters { get; }

    /// <summary>What is listed.</summary>
    public AlarmFilterChoice Filter
    {
        get => Filters[(int)_filter];
        set
        {
            // A list rebuilt in another language briefly has no selection.
            if (value is not null && Set(ref _filter, value.Filter))
            {
                Refresh();
            }
        }
    }

    /// <summary>Why nothing was done about an alarm; null if it was.</summary>
    public string? Undone
    {
        get => _undone;
        private set => Set(ref _undone, value);
    }

    /// <summary>The audit trail, latest first.</summary>
    public RowList<TrailRow> Entries { get; } = [];

    /// <summary>Part of the name of who did it; empty for anybody.</summary>
    public string Who
    {
        get => _who;
        set => Set(ref _who, value ?? "");
    }

    /// <summary>Part of a serial number, work order, job, machine or user that it was done to; empty for anything.</summary>
    public string About
    {
        get => _about;
        set => Set(ref _about, value ?? "");
    }

    /// <summary>The first day, year-month-day or year/month/day; empty for any.</summary>
    public string From
    {
        get => _from;
        set => Set(ref _from, value ?? "");
    }

    /// <summary>The last day, likewise.</summary>
    public string To
    {
        get => _to;
        set => Set(ref _to, value ?? "");
    }

    /// <summary>True for what concerns alarms alone: their history.</summary>
    public bool IsOnlyAlarms
    {
        get => _isOnlyAlarms;
        set
        {
            if (Set(ref _isOnlyAlarms, value))
            {
                Search.Execute(null);
            }
        }
    }

    /// <summary>True if the last search was for something else than days. It stays until the next search.</summary>
    public bool IsWrongDay
    {
        get => _isWrongDay;
        private set => Set(ref _isWrongDay, value);
    }

    /// <summary>Searches the trail by the fields.</summary>
    public LongCommand Search { get; }

    /// <summary>Verifies every entry of the trail.</summary>
    public LongCommand Verify { get; }

    /// <summary>Shows older entries as well.</summary>
    public LongCommand More { get; }

    /// <summary>The result of verifying; null before.</summary>
    public string? Finding => _finding switch
    {
        null => null,
        { Fault: { } fault } => Texts.Current.With("Audit.Fault", Shown.Id(fault.Seq), Texts.Current.Word(fault.Kind)),
        { IsSealChecked: false } => Texts.Current.With("Audit.HoldsUnsealed", Shown.Count(_finding.Entries)),
        _ => Texts.Current.With("Audit.Holds", Shown.Count(_finding.Entries)),
    };

    /// <summary>A broken trail is an alarm.</summary>
    public Severity FindingSeverity =>
        _finding switch { { Fault: not null } => Severity.Alarm, { IsSealChecked: false } => Severity.Attention, _ => Severity.Quiet };

    /// <summary>Completes when the trail is read.</summary>
    internal Task Reading { get; private set; } = Task.CompletedTask;

    /// <summary>Completes when the last act on an alarm is stored.</summary>
    internal Task Acting { get; private set; } = Task.CompletedTask;

    /// <summary>Opens the subject of a message.</summary>
    public void Look(MessageRow message)
    {
        if (message is { IsOfAll: true })
        {
            LookAtAll.Execute(null);
        }
        else if (message?.Correction is { } correction)
        {
            (message.IsMeasured ? _shell.LookAtPiece : (Action<long>)_shell.Look)(correction);
        }
    }

    /// <summary>Records that the user knows of an alarm.</summary>
    public void Acknowledge(MessageRow message) => Take(message, Act.Acknowledge, (book, alarm, by) => book.Acknowledge(alarm, by));

    /// <summary>Offers times to shelve an alarm for, or takes the offer back.</summary>
    public void Offer(MessageRow message)
    {
        _shelving = message?.Alarm is { } alarm && _shelving != alarm.Key ? alarm.Key : null;
        Refresh();
    }

    /// <summary>Takes an alarm out of sight for a while.</summary>
    public void Shelve(MessageRow message, TimeSpan time) => Take(message, Act.Shelve, (book, alarm, by) => book.Shelve(alarm, time, by));

    /// <summary>Brings a shelved alarm back.</summary>
    public void Unshelve(MessageRow message) => Take(message, Act.Shelve, (book, alarm, by) => book.Unshelve(alarm, by));

    /// <inheritdoc/>
    protected override void Follow() => Refresh();

    /// <inheritdoc/>
    protected override void Translate()
    {
        foreach (var filter in Filters)
        {
            filter.Rename();
        }

        Refresh();
        Entries.Show([.. _entries.Select(Row)]);
        OnPropertyChanged();
    }

    private void Take(MessageRow message, Act act, Action<AlarmBook, Alarm, string> take)
    {
        if (message?.Alarm is { } alarm && _shell.Who is { } who && Acting.IsCompleted)
        {
            Acting = TakeAsync(
                () =>
                {
                    Station.Users.Demand(who, act);
                    take(new(Station.Store, Station.Clock), alarm, who.Name);
                }).Watched();
        }
    }

    private async Task TakeAsync(Action take)
    {
        _shelving = null;
        Undone = null;
        Undone = await Failures.OfAsync(take, Station.Clock);
        Refresh();
    }

    private void Refresh()
    {
        if (Station.State.Status is { } status)
        {
            Func<MessageRow>[] all = [.. Of(status)];
            Messages.Show([.. all.Take(Most).Select(m => m())]);
            Left = all.Length > Most ? Texts.Current.With("Message.More", Shown.Count(all.Length - Most)) : null;
            OnPropertyChanged(nameof(Left));
        }

        OnPropertyChanged(nameof(IsQuiet));
        OnPropertyChanged(nameof(Quiet));

        if (!_isReading)
        {
            Reading = ReadAsync(Math.Max(Page, _entries.Count)).Watched();
        }
    }

    private static string NextOf(CellTrouble trouble) => trouble.Code == CellCodes.ChangedAtMachine ? "Message.Changed.Next"
        : "Message.Trouble.Next";

    // Made only if they are listed.
    private IEnumerable<Func<MessageRow>> Of(CellStatus status)
    {
        foreach (var alarm in SeenAlarm.Of(Station).Where(a => a.IsShelved == (_filter == AlarmFilter.Shelved)))
        {
            if (_filter != AlarmFilter.New || !alarm.IsAcknowledged)
            {
                yield return () => Row(alarm);
            }
        }

        foreach (var waiting in _filter == AlarmFilter.Now ? Waiting(status) : [])
        {
            yield return waiting;
        }
    }

    // What a person does in normal operation is no alarm.
    private static IEnumerable<Func<MessageRow>> Waiting(CellStatus status)
    {
        var texts = Texts.Current;
        if (status.Proposed is [var proposed])
        {
            yield return () => new(
                Severity.Quiet,
                texts.With("Message.Proposed", CorrectionLabel.Of(proposed), Shown.Mm(proposed.LargestMm)),
                texts["Message.Proposed.Next"],
                proposed.Id);
        }
        else if (status.Proposed.Count > 1)
        {
            yield return () => new(
                Severity.Quiet,
                texts.With("Message.ProposedAll", Shown.Count(status.Proposed.Count)),
                texts["Message.ProposedAll.Next"],
                null)
            {
                IsOfAll = true,
                AutomationId = "message-proposed",
            };
        }

        foreach (var slot in status.Slots.Where(
            s => s.Held is { WaitsForRelease: true, State: var state } && (state != CorrectionState.Verified || s.Slot.ReadyFile is null)))
        {
            var (name, held) = ($"{slot.Machine.Name}/{slot.Slot.Name}", CorrectionLabel.Of(slot.Held!));
            yield return () => slot.Held!.State == CorrectionState.Reverted
                ? new(Severity.Quiet, texts.With("Message.TakenBack", name, held), texts["Message.TakenBack.Next"], slot.Held.Id)
                : new(Severity.Quiet, texts.With("Message.Taken", name, held), texts["Message.Taken.Next"], slot.Held.Id);
        }
    }

    private MessageRow Row(SeenAlarm seen)
    {
        var (texts, alarm, mark) = (Texts.Current, seen.Alarm, seen.Mark);
        var (severity, what, next, opens) = Words(alarm, seen.Outside);
        var (isKnown, isShelved) = (seen.IsAcknowledged, seen.IsShelved);
        var (acknowledges, shelves) = (May(Act.Acknowledge), May(Act.Shelve));
        return new(severity, what, next, opens)
        {
            Alarm = alarm,
            IsMeasured = alarm.Kind == AlarmKind.Outside,
            Marked = string.Join(
                " · ",
                new[]
                {
                    texts.Word(alarm.Priority),
                    alarm.Since is { } since ? texts.With("Alarm.Since", Shown.Time(since, Station.Clock)) : null,
                    isKnown ? texts.With("Alarm.Acknowledged", mark.AcknowledgedBy!, Shown.Time(mark.AcknowledgedAt!.Value, Station.Clock))
                        : texts["Alarm.New"],
                    isShelved ? texts.With("Alarm.Shelved", mark.ShelvedBy!, Shown.Time(mark.ShelvedUntil!.Value, Station.Clock)) : null,
                }.OfType<string>()),
            IsKnown = isKnown,
            CanAcknowledge = acknowledges && !isKnown && _shelving != alarm.Key,
            CanShelve = shelves && alarm.MayBeShelved && !isShelved && _shelving != alarm.Key,
            CanBringBack = shelves && isShelved,
            IsShelving = _shelving == alarm.Key && !isShelved,
            AutomationId = alarm.Kind switch
            {
                AlarmKind.HeldUp => "message-held-up-" + Shown.Id(alarm.Correction!.Id),
                AlarmKind.NotRunning => "message-not-running",
                _ when opens is { } id => "message-" + Shown.Id(id),
                _ => "message",
            },
        };
    }

    private bool May(Act act) => _shell.Who is { } who && Rights.Allows(who.Role, act);

    private (Severity Severity, string What, string Next, long? Opens) Words(Alarm alarm, OutsidePieces? outside)
    {
        var texts = Texts.Current;
        switch (alarm.Kind)
        {
            case AlarmKind.NotRunning:
                return (
                    Severity.Alarm,
                    alarm.Since is { } last ? texts.With("Message.NotRunningSince", Shown.Time(last, Station.Clock))
                        : texts["Message.NotRunning"],
                    texts["Message.NotRunning.Next"],
                    null);
            case AlarmKind.Trouble:
                var trouble = alarm.Trouble!;
                return (
                    Severity.Alarm,
                    $"{CodeText.Where(trouble.Where)} · {CodeText.Of(trouble.Code, trouble.Statement)}",
                    texts[NextOf(trouble)],
                    null);
            case AlarmKind.Tampered:
                return (Severity.Alarm, RecordedText.Of(alarm.Tampered!), texts["Message.Trouble.Next"], null);
            case AlarmKind.Failed:
                var failed = alarm.Correction!;
                var why = failed.Code is { } code ? CodeText.Of(code, failed.Reason) : failed.Reason?.Sentence;
                return (
                    Severity.Alarm,
                    $"{CorrectionLabel.Of(failed)} · {why}",
                    texts[failed.ProgramSha256 is null ? "Message.FailedUncomputed.Next" : "Message.Failed.Next"],
                    failed.Id);
            case AlarmKind.Outside:
                return (
                    Severity.Attention,
                    string.Join(
                        '\n',
                        new[]
                        {
                            texts.With("Message.Outside", CorrectionLabel.Of(alarm.Correction!), PieceDetail.VerdictOf(outside!.Newest)),
                            outside.Others,
                        }.OfType<string>()),
                    texts["Message.Outside.Next"],
                    outside.Newest.LastId);
            case AlarmKind.HeldUp:
                return (
                    Severity.Attention,
                    texts.With(
                        "Message.HeldUp",
                        CorrectionLabel.Of(alarm.Correction!),
                        $"{alarm.Slot!.Machine.Name}/{alarm.Slot.Slot.Name}",
                        WaitReason.Numbers(alarm.Behind)),
                    texts["Message.HeldUp.Next"],
                    alarm.Behind[0].Id);
            default:
                throw new InvalidOperationException($"No words for {alarm.Kind}.");
        }
    }

    // What is typed counts when it is searched for, not while it is typed. False if a date is invalid.
    private bool Ask()
    {
        if (!TypedDay.TryRead(From, 0, Station.Clock, out var from) || !TypedDay.TryRead(To, 1, Station.Clock, out var to))
        {
            IsWrongDay = true;
            return false;
        }

        IsWrongDay = false;

        _asked = new()
        {
            Who = Given(Who),
            About = Given(About),
            From = from,
            To = to,
            What = IsOnlyAlarms ? AlarmBook.Words : null,
        };
        return true;
    }

    // Reads again if something else was asked for meanwhile.
    private async Task ReadAsync(int most)
    {
        _isReading = true;
        try
        {
            TrailQuery sought;
            do
            {
                sought = _asked with { Most = most };
                IReadOnlyList<AuditEntry>? entries = null;
                var (newest, known) = (_newest, _read);
                var head = newest;
                if (!await TryAsync(() =>
                {
                    head = Station.Store.ChangeCount();
                    if (head != newest || sought != known)
                    {
                        entries = Station.Store.SearchTrail(sought);
                    }
                }))
                {
                    return;
                }

                if (entries is not null)
                {
                    (_entries, _newest, _read) = (entries, head, sought);
                    Entries.Show([.. _entries.Select(Row)]);
                    More.Refresh();
                }
            }
            while (sought != _asked with { Most = most });
        }
        finally
        {
            _isReading = false;
        }
    }

    private static string? Given(string text) => string.IsNullOrWhiteSpace(text) ? null : text.Trim();

    private TrailRow Row(AuditEntry entry) => new(
        Shown.Id(entry.Seq),
        Shown.Time(entry.At, Station.Clock),
        RecordedText.Who(entry.Who),
        Texts.Current.Or("Audited." + entry.What, entry.What),
        Short(RecordedText.Of(entry.Subject ?? "")),
        Short(RecordedText.Of(entry.Basis)));

    // The first digits identify a hash; the export has the whole one.
    private static string Short(string text) => Hash().Replace(text, m => m.Value[..Digits] + "…");

    [GeneratedRegex("[0-9a-f]{64}", RegexOptions.None, Timeout.Infinite)]
    private static partial Regex Hash();
}

/// <summary>What is listed of the alarms.</summary>
internal enum AlarmFilter
{
    /// <summary>All alarms that are not shelved, and what waits.</summary>
    Now,

    /// <summary>Alarms that nobody has acknowledged.</summary>
    New,

    /// <summary>Shelved alarms.</summary>
    Shelved,
}

/// <summary>What may be listed. The object stays the same in another language, so that it stays selected.</summary>
/// <param name="filter">What is listed.</param>
internal sealed class AlarmFilterChoice(AlarmFilter filter) : Observable
{
    public AlarmFilter Filter { get; } = filter;

    public string Name => Texts.Current.Word(Filter);

    /// <summary>Updates the name after a change of language.</summary>
    internal void Rename() => OnPropertyChanged(nameof(Name));
}

/// <summary>A message to the user, with what to do next.</summary>
/// <param name="Severity">Its severity.</param>
/// <param name="What">The situation.</param>
/// <param name="Next">What to do.</param>
/// <param name="Correction">The correction to open; null if there is none.</param>
internal sealed record MessageRow(Severity Severity, string What, string Next, long? Correction)
{
    /// <summary>The alarm; null for what waits in normal operation.</summary>
    public Alarm? Alarm { get; init; }

    /// <summary>Its priority, since when it lasts, who acknowledged it, and until when it is shelved; null if it is no alarm.</summary>
    public string? Marked { get; init; }

    /// <summary>True if somebody acknowledged it.</summary>
    public bool IsKnown { get; init; }

    /// <summary>True if the user may acknowledge it now.</summary>
    public bool CanAcknowledge { get; init; }

    /// <summary>True if the user may shelve it now.</summary>
    public bool CanShelve { get; init; }

    /// <summary>True if the user may bring it back now.</summary>
    public bool CanBringBack { get; init; }

    /// <summary>True while times to shelve it for are offered.</summary>
    public bool IsShelving { get; init; }

    /// <summary>True to open the verification of a measured piece instead.</summary>
    public bool IsMeasured { get; init; }

    /// <summary>True to open the list of all corrections.</summary>
    public bool IsOfAll { get; init; }

    /// <summary>Key of its icon: what waits is neither well nor wrong.</summary>
    public string Icon => Alarm is null ? "Icon.history" : Severity == Severity.Alarm ? "Icon.alarm" : "Icon.attention";

    /// <summary>True if a tap opens something.</summary>
    public bool CanLook => Correction is not null || IsOfAll;

    public string AutomationId { get; init; } = Correction is { } id ? "message-" + Shown.Id(id) : "message";

    public string AcknowledgeId => AutomationId + "-acknowledge";

    public string ShelveId => AutomationId + "-shelve";

    public string BackId => AutomationId + "-back";
}

/// <summary>A displayed entry of the audit trail.</summary>
/// <param name="Number">Its number.</param>
/// <param name="Time">Its time.</param>
/// <param name="Who">Who acted.</param>
/// <param name="What">The act.</param>
/// <param name="Subject">What it applied to.</param>
/// <param name="Basis">Its basis.</param>
public sealed record TrailRow(string Number, string Time, string Who, string What, string Subject, string Basis)
{
    // About two lines of its column.
    private const int LongBasis = 100;

    /// <summary>The basis; if it is long, only its first sentence.</summary>
    public string Short =>
        Basis.Length > LongBasis && Sentence.First(Basis) is { } first && first.Length < Basis.Length ? first + " …" : Basis;
}
