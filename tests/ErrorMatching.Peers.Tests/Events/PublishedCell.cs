using System.Text;
using ErrorMatching.Cell;
using ErrorMatching.EndToEnd.Tests;

namespace ErrorMatching.Peers.Tests;

/// <summary>A cell's store with the part of the cell that publishes, without machines: files arrive, and each is a step.</summary>
internal sealed class PublishedCell : IAsyncDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("errormatch-events-").FullName;
    private readonly FlowPace _pace;
    private readonly EventSettings _broker;
    private readonly bool _isAlone;
    private CancellationTokenSource _stop = new();
    private EventWorker? _events;
    private Task _run = Task.CompletedTask;
    private int _arrivals;

    /// <summary>Begins to publish.</summary>
    /// <param name="broker">The broker.</param>
    /// <param name="store">A store that it shares with others; null for one of its own.</param>
    /// <param name="gauge">Its gauge.</param>
    /// <param name="name">Its name.</param>
    /// <param name="settle">How long a broker must live on before its acknowledgment counts.</param>
    public PublishedCell(
        EventSettings broker, CellStore? store = null, string gauge = "cmm", string name = "Cell 1", TimeSpan? settle = null)
    {
        _broker = broker;
        _pace = new()
        {
            BrokerAnswer = TimeSpan.FromSeconds(5),
            BrokerPing = TimeSpan.FromMilliseconds(100),
            BrokerSettle = settle ?? TimeSpan.FromSeconds(4),
            Pause = TimeSpan.FromMilliseconds(50),
            LongestPause = TimeSpan.FromMilliseconds(100),
        };
        Gauge = gauge;
        using var configured = new FireCell(slots: 1, name: name);
        Settings = CellSettingsReader.Read(configured.Configuration);
        Settings = Settings with { Gauges = [.. Settings.Gauges.Select(g => g with { Name = gauge })], Events = broker };
        _isAlone = store is null;
        if (!_isAlone)
        {
            Settings = Settings with { Store = new PostgresSettings("shared", 1, "shared", "shared", null) };
        }

        Store = store ?? CellStore.Open(new SqliteSettings(Path.Combine(_folder, "cell.db")), TimeProvider.System);
        Begin();
    }

    public CellSettings Settings { get; }

    public CellStore Store { get; }

    public string Gauge { get; }

    public CellFlow Flow { get; private set; } = null!;

    /// <summary>Identities of all steps that the audit trail has for this cell, in order.</summary>
    public IReadOnlyList<string> Expected =>
    [
        .. Store.AuditEntries(0, int.MaxValue)
            .Where(e => AuditReplay.SubjectOf(e.Subject) is var (id, _, _) && Store.Find(id)!.Gauge == Gauge).Select(e => e.Hash),
    ];

    /// <summary>Lets files arrive.</summary>
    public void Arrive(int files = 1)
    {
        for (var i = 0; i < files; i++)
        {
            var name = FormattableString.Invariant($"{Gauge}-{++_arrivals}.csv");
            Flow.Arrive(() => Store.Archive(new Arrival(Gauge, name, name, Encoding.UTF8.GetBytes(name))));
        }
    }

    /// <summary>A new process of the same cell, as far as publishing goes.</summary>
    public void Begin()
    {
        _stop = new();
        Flow = new CellFlow(Settings, Store, TimeProvider.System, Serilog.Core.Logger.None, _pace, CancellationToken.None);
        _events = new EventWorker(Flow, _broker);
        var worker = new Worker(Flow, EventWorker.Where, Flow.Stepped, _events.WorkAsync);
        var stop = _stop.Token;
        _run = Task.Run(() => worker.RunAsync(stop));
    }

    /// <summary>Ends it as a process that is killed does: in the middle of a message, without a farewell or a record.</summary>
    public async Task KillAsync()
    {
        await _stop.CancelAsync();
        await _run;
        _stop.Dispose();
    }

    /// <summary>Ends it in order.</summary>
    public async Task StopAsync()
    {
        await _stop.CancelAsync();
        await _run;
        await _events!.DisposeAsync();
        _stop.Dispose();
    }

    public async ValueTask DisposeAsync()
    {
        await StopAsync();
        if (_isAlone)
        {
            Store.Dispose();
        }

        Directory.Delete(_folder, recursive: true);
    }
}
