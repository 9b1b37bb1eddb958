using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>One station at a cell: its configuration, its store, who sits there, and a look at the cell four times a second. Everything here the console can do as well.</summary>
public sealed class Station : IDisposable
{
    /// <summary>Without any touch for so long, a seat counts as left.</summary>
    public static readonly TimeSpan DefaultIdle = TimeSpan.FromMinutes(5);

    private readonly SynchronizationContext _screen;
    private readonly CancellationTokenSource _end = new();
    private readonly Task _watching;
    private readonly HashSet<long> _lookedAt = [];

    /// <summary>Opens the cell's store and begins to watch. To be called on the screen's thread.</summary>
    /// <param name="settings">The cell's configuration.</param>
    /// <param name="clock">The clock.</param>
    /// <param name="idle">How long nothing may be touched before the station is locked.</param>
    /// <exception cref="StoreException">The store cannot be opened.</exception>
    /// <exception cref="PeopleException">The key that seals the audit trail cannot be used.</exception>
    public Station(CellSettings settings, TimeProvider clock, TimeSpan idle)
    {
        ArgumentNullException.ThrowIfNull(settings);
        ArgumentNullException.ThrowIfNull(clock);
        _screen = SynchronizationContext.Current ?? throw new InvalidOperationException("A station is opened on the screen's thread.");
        (Settings, Clock) = (settings, clock);
        Store = Opened(settings, clock);
        Users = new(Store, clock);
        Session = new(Users, clock, idle);
        _watching = Task.Run(() => new StationWatch(this).RunAsync(Show, _end.Token)).Watched();
    }

    /// <summary>Said on the screen's thread when <see cref="State"/> is another one.</summary>
    public event Action? Changed;

    /// <summary>The configuration.</summary>
    public CellSettings Settings { get; }

    /// <summary>The clock.</summary>
    public TimeProvider Clock { get; }

    /// <summary>The store.</summary>
    public CellStore Store { get; }

    /// <summary>The users.</summary>
    public UserBook Users { get; }

    /// <summary>Who sits here.</summary>
    public Session Session { get; }

    /// <summary>What people call the workpieces.</summary>
    public JobNames JobNames { get; } = new();

    /// <summary>Where people's preferences are kept; null if they are not.</summary>
    public PreferenceFiles? Preferences { get; init; }

    /// <summary>The folder of the samples that a demonstration is set up with; null where there is none.</summary>
    public string? SamplesFolder { get; init; }

    /// <summary>True for a demonstration, whose password everybody is told.</summary>
    public bool IsDemonstration { get; init; }

    /// <summary>What is known of the cell.</summary>
    public StationState State { get; private set; } = StationState.Unknown;

    /// <summary>Counterparts that were measured with points outside of their limits, and that nobody has looked at here since the station was started: of each mating those among the last, the newest first.</summary>
    public IReadOnlyList<KeptPiece> Outside => [.. State.Outside.Where(p => !_lookedAt.Contains(p.LastId))];

    /// <summary>Says that somebody has looked at a measured piece. On the screen's thread.</summary>
    public void See(KeptPiece piece)
    {
        ArgumentNullException.ThrowIfNull(piece);
        _lookedAt.Add(piece.LastId);
    }

    /// <summary>Opens a machine's folder with the machine's password.</summary>
    public IMachineFolder Open(MachineSettings machine)
    {
        ArgumentNullException.ThrowIfNull(machine);
        return MachineFolders.Open(machine, () => new MachineSecrets(Store, Settings.KeysFolder).Get(machine.Name));
    }

    /// <summary>Shows a state that a test makes, and nothing that is seen after it. On the screen's thread.</summary>
    /// <param name="state">The state.</param>
    internal void Pretend(StationState state)
    {
        State = state with { Version = long.MaxValue };
        Changed?.Invoke();
    }

    /// <summary>Ends watching, signs out and closes the store.</summary>
    public void Dispose()
    {
        _end.Cancel();
        _watching.GetAwaiter().GetResult();
        try
        {
            Session.SignOut();
            new AuditTrail(Store, Settings.KeysFolder).Remember();
        }
        catch (Exception e) when (e is StoreException or PeopleException)
        {
            // The store is away: the cell remembers the end of the trail as well, and the seat is left with the process.
        }

        Store.Dispose();
        _end.Dispose();
    }

    // On a store that was set back nobody decides anything.
    private static CellStore Opened(CellSettings settings, TimeProvider clock)
    {
        var store = CellStore.Open(settings.Store, clock, AuditKey.OpenFor(settings));
        if (new AuditTrail(store, settings.KeysFolder).EndFault() is not { } fault)
        {
            return store;
        }

        store.Dispose();
        throw new StoreException(StoreError.Tampered, fault.Message);
    }

    private void Show(StationState state) => _screen.Post(
        _ =>
        {
            if (!_end.IsCancellationRequested && state.Version > State.Version)
            {
                State = state;
                Changed?.Invoke();
            }
        },
        null);
}
