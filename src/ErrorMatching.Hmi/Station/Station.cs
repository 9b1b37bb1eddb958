using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>One station at a cell: its configuration, store and session, and a check of the cell four times a second. The console
/// can do everything that this class does.</summary>
public sealed class Station : IDisposable
{
    /// <summary>The session ends after this time without input.</summary>
    public static readonly TimeSpan DefaultIdle = TimeSpan.FromMinutes(5);

    private readonly SynchronizationContext _screen;
    private readonly CancellationTokenSource _end = new();
    private readonly Task _watching;
    private readonly HashSet<long> _lookedAt = [];

    /// <summary>Opens the cell's store and starts watching. Call it on the UI thread.</summary>
    /// <param name="settings">The cell's configuration.</param>
    /// <param name="clock">The clock.</param>
    /// <param name="idle">Time without input after which the station locks.</param>
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
        Session = new(Users, clock, idle, settings.SignIn);
        _watching = Task.Run(() => new StationWatch(this).RunAsync(Show, _end.Token)).Watched();
    }

    /// <summary>Raised on the UI thread when <see cref="State"/> changes.</summary>
    public event Action? Changed;

    public CellSettings Settings { get; }

    public TimeProvider Clock { get; }

    public CellStore Store { get; }

    public UserBook Users { get; }

    public Session Session { get; }

    /// <summary>Names of the workpieces.</summary>
    public JobNames JobNames { get; } = new();

    /// <summary>Storage of the users' preferences; null if they are not stored.</summary>
    public PreferenceFiles? Preferences { get; init; }

    /// <summary>The folder of the samples that a demonstration is set up with; null if there is none.</summary>
    public string? SamplesFolder { get; init; }

    /// <summary>True for a demonstration, whose password is public.</summary>
    public bool IsDemonstration { get; init; }

    /// <summary>The known state of the cell.</summary>
    public StationState State { get; private set; } = StationState.Unknown;

    /// <summary>Counterparts outside their limits that have not been viewed here since the station started: the latest ones of
    /// each mating, newest first.</summary>
    public IReadOnlyList<StoredPiece> Outside => [.. State.Outside.Where(p => !_lookedAt.Contains(p.LastId))];

    /// <summary>Marks a measured piece as viewed. Call it on the UI thread.</summary>
    public void See(StoredPiece piece)
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

    /// <summary>Shows a state made by a test, and ignores all later ones. Call it on the UI thread.</summary>
    /// <param name="state">The state.</param>
    internal void Pretend(StationState state)
    {
        State = state with { Version = long.MaxValue };
        Changed?.Invoke();
    }

    /// <summary>Stops watching, signs out and closes the store.</summary>
    public void Dispose()
    {
        _end.Cancel();
        _watching.GetAwaiter().GetResult();
        try
        {
            Session.SignOut();
            new AuditTrail(Store, Settings).Remember();
        }
        catch (Exception e) when (e is StoreException or PeopleException)
        {
            // The store is unavailable: the cell also remembers the end of the trail, and the session ends with the process.
        }

        Store.Dispose();
        _end.Dispose();
    }

    // If the store was rolled back, no decisions are allowed on it.
    private static CellStore Opened(CellSettings settings, TimeProvider clock)
    {
        var store = CellStore.Open(settings.Store, clock, AuditKey.OpenFor(settings));
        if (new AuditTrail(store, settings).EndFault() is not { } fault)
        {
            return store;
        }

        store.Dispose();
        throw new StoreException(StoreError.Tampered, fault.Statement);
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
