using System.Globalization;
using ErrorMatching.Cell;
using ErrorMatching.Refusals;

namespace ErrorMatching.Hmi;

/// <summary>Machines and gauges: tests the connections, as <c>errormatch cell check</c> does. An administrator can set a
/// machine's password.</summary>
internal sealed class ConnectionsViewModel : ScreenViewModel
{
    private readonly ShellViewModel _shell;
    private CellCheck? _check;
    private ConnectionRow? _chosen;
    private string _password = "";
    private double _progress;

    /// <summary>The page, before any test.</summary>
    public ConnectionsViewModel(ShellViewModel shell)
        : base((shell ?? throw new ArgumentNullException(nameof(shell))).Station)
    {
        _shell = shell;
        Test = new(TestAsync);
        SetPassword = new(Sign, () => TakesPassword && Password.Length > 0);
        Show();
    }

    /// <summary>The connections.</summary>
    public RowList<ConnectionRow> Rows { get; } = [];

    /// <summary>Tests all connections.</summary>
    public LongCommand Test { get; }

    /// <summary>The tested share, up to 1.</summary>
    public double Progress
    {
        get => _progress;
        private set => Set(ref _progress, value);
    }

    /// <summary>The selected connection; null if there is none.</summary>
    public ConnectionRow? Chosen
    {
        get => _chosen;
        set
        {
            if (Set(ref _chosen, value))
            {
                Password = "";
                OnPropertyChanged(nameof(TakesPassword));
                OnPropertyChanged(nameof(PasswordLabel));
                SetPassword.Refresh();
            }
        }
    }

    /// <summary>True if it is a machine with a password, and the current user may set it.</summary>
    public bool TakesPassword => Machine is { NeedsPassword: true } && _shell.Who is { } who && Rights.Allows(who.Role, Act.ManageMachines);

    /// <summary>Names the machine whose password it is.</summary>
    public string PasswordLabel => Texts.Current.With("Connection.Password", Chosen?.Name ?? "");

    /// <summary>The machine's new password.</summary>
    public string Password
    {
        get => _password;
        set
        {
            if (Set(ref _password, value ?? ""))
            {
                SetPassword.Refresh();
            }
        }
    }

    /// <summary>Sets the machine's password.</summary>
    public Command SetPassword { get; }

    private MachineSettings? Machine =>
        Chosen is { Kind: "machine" } row ? Station.Settings.Machines.FirstOrDefault(m => m.Name == row.Name) : null;

    /// <inheritdoc/>
    protected override void Follow()
    {
        // Results stay until the next test.
    }

    /// <inheritdoc/>
    protected override void Translate()
    {
        Show();
        OnPropertyChanged();
    }

    /// <inheritdoc/>
    protected override void Dispose(bool isDisposing)
    {
        Test.Cancel.Execute(null);
        base.Dispose(isDisposing);
    }

    private static ConnectionRow Row(string kind, string name, string where, CheckProblem? problem, string? well) =>
        problem is { Errors: var errors }
        ? new(kind, name, where, Severity.Alarm, Sentence.Joined(errors.Select(Words)))
        : new(kind, name, where, well is null ? null : Severity.Quiet, well ?? Texts.Current["Connection.Untested"]);

    private static string Words(Refusal e) =>
        CodeText.Whole(e.Code) is { } text ? Sentence.Joined(text, e.Message) : CodeText.Of(e.Code, e.Message);

    private async Task TestAsync(CancellationToken cancellation)
    {
        (Message, Progress, _check) = (null, 0, null);
        Show();
        var progress = new Progress<double>(p => Progress = Math.Max(Progress, p));
        CellCheck? check = null;

        // A hanging share cannot be interrupted: canceling does not wait for it.
        try
        {
            check = await Task.Run(() => CellCheck.OfAsync(Station.Settings, progress, cancellation), cancellation).WaitAsync(cancellation);
        }
        catch (Exception e) when (Failures.IsKnown(e))
        {
            Message = Failures.Of(e, Station.Clock);
        }
        catch (OperationCanceledException) when (cancellation.IsCancellationRequested)
        {
            Message = Texts.Current["Connection.Cancelled"];
        }

        _check = check;
        Show();
    }

    private void Show()
    {
        var (settings, texts) = (Station.Settings, Texts.Current);
        var store = settings.Store is SqliteSettings { File: var file }
            ? file
            : settings.Store is PostgresSettings p
            ? string.Create(CultureInfo.InvariantCulture, $"{p.Host}:{p.Port} {p.Database}")
            : "";
        var kept = _chosen;
        Rows.Show(
        [
            Row(
                "store",
                settings.Store is SqliteSettings ? "SQLite" : "PostgreSQL",
                store,
                _check?.Store.Problem,
                _check is null ? null : texts["Connection.StoreAnswers"]),
            .. settings.Machines.Select(
                (m, i) => Row(
                    "machine",
                    m.Name,
                    m.Transport.Address,
                    _check?.Machines[i].Problem,
                    _check is null ? null : texts.With("Connection.Listed", Shown.Count(_check.Machines[i].Names?.Count ?? 0)))),
            .. settings.Gauges.Select(
                (g, i) => Row(
                    "gauge",
                    g.Name,
                    g.Incoming ?? texts.With("Overview.AtMachine", g.Machine!),
                    _check?.Gauges[i].Problem,
                    _check is null
                        ? null
                        : texts.With("Connection.Waiting", Shown.Count(_check.Gauges[i].Files.Count + _check.Gauges[i].More)))),
            .. settings.Jobs.Select(
                (j, i) => Row("job", j.Name, j.File, _check?.Jobs[i].Problem, _check is null ? null : texts["Connection.JobReads"])),
        ]);
        Chosen = kept is null ? null : Rows.FirstOrDefault(r => r.AutomationId == kept.AutomationId);
    }

    private void Sign()
    {
        var (machine, password) = (Machine!.Name, Password);
        var signing = new SigningViewModel(Station, _shell.Who!, Act.ManageMachines, machine, needsReason: false, (by, _, _) =>
        {
            new MachineSecrets(Station.Store, Station.Settings.KeysFolder).Set(machine, password, by.Name);
            return Task.CompletedTask;
        })
        { TitleKey = "Connection.SetPassword" };
        signing.Signed += () => Password = "";
        _shell.Sign(signing);
    }
}

/// <summary>A connection to test: the store, a machine, a gauge, or a job's files.</summary>
/// <param name="Kind">Its kind: <c>store</c>, <c>machine</c>, <c>gauge</c> or <c>job</c>.</param>
/// <param name="Name">Its display name.</param>
/// <param name="Where">Its address or path.</param>
/// <param name="Found">The result of the test; null before it was tested.</param>
/// <param name="Outcome">The result in words.</param>
internal sealed record ConnectionRow(string Kind, string Name, string Where, Severity? Found, string Outcome)
{
    /// <summary>Its kind, in a word.</summary>
    public string KindName => Texts.Current["Connection." + Kind];

    /// <summary>Key of the icon of the result; null before it was tested.</summary>
    public string? Icon =>
        Found switch { Severity.Alarm => "Icon.alarm", Severity.Attention => "Icon.attention", Severity.Quiet => "Icon.quiet", _ => null };

    /// <summary>True if it does not respond.</summary>
    public bool IsAlarm => Found is Severity.Alarm;

    public string AutomationId => $"connection-{Kind}-{Name}";
}
