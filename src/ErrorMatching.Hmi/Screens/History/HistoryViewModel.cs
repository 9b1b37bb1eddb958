using System.Globalization;
using System.Runtime.CompilerServices;
using System.Text;
using ErrorMatching.Cell;
using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>History: finds every file that ever arrived, and reopens it exactly as it was.</summary>
internal sealed class HistoryViewModel : ScreenViewModel, ILooksAt, ITakesCodes
{
    private const int Most = 1000;
    private string _serial = "";
    private string _workOrder = "";
    private string _from = "";
    private string _to = "";
    private string _program = "";
    private string _userName = "";
    private StateChoice _state;
    private readonly StoredPieces _kept = new();
    private CorrectionDetail? _detail;
    private StoredPiece? _measured;
    private string _folder;
    private string? _exported;
    private bool _isKnown;
    private IReadOnlyList<Correction> _found = [];
    private IReadOnlyDictionary<long, IReadOnlyList<string>> _people = new Dictionary<long, IReadOnlyList<string>>();
    private long _all;

    /// <summary>Starts with the latest corrections.</summary>
    public HistoryViewModel(ShellViewModel shell)
        : base((shell ?? throw new ArgumentNullException(nameof(shell))).Station)
    {
        _state = States[0];
        _folder = Path.Combine(Path.GetDirectoryName(Path.GetFullPath(Station.Settings.File))!, "exports");
        Search = new(_ => SearchAsync());
        LookAtMeasured = new(() => shell.LookAtPiece(_measured!.LastId), () => _measured is not null);
        Back = new(() => Detail = null);
        Revert = new(
            () =>
            {
                var signing = RevertSigning.Of(shell, Detail!.Stored);
                var id = Detail.Stored.Correction.Id;
                signing.Signed += () => Loading = OpenAsync(id).Watched();
                shell.Sign(signing);
            },
            () => shell.Who is { } who && Rights.Allows(who.Role, Act.Revert) && RevertSigning.IsPossible(Detail?.Stored));
        Export = new(ExportAsync, () => Detail is not null && !string.IsNullOrWhiteSpace(Folder));
        ChooseFolder = new(
            async _ => Folder = await shell.ChooseAsync(new(FileChoiceKind.Folder, "History.Folder", []) { Start = Folder }) ?? Folder);
        Clear = new(() =>
        {
            (Serial, WorkOrder, From, To, Program, UserName, State) = ("", "", "", "", "", "", States[0]);
            Search.Execute(null);
        });
        ExportFound = new(
            async cancellation =>
            {
                if (await shell.ChooseAsync(new(FileChoiceKind.Folder, "History.Folder", []) { Start = Folder }) is { } folder)
                {
                    Folder = folder;
                    await ExportFoundAsync(folder, cancellation);
                }
            },
            () => _found.Count > 0);
        Search.Execute(null);
    }

    /// <summary>Serial number of the piece; empty for any.</summary>
    public string Serial
    {
        get => _serial;
        set => Set(ref _serial, value ?? "");
    }

    /// <summary>The work order; empty for any.</summary>
    public string WorkOrder
    {
        get => _workOrder;
        set => Set(ref _workOrder, value ?? "");
    }

    /// <summary>The first day, as year-month-day or year/month/day; empty for any.</summary>
    public string From
    {
        get => _from;
        set => SetMore(ref _from, value ?? "");
    }

    /// <summary>The last day, as year-month-day or year/month/day; empty for any.</summary>
    public string To
    {
        get => _to;
        set => SetMore(ref _to, value ?? "");
    }

    /// <summary>The program's name at the machine, or the first digits of its SHA-256; empty for any.</summary>
    public string Program
    {
        get => _program;
        set => SetMore(ref _program, value ?? "");
    }

    /// <summary>The user who took any of its steps; empty for any.</summary>
    public string UserName
    {
        get => _userName;
        set => SetMore(ref _userName, value ?? "");
    }

    /// <summary>Its state.</summary>
    public StateChoice State
    {
        get => _state;
        set
        {
            // A list rebuilt in another language briefly has no selection.
            if (value is not null)
            {
                SetMore(ref _state, value);
            }
        }
    }

    /// <summary>The states to choose from.</summary>
    public IReadOnlyList<StateChoice> States { get; } = [new(null), .. Enum.GetValues<CorrectionState>().Select(s => new StateChoice(s))];

    /// <summary>True if a field is filled in that a small screen hides.</summary>
    public bool HasMore => new[] { From, To, Program, UserName }.Any(t => Given(t) is not null) || State.State is not null;

    /// <summary>What was found, latest first.</summary>
    public RowList<HistoryRow> Rows { get; } = [];

    /// <summary>The number of results, in words; empty before it is known.</summary>
    public string Found => !_isKnown ? ""
        : _all > _found.Count ? Texts.Current.With("History.FoundMost", Shown.Count(_all), Shown.Count(_found.Count))
        : Texts.Current.With("History.Found", Shown.Count(_found.Count));

    /// <summary>The opened correction; null while the list is shown.</summary>
    public CorrectionDetail? Detail
    {
        get => _detail;
        private set
        {
            if (Set(ref _detail, value))
            {
                Exported = null;
                Export.Refresh();
                Revert.Refresh();
                OnPropertyChanged(nameof(IsList));
                OnPropertyChanged(nameof(CanRevert));
            }
        }
    }

    /// <summary>Whether the measured counterpart is within its limits: the one cut with the opened correction, or the opened one
    /// itself. Null if none of the last pieces matches.</summary>
    public string? Measured =>
        _measured is { } piece
            ? Sentence.Joined(Texts.Current.With("History.Measured", CorrectionLabel.Of(piece.Counterpart!)), PieceDetail.VerdictOf(piece))
            : null;

    /// <summary>The same in a few words; null likewise.</summary>
    public string? MeasuredInShort =>
        _measured is not { } piece
            ? null
            : piece.Outside.Count is > 0 and var outside
            ? Texts.Current.With("History.MeasuredOutside", outside)
            : Texts.Current["History.MeasuredWithin"];

    public Severity MeasuredSeverity => _measured is { IsWithin: false } ? Severity.Attention : Severity.Quiet;

    /// <summary>Opens the verification of that counterpart.</summary>
    public Command LookAtMeasured { get; }

    /// <summary>True while the list is shown.</summary>
    public bool IsList => Detail is null;

    /// <summary>The folder to export to.</summary>
    public string Folder
    {
        get => _folder;
        set
        {
            if (Set(ref _folder, value ?? ""))
            {
                Export.Refresh();
            }
        }
    }

    /// <summary>Where the export was written; null if there was none.</summary>
    public string? Exported
    {
        get => _exported;
        private set => Set(ref _exported, value);
    }

    /// <summary>Searches by the fields.</summary>
    public LongCommand Search { get; }

    /// <summary>Empties all fields, and shows the latest corrections.</summary>
    public Command Clear { get; }

    /// <summary>Writes what was found and is listed as CSV.</summary>
    public LongCommand ExportFound { get; }

    /// <summary>Where the list was written; null if it was not.</summary>
    public string? FoundExported { get; private set; }

    /// <summary>Returns to the list.</summary>
    public Command Back { get; }

    /// <summary>Restores the program that the slot held before the opened correction.</summary>
    public Command Revert { get; }

    /// <summary>True if it can be restored, by this user.</summary>
    public bool CanRevert => Revert.CanExecute(null);

    /// <summary>Writes measurement, job, programs and report to <see cref="Folder"/>.</summary>
    public LongCommand Export { get; }

    /// <summary>Opens the chooser for <see cref="Folder"/>.</summary>
    public LongCommand ChooseFolder { get; }

    /// <summary>Completes when the tapped correction is open.</summary>
    internal Task Loading { get; private set; } = Task.CompletedTask;

    /// <summary>Finds a piece by its serial number. A code that is not a serial number is a work order.</summary>
    public void TakeCode(string code) => Scanning = ScanAsync(code).Watched();

    /// <inheritdoc/>
    public void LookAt(long correction) => Loading = OpenAsync(correction).Watched();

    /// <summary>Completes when a code was searched for.</summary>
    internal Task Scanning { get; private set; } = Task.CompletedTask;

    /// <inheritdoc/>
    protected override void Follow()
    {
        // Results stay until the next search.
    }

    /// <inheritdoc/>
    protected override void Translate()
    {
        foreach (var state in States)
        {
            state.Rename();
        }

        Rows.Show([.. _found.Select(Row)]);
        _detail = _detail is null ? null : new(_detail.Stored, Station.Clock);
        OnPropertyChanged();
    }

    private void SetMore<T>(ref T field, T value, [CallerMemberName] string? name = null)
    {
        if (Set(ref field, value, name))
        {
            OnPropertyChanged(nameof(HasMore));
        }
    }

    private static string? Given(string text) => string.IsNullOrWhiteSpace(text) ? null : text.Trim();

    private HistoryRow Row(Correction c) => new(
        c.Id,
        Shown.Time(c.ArrivedAt, Station.Clock),
        c.Serial ?? c.FileName,
        c.WorkOrder ?? c.JobWorkOrder ?? Shown.Nothing,
        c.Job ?? Shown.Nothing,
        Texts.Current.Word(c.State),
        c.LargestMm is { } mm ? Shown.Mm(mm) : Shown.Nothing,
        _people.GetValueOrDefault(c.Id) is { } people ? Texts.Current.Listed(people) : Shown.Nothing);

    private async Task ScanAsync(string code)
    {
        // One search at a time: wait for the screen's first search.
        await Search.Running;
        Detail = null;
        (Serial, WorkOrder, From, To, Program, UserName, State) = (code, "", "", "", "", "", States[0]);
        Search.Execute(null);
        await Search.Running;
        if (_found.Count == 0 && Message is null && Serial == code)
        {
            (Serial, WorkOrder) = ("", code);
            Search.Execute(null);
            await Search.Running;
        }
    }

    // Searches again if the fields have changed during the search, because a scanner does not wait for it.
    private async Task SearchAsync()
    {
        var query = Query();
        Message = query is null ? Texts.Current["History.BadDay"] : Message;
        while (query is not null)
        {
            var sought = query;
            IReadOnlyList<Correction> found = [];
            IReadOnlyDictionary<long, IReadOnlyList<string>> people = _people;
            var all = 0L;
            if (await TryAsync(() =>
            {
                found = Station.Store.Search(sought);
                people = Station.Store.Corrections.PeopleOf([.. found.Select(c => c.Id)]);
                all = found.Count < sought.Most ? found.Count : Station.Store.Count(sought);
            }))
            {
                (_isKnown, _all, _people, FoundExported) = (true, all, people, null);
                _found = [.. found.OrderByDescending(c => c.Id)];
                Rows.Show([.. _found.Select(Row)]);
                OnPropertyChanged(nameof(Found));
                OnPropertyChanged(nameof(FoundExported));
                ExportFound.Refresh();
            }

            query = Query() is { } now && now != sought ? now : null;
        }
    }

    // Null if a date is invalid.
    private HistoryQuery? Query() => TypedDay.TryRead(From, 0, Station.Clock, out var from)
        && TypedDay.TryRead(To, 1, Station.Clock, out var to)
        ? new()
        {
            IsLoose = true,
            Serial = Given(Serial),
            WorkOrder = Given(WorkOrder),
            From = from,
            To = to,
            Program = Given(Program),
            User = Given(UserName),
            State = State.State,
            Most = Most
        }
        : null;

    private async Task OpenAsync(long id)
    {
        CorrectionDetail? read = null;
        StoredPiece? measured = null;
        if (await TryAsync(() =>
        {
            var correction = new CorrectionDecisions(Station.Store).Demand(id);
            read = new(StoredCorrection.Read(Station.Store, correction).With(Station.Settings), Station.Clock);
            measured = MatingChoice.Of(Station.Settings).FirstOrDefault(m => m.Jobs.Contains(
                correction.Job, StringComparer.Ordinal)) is { } mating
                ? _kept.Read(Station.Store, mating.Jobs, StoredPieces.Most).FirstOrDefault(
                    p => p.IsMeasured && (p.Correction.Id == id || p.LastId == id))
                : null;
        }))
        {
            (_measured, Detail) = (measured, read!.Now());
            OnPropertyChanged(nameof(Measured));
            OnPropertyChanged(nameof(MeasuredInShort));
            OnPropertyChanged(nameof(MeasuredSeverity));
            LookAtMeasured.Refresh();
        }
    }

    // A file of its own each time: an earlier list is not replaced.
    private async Task ExportFoundAsync(string folder, CancellationToken cancellation)
    {
        var (found, people) = (_found, _people);
        var path = Path.Combine(
            folder,
            string.Create(CultureInfo.InvariantCulture, $"history-{Station.Clock.GetUtcNow().UtcDateTime:yyyyMMdd'T'HHmmssfff'Z'}.csv"));
        if (await TryAsync(() =>
        {
            using var written = new StringWriter();
            HistoryCsv.Write(written, found, people);
            OutputFile.Write(path, Encoding.UTF8.GetBytes(written.ToString()), [Station.Settings.File], cancellation);
        }))
        {
            FoundExported = Texts.Current.With("History.FoundExported", Shown.Count(found.Count), path);
            OnPropertyChanged(nameof(FoundExported));
        }
    }

    private async Task ExportAsync(CancellationToken cancellation)
    {
        var (correction, folder) = (Detail!.Stored.Correction, Folder.Trim());
        var redrawn = false;
        if (await TryAsync(() =>
        {
            var files = CorrectionFiles.Read(Station.Store, correction);
            redrawn = files.Any(f => f.Notice is not null);
            OutputFile.WriteAll([.. files.Select(f => (Path.Combine(folder, f.Name), f.Bytes))], [Station.Settings.File], cancellation);
        }))
        {
            Exported = Texts.Current.With(redrawn ? "History.ExportedRedrawn" : "History.Exported", folder);
        }
    }
}

/// <summary>A correction found in the history.</summary>
/// <param name="Id">Its number.</param>
/// <param name="Arrived">When its file arrived.</param>
/// <param name="Piece">Serial number, or the file's name.</param>
/// <param name="WorkOrder">The work order.</param>
/// <param name="Job">The job.</param>
/// <param name="State">Its state.</param>
/// <param name="Largest">Its largest displacement.</param>
/// <param name="People">Who took steps of it.</param>
internal sealed record HistoryRow(
    long Id, string Arrived, string Piece, string WorkOrder, string Job, string State, string Largest, string People)
{
    public string Number => "#" + Shown.Id(Id);

    public string AutomationId => "found-" + Shown.Id(Id);
}

/// <summary>A state to search for. The object stays the same in another language, so that it stays selected.</summary>
/// <param name="state">The state; null for any.</param>
internal sealed class StateChoice(CorrectionState? state) : Observable
{
    public CorrectionState? State { get; } = state;

    public string Name => State is { } known ? Texts.Current.Word(known) : Texts.Current["History.AnyState"];

    /// <summary>Updates the name after a change of language.</summary>
    internal void Rename() => OnPropertyChanged(nameof(Name));
}
