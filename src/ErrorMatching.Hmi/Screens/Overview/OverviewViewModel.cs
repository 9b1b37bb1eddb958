using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Overview: whether all is well, and one tap to anything that is not.</summary>
public sealed class OverviewViewModel : ScreenViewModel
{
    // More than anybody looks through here: all of them are in the on-line compensation.
    private const int Most = 100;

    private readonly Action<long>? _look;
    private readonly Action<long>? _lookAtPiece;
    private int _elsewhere;

    /// <summary>The overview of a cell.</summary>
    /// <param name="station">The station.</param>
    /// <param name="look">Opens a correction; null before sign-in.</param>
    /// <param name="lookAtPiece">Opens the verification of a measured piece; null before sign-in.</param>
    /// <param name="lookAtAll">Opens the list of all corrections; null before sign-in.</param>
    /// <param name="lookAtAlarms">Opens the list of alarms; null before sign-in.</param>
    public OverviewViewModel(
        Station station, Action<long>? look, Action<long>? lookAtPiece, Action? lookAtAll, Action? lookAtAlarms)
        : base(station)
    {
        LookAtApprovals = new(() => lookAtAll?.Invoke(), () => lookAtAll is not null);
        LookAtAlarms = new(() => lookAtAlarms?.Invoke(), () => lookAtAlarms is not null);
        (_look, _lookAtPiece) = (look, lookAtPiece);
        LookAtAll = new(() => lookAtAll?.Invoke(), () => lookAtAll is not null && _elsewhere > 0);
        Refresh();
    }

    public RowList<SlotTile> Slots { get; } = [];

    public RowList<GaugeTile> Gauges { get; } = [];

    /// <summary>Corrections that wait for a person, have failed, or are on their way, worst first: the first hundred.</summary>
    public RowList<WaitingTile> Waiting { get; } = [];

    /// <summary>How many more wait than <see cref="Waiting"/> lists, and where they are listed, and how many of those that are not
    /// calculated yet it leaves out, which no other list has; null if it lists all.</summary>
    public string? More { get; private set; }

    /// <summary>Opens the list of all corrections.</summary>
    public Command LookAtAll { get; }

    /// <summary>Opens the list of all corrections at the ones to approve.</summary>
    public Command LookAtApprovals { get; }

    /// <summary>Opens the list of alarms.</summary>
    public Command LookAtAlarms { get; }

    /// <summary>The name of the cell.</summary>
    public string CellName => Station.Settings.Name;

    /// <summary>The time of day.</summary>
    public string TimeOfDay { get; private set; } = "";

    /// <summary>How many alarms there are but for shelved ones, and how many of them nobody has acknowledged; null for none.</summary>
    public string? Alarms { get; private set; }

    /// <summary>The number of those alarms.</summary>
    public int AlarmCount { get; private set; }

    /// <summary>Alarm if one of them has more than low priority.</summary>
    public Severity AlarmSeverity { get; private set; }

    /// <summary>How many corrections need approval, in words; null for none.</summary>
    public string? Approvals { get; private set; }

    /// <summary>The number of corrections that need approval.</summary>
    public long ApprovalCount { get; private set; }

    /// <summary>The number of corrections that are calculated or on their way to a machine.</summary>
    public int OnTheirWayCount { get; private set; }

    /// <summary>How many approvals and measured pieces wait; empty if none do, or if <see cref="Summary"/> has the numbers.</summary>
    public string Counts { get; private set; } = "";

    /// <summary>The state of the cell, in a sentence.</summary>
    public string Summary { get; private set; } = "";

    /// <summary>Severity of the cell's state.</summary>
    public Severity Severity { get; private set; }

    /// <summary>True if <see cref="Waiting"/> is empty.</summary>
    public bool IsNothingWaiting => Waiting.Count == 0;

    /// <summary>True if a tap opens something.</summary>
    public bool CanLook => _look is not null;

    /// <summary>Opens a correction.</summary>
    public void Look(long correction) => _look?.Invoke(correction);

    /// <summary>Opens the verification of a measured piece.</summary>
    public void LookAtPiece(long counterpart) => _lookAtPiece?.Invoke(counterpart);

    /// <inheritdoc/>
    protected override void Follow() => Refresh();

    private void Refresh()
    {
        TimeOfDay = Shown.TimeOfDay(Station.Clock.GetUtcNow(), Station.Clock);
        if (Station.State.Status is not { } status)
        {
            (Summary, Severity) = Station.State.StoreTrouble is null
                ? (Texts.Current["Overview.Looking"], Severity.Quiet)
                : (Texts.Current["Overview.StoreAway"], Severity.Alarm);
            OnPropertyChanged();
            return;
        }

        var texts = Texts.Current;
        Slots.Show([.. status.Slots.Select(s => Tile(status, s))]);
        Gauges.Show([.. Station.Settings.Gauges.Select(g => Tile(status, g))]);
        Func<WaitingTile>[] waiting = [
            .. status.Failed.Select(c => (Func<WaitingTile>)(() => Tile(c, Severity.Alarm))),
            .. OutsidePieces.Of(Station.Outside).Select(p => (Func<WaitingTile>)(() => Tile(p))),
            .. status.Proposed.Select(c => (Func<WaitingTile>)(() => Tile(c, Severity.Quiet))),
            .. status.Slots.SelectMany(s => s.Approved).Select(c => (Func<WaitingTile>)(() => Tile(status, c))),
            .. status.InWork.Select(c => (Func<WaitingTile>)(() => Tile(c, Severity.Quiet)))];
        Waiting.Show([.. waiting.Take(Most).Select(w => w())]);
        var left = Math.Max(0, waiting.Length - Most);
        var inWork = Math.Min(left, status.InWork.Count);
        _elsewhere = left - inWork;
        More = left == 0 ? null : Sentence.Joined(
        [
            .. _elsewhere > 0 ? new[] { texts.With("Overview.More", Shown.Count(_elsewhere)) } : [],
            .. inWork > 0 ? new[] { texts.With("Overview.MoreInWork", Shown.Count(inWork)) } : [],
        ]);
        LookAtAll.Refresh();
        Count(status);
        var (failed, proposed) = (status.CountOf(CorrectionState.Failed), status.CountOf(CorrectionState.Proposed));
        string[] counts = [
            .. new[]
            {
                CountOf("Overview.Approvals", proposed),
                CountOf("Overview.PiecesOutside", Station.Outside.Count)
            }.OfType<string>()];
        Counts = counts.Length == 1 && failed == 0 && status.IsRunning ? "" : string.Join(" · ", counts);
        (Summary, Severity) =
            Station.State.StoreTrouble is not null ? (texts["Overview.StoreAway"], Severity.Alarm)
            : !status.IsRunning ? (texts["Overview.NotRunning"], Severity.Alarm)
            : failed > 0 ? (texts.With("Overview.Failed", Shown.Count(failed)), Severity.Alarm)
            : Troubles(status) is { Count: > 0 } troubles ? (texts.With("Overview.Troubles", Shown.Count(troubles.Count)), Severity.Alarm)
            : Station.Outside is { Count: > 0 } outside ? (texts.With("Overview.Outside", Shown.Count(outside.Count)), Severity.Attention)
            : proposed > 0 ? (texts.With("Overview.Proposed", Shown.Count(proposed)), Severity.Quiet)
            : Slots.Count(s => s.Severity != Severity.Quiet) is > 0 and var slots
                ? (texts.With("Overview.SlotsWait", Shown.Count(slots)), Severity.Attention)
            : (texts["Overview.Well"], Severity.Quiet);
        OnPropertyChanged();
    }

    private void Count(CellStatus status)
    {
        var texts = Texts.Current;
        SeenAlarm[] alarms = [.. SeenAlarm.Of(Station).Where(a => !a.IsShelved)];
        var unknown = alarms.Count(a => !a.IsAcknowledged);
        AlarmCount = alarms.Length;
        AlarmSeverity = alarms is [{ Alarm.Priority: > AlarmPriority.Low }, ..] ? Severity.Alarm
            : alarms.Length > 0 ? Severity.Attention : Severity.Quiet;
        Alarms = alarms.Length == 0 ? null
            : texts.Counted("Overview.Alarms", alarms.Length, Shown.Count(alarms.Length), Shown.Count(unknown));
        ApprovalCount = status.CountOf(CorrectionState.Proposed);
        Approvals = CountOf("Overview.Approvals", ApprovalCount);
        OnTheirWayCount = status.InWork.Count + status.Slots.Sum(s => s.Approved.Count);
    }

    private static string? CountOf(string key, long count) =>
        count == 0 ? null : Texts.Current.Counted(key, (int)count, Shown.Count(count));

    private static IReadOnlyList<CellTrouble> Troubles(CellStatus status) => status.IsRunning ? status.Heartbeat!.Troubles : [];

    private SlotTile Tile(CellStatus status, SlotStatus slot)
    {
        var texts = Texts.Current;
        var name = $"{slot.Machine.Name}/{slot.Slot.Name}";
        var trouble = Troubles(status).FirstOrDefault(t => t.Concerns(slot.Machine.Name, slot.Slot.Name));

        // A correction without approval is not queued.
        var proposed = slot.Line.Count(c => c.State == CorrectionState.Proposed);
        var inLine = Math.Max(0, slot.Waiting - proposed);
        var waiting = (inLine == 0 ? texts["Overview.NoneWaiting"] : texts.With("Overview.InLine", Shown.Count(inLine)))
            + (proposed == 0 ? "" : texts.With("Overview.ToApprove", Shown.Count(proposed)))
            + (slot.Report is { } report ? " · " + texts.With("Overview.MachineIs", Words(report.State)) : "");
        return (trouble, slot.Held) switch
        {
            ({ } t, var held) => new(
                name,
                slot.Slot.Program,
                texts["Overview.SlotTrouble"],
                CodeText.Of(t.Code, t.Statement),
                waiting,
                Severity.Alarm,
                held?.Id),
            (_, not { State: not CorrectionState.Uploading }) when slot.Delivery is { } delivery => new(
                name,
                slot.Slot.Program,
                texts["Overview.WaitsForMachine"],
                RecordedText.Of(delivery.Statement),
                waiting,
                Severity.Quiet,
                delivery.Correction),
            (_, { State: CorrectionState.Reverted } held) => new(
                name,
                slot.Slot.Program,
                texts.Word(held.State),
                texts.With("Overview.TakenBack", CorrectionLabel.Of(held)),
                waiting,
                Severity.Attention,
                held.Id),
            (_, { } held) => new(
                name,
                slot.Slot.Program,
                texts.Word(held.State),
                $"{Label(held)}\n{Shown.Time(held.ChangedAt, Station.Clock)}",
                waiting,
                Severity.Quiet,
                held.Id),
            _ when slot.HeldUp is [{ Behind: [var first, ..] } up, ..] => new(
                name,
                slot.Slot.Program,
                texts["Overview.HeldUp"],
                texts.With("Overview.HeldUpBy", CorrectionLabel.Of(up.Correction), CorrectionLabel.Of(first)),
                waiting,
                Severity.Attention,
                first.Id),
            _ when Station.State.LastCut.GetValueOrDefault((slot.Machine.Name, slot.Slot.Name)) is { } last =>
                new(name, slot.Slot.Program, texts["Overview.Free"], Words(last), waiting, Severity.Quiet, last.Correction.Id)
                {
                    IsPiece = last.IsMating
                },
            _ => new(
                name,
                slot.Slot.Program,
                texts["Overview.Free"],
                texts[slot.Holding.ProgramSha256 is null ? "Overview.NothingSent" : "Overview.LastReleased"],
                waiting,
                Severity.Quiet,
                null),
        };
    }

    private static string Words(MachineState state) => string.Join(
        ' ',
        new[] { Texts.Current["RecordedWord." + state.Activity.ToString().ToLowerInvariant()], state.Named }.Where(w => w.Length > 0));

    private static string Words(LastCut last) => last switch
    {
        { IsMating: false } => Texts.Current.With("Overview.LastSurface", CorrectionLabel.Of(last.Correction)),
        { Counterpart: { } counterpart } =>
            Texts.Current.With("Overview.LastVerified", CorrectionLabel.Of(last.Correction), "#" + Shown.Id(counterpart.Id)),
        _ => Texts.Current.With("Overview.LastCut", CorrectionLabel.Of(last.Correction)),
    };

    private GaugeTile Tile(CellStatus status, GaugeSettings gauge)
    {
        var texts = Texts.Current;
        var source = gauge.Machine is { } machine
            ? texts.With("Overview.AtMachine", machine)
            : Path.GetFileName(Path.TrimEndingDirectorySeparator(gauge.Incoming ?? ""));
        var trouble = Troubles(status).FirstOrDefault(t => t.Where == CellTrouble.OfGauge(gauge.Name)
            || t.Where == CellTrouble.OfFolder(gauge.Name) || t.Where == CellTrouble.OfBacklog(gauge.Name));
        return trouble is null
            ? new(gauge.Name, source, status.IsRunning ? WaitingAt(status, gauge) : texts["Overview.GaugeNotWatched"], Severity.Quiet)
            : new(gauge.Name, source, CodeText.Of(trouble.Code, trouble.Statement), Severity.Alarm);
    }

    private string WaitingAt(CellStatus status, GaugeSettings gauge)
    {
        var texts = Texts.Current;
        var backlog = status.Backlog.FirstOrDefault(b => b.Gauge == gauge.Name);
        string[] lines = [
            .. new[]
            {
                Line("Overview.FilesWait", backlog?.Files ?? 0, backlog?.FilesSince),
                Line("Overview.PiecesWait", backlog?.Pieces ?? 0, backlog?.PiecesSince),
            }.OfType<string>()];
        return lines.Length == 0 ? texts["Overview.GaugeWatched"] : string.Join('\n', lines);

        string? Line(string key, long count, DateTimeOffset? since) => since is { } oldest
            ? texts.Counted(key, (int)Math.Min(count, int.MaxValue), Shown.Count(count), Shown.Time(oldest, Station.Clock)) : null;
    }

    private WaitingTile Tile(Correction correction, Severity severity) => Tile(
        correction,
        severity == Severity.Alarm && correction.Code is { } code
            ? CodeText.Of(code, correction.Reason)
            : string.Join(
                " · ", new[] { Texts.Current["Waiting." + correction.State], CorrectionLabel.Target(correction) }.OfType<string>()),
        severity);

    // Approved corrections are listed until they are sent, so that a delay is explained.
    private WaitingTile Tile(CellStatus status, Correction approved)
    {
        var wait = WaitReason.Of(status, approved.Id);
        return Tile(
            approved,
            $"{Texts.Current["Waiting." + approved.State]} · {wait?.Text ?? Texts.Current["Wait.Next"]}",
            wait?.Severity ?? Severity.Quiet);
    }

    private WaitingTile Tile(OutsidePieces outside) => new(
        outside.Newest.LastId,
        outside.Newest.JobName,
        CorrectionLabel.Of(outside.Newest.Counterpart!),
        string.Join(
            '\n',
            new[] { Texts.Current.With("Overview.Measured", PieceDetail.VerdictOf(outside.Newest)), outside.Others }.OfType<string>()),
        "",
        Shown.Time(outside.Newest.Counterpart!.ChangedAt, Station.Clock),
        Severity.Attention)
    {
        IsMeasured = true,
    };

    private WaitingTile Tile(Correction correction, string state, Severity severity) => new(
        correction.Id,
        Station.JobNames.Of(correction) ?? "",
        CorrectionLabel.Of(correction),
        state,
        correction.LargestMm is { } mm ? Shown.Mm(mm) + " mm" : "",
        Shown.Time(correction.ChangedAt, Station.Clock),
        severity)
    {
        IsOfChangedJob = Station.State.OfChangedJob.Contains(correction.Id),
    };

    private string Label(Correction correction) =>
        string.Join(" · ", new[] { Station.JobNames.Of(correction), CorrectionLabel.Of(correction) }.OfType<string>());
}

/// <summary>A machine's slot in the overview.</summary>
/// <param name="Name">Machine and slot.</param>
/// <param name="Program">The program's name at the machine.</param>
/// <param name="State">Its state, in a word.</param>
/// <param name="Detail">What it holds, and since when.</param>
/// <param name="Waiting">Number of queued corrections, and of those that will be queued after approval.</param>
/// <param name="Severity">Its severity.</param>
/// <param name="Correction">The correction to open; null if there is none.</param>
public sealed record SlotTile(string Name, string Program, string State, string Detail, string Waiting, Severity Severity, long? Correction)
{
    /// <summary>True if its piece was cut: a tap then opens the verification instead of the correction.</summary>
    public bool IsPiece { get; init; }

    public string AutomationId => "slot-" + Name;
}

/// <summary>A gauge in the overview.</summary>
/// <param name="Name">Its name.</param>
/// <param name="Source">Where its files come from.</param>
/// <param name="State">Its state, in a word or a sentence.</param>
/// <param name="Severity">Its severity.</param>
public sealed record GaugeTile(string Name, string Source, string State, Severity Severity)
{
    public string AutomationId => "gauge-" + Name;
}

/// <summary>In the overview: a correction that waits for a person or is on its way, or the newest counterpart of a workpiece that
/// was measured outside its limits.</summary>
/// <param name="Id">Its number.</param>
/// <param name="Job">The workpiece's name; empty before it is recognized.</param>
/// <param name="Title">Number and serial number or file.</param>
/// <param name="State">What it waits for.</param>
/// <param name="Largest">Its largest displacement in mm.</param>
/// <param name="Since">Since when it waits.</param>
/// <param name="Severity">Its severity.</param>
public sealed record WaitingTile(long Id, string Job, string Title, string State, string Largest, string Since, Severity Severity)
{
    /// <summary>True for a measured counterpart: a tap then opens the verification instead of the correction.</summary>
    public bool IsMeasured { get; init; }

    /// <summary>True if its job was changed after it was computed.</summary>
    public bool IsOfChangedJob { get; init; }

    /// <summary>True if its largest displacement is known.</summary>
    public bool HasLargest => Largest.Length > 0;

    /// <summary>Key of its icon: what waits in normal operation is neither well nor wrong.</summary>
    public string Icon => Severity switch { Severity.Alarm => "Icon.alarm", Severity.Attention => "Icon.attention", _ => "Icon.history" };

    /// <summary>Its name for screen readers.</summary>
    public string Name => Job.Length > 0 ? $"{Job} · {Title}" : Title;

    public string AutomationId => (IsMeasured ? "measured-" : "waiting-") + Shown.Id(Id);
}
