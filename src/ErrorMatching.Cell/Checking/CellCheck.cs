using ErrorMatching.Refusals;

namespace ErrorMatching.Cell;

/// <summary>What a cell would find if it started now. The check processes, sends and stores nothing and changes nothing at a machine. In a
/// gauge's folder it creates and removes an empty folder, to test that files can be moved out.</summary>
/// <param name="Gauges">Its gauges.</param>
/// <param name="Machines">Its machines, each after a login and a listing.</param>
/// <param name="Store">Its store.</param>
/// <param name="Jobs">Its jobs.</param>
public sealed record CellCheck(
    IReadOnlyList<CheckedGauge> Gauges, IReadOnlyList<CheckedMachine> Machines, CheckedStore Store, IReadOnlyList<CheckedJob> Jobs)
{
    /// <summary>The broker that steps are published to; null if none is configured.</summary>
    public CheckedBroker? Broker { get; init; }

    /// <summary>Errors in what the configuration names: the jobs' files and programs.</summary>
    public IEnumerable<CheckProblem> Wrong => Jobs.Select(j => j.Problem).OfType<CheckProblem>();

    /// <summary>What could not be tested without changing something at a machine, one sentence each.</summary>
    public IEnumerable<string> Untried => Machines.Select(m => m.Untried).OfType<string>();

    /// <summary>What cannot be reached: folders, machines, the broker, the store.</summary>
    public IEnumerable<CheckProblem> Away =>
        Gauges.Select(g => g.Problem).Concat(Machines.Select(m => m.Problem)).Append(Broker?.Problem).Append(Store.Problem)
            .OfType<CheckProblem>().Distinct();

    /// <summary>Checks everything that a configuration names. All machines are queried concurrently.</summary>
    /// <param name="settings">The configuration.</param>
    /// <param name="cancellation">Stops waiting for machines.</param>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public static Task<CellCheck> OfAsync(CellSettings settings, CancellationToken cancellation) => OfAsync(settings, null, cancellation);

    /// <summary>Checks everything that a configuration names and reports progress. All machines are queried concurrently.</summary>
    /// <param name="settings">The configuration.</param>
    /// <param name="progress">Receives the completed fraction, up to 1, after each gauge, machine, job and the store; null for no progress
    /// reports.</param>
    /// <param name="cancellation">Stops waiting for machines.</param>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public static async Task<CellCheck> OfAsync(CellSettings settings, IProgress<double>? progress, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(settings);
        double all = 1 + settings.Machines.Count + settings.Gauges.Count + settings.Jobs.Count + (settings.Events is null ? 0 : 1);
        var looked = 0;
        var store = Looked(StoreCheck.Of(settings.Store));
        var machines = await new MachineCheck(settings, store).OfAllAsync(m => Looked(m), cancellation).ConfigureAwait(false);
        var broker = settings.Events is { } events ? Looked(await BrokerCheck.OfAsync(events, cancellation).ConfigureAwait(false)) : null;
        var gauges = new GaugeCheck(settings, machines);
        var names = new NameCheck(settings, machines);
        return new(
            [.. settings.Gauges.Select(g => Looked(gauges.Of(g, cancellation)))],
            machines,
            store,
            [.. settings.Jobs.Select(j => Looked(names.Of(JobCheck.Of(j, cancellation))))])
        {
            Broker = broker,
        };

        T Looked<T>(T part)
        {
            progress?.Report(Interlocked.Increment(ref looked) / all);
            return part;
        }
    }
}

/// <summary>A problem that a check found.</summary>
/// <param name="Errors">The errors, each with its code and a sentence; at least one.</param>
public sealed record CheckProblem(IReadOnlyList<Refusal> Errors)
{
    internal static CheckProblem Of(string code, string message) => new([new(code, message)]);
}

/// <summary>Checks whether a broker lets the cell in. Nothing is published, so it does not find out whether it may publish.</summary>
internal static class BrokerCheck
{
    private static readonly TimeSpan Limit = TimeSpan.FromSeconds(10);

    public static async Task<CheckedBroker> OfAsync(EventSettings broker, CancellationToken cancellation)
    {
        try
        {
            // A session of its own: that of a running cell must not end.
            var client = "errormatch-check-" + Guid.NewGuid().ToString("N")[..8];
            using var session = await BrokerSession.OpenAsync(broker, client, isResumed: false, Limit, cancellation).ConfigureAwait(false);
            await session.EndAsync(cancellation).ConfigureAwait(false);
            return new(broker, null);
        }
        catch (BrokerException e)
        {
            return new(broker, CheckProblem.Of(CellCodes.Of(e.Error), e.Message));
        }
    }
}

/// <summary>The broker, after a login.</summary>
/// <param name="Broker">Its settings.</param>
/// <param name="Problem">Why it did not let the cell in; null if it did.</param>
public sealed record CheckedBroker(EventSettings Broker, CheckProblem? Problem);
