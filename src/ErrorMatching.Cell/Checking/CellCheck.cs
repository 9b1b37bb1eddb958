namespace ErrorMatching.Cell;

/// <summary>What a cell would find if it started now. Nothing is taken, sent or kept, and at machines nothing is changed; in a gauge's folder an empty folder is made and removed again, to see that files can be taken.</summary>
/// <param name="Gauges">Its gauges.</param>
/// <param name="Machines">Its machines, each after a login and a listing.</param>
/// <param name="Store">Its store.</param>
/// <param name="Jobs">Its jobs.</param>
public sealed record CellCheck(IReadOnlyList<CheckedGauge> Gauges, IReadOnlyList<CheckedMachine> Machines, CheckedStore Store, IReadOnlyList<CheckedJob> Jobs)
{
    /// <summary>What is wrong with what the configuration names: jobs' files and programs.</summary>
    public IEnumerable<CheckProblem> Wrong => Jobs.Select(j => j.Problem).OfType<CheckProblem>();

    /// <summary>What could not be tried without changing something at a machine, one sentence each.</summary>
    public IEnumerable<string> Untried => Machines.Select(m => m.Untried).OfType<string>();

    /// <summary>What does not answer: folders, machines, the store.</summary>
    public IEnumerable<CheckProblem> Away => Gauges.Select(g => g.Problem).Concat(Machines.Select(m => m.Problem)).Append(Store.Problem).OfType<CheckProblem>().Distinct();

    /// <summary>Looks at everything that a configuration names. All machines are asked at once.</summary>
    /// <param name="settings">The configuration.</param>
    /// <param name="cancellation">Ends the waiting for machines.</param>
    /// <exception cref="OperationCanceledException">Cancelled.</exception>
    public static Task<CellCheck> OfAsync(CellSettings settings, CancellationToken cancellation) => OfAsync(settings, null, cancellation);

    /// <summary>Looks at everything that a configuration names, and says how far it is. All machines are asked at once.</summary>
    /// <param name="settings">The configuration.</param>
    /// <param name="progress">Is told after each gauge, machine, job and the store what part of all is looked at, up to 1; null if nobody asks.</param>
    /// <param name="cancellation">Ends the waiting for machines.</param>
    /// <exception cref="OperationCanceledException">Cancelled.</exception>
    public static async Task<CellCheck> OfAsync(CellSettings settings, IProgress<double>? progress, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(settings);
        double all = 1 + settings.Machines.Count + settings.Gauges.Count + settings.Jobs.Count;
        var looked = 0;
        var store = Looked(StoreCheck.Of(settings.Store));
        var machines = await new MachineCheck(settings, store).OfAllAsync(m => Looked(m), cancellation).ConfigureAwait(false);
        var gauges = new GaugeCheck(settings, machines);
        return new([.. settings.Gauges.Select(g => Looked(gauges.Of(g, cancellation)))], machines, store, [.. settings.Jobs.Select(j => Looked(JobCheck.Of(j, cancellation)))]);

        T Looked<T>(T part)
        {
            progress?.Report(Interlocked.Increment(ref looked) / all);
            return part;
        }
    }
}
