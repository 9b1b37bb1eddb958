namespace ErrorMatching.Cell;

/// <summary>Finds the corrections that were made with a previous version of their job: the same measurement would now give a different
/// one.</summary>
/// <remarks>The comparison uses the correction's identity, which covers the job's file and all files that it names. Not thread-safe; reads
/// files.</remarks>
/// <param name="settings">The cell's configuration.</param>
public sealed class ChangedJobs(CellSettings settings)
{
    private readonly CorrectionComputer _computer = new(settings.Policy);
    private readonly Dictionary<string, (string Standing, Dictionary<long, bool> Told)> _jobs = new(StringComparer.Ordinal);

    /// <summary>The numbers of corrections that were made with a previous version of their job.</summary>
    /// <param name="store">The store.</param>
    /// <param name="corrections">Corrections that have not been carried out yet.</param>
    /// <exception cref="StoreException">The store cannot be read.</exception>
    public IReadOnlySet<long> Among(CellStore store, IEnumerable<Correction> corrections)
    {
        ArgumentNullException.ThrowIfNull(store);
        var changed = new HashSet<long>();
        foreach (var ofJob in corrections.Where(c => c is { Identity: not null, Piece: not null }).GroupBy(c => (c.Job, c.Piece)))
        {
            if (settings.Jobs.FirstOrDefault(j => j.Name == ofJob.Key.Job) is { } job)
            {
                var told = Told(job, ofJob.Key.Piece!);
                changed.UnionWith(
                    ofJob.Where(c => told.TryGetValue(c.Id, out var was) ? was : told[c.Id] = IsChanged(store, c, job)).Select(c => c.Id));
            }
        }

        return changed;
    }

    // A result remains valid while the job's files are unchanged. This is checked by the job's identity without a measurement, which is the
    // same for all its corrections.
    private Dictionary<long, bool> Told(CellJobSettings job, string piece)
    {
        var nothing = new StoredFile("", default);
        var standing = _computer.Identify(new() { Job = job, Piece = piece, Measurement = nothing, Part = nothing }) switch
        {
            Identified { Basis.Identity: var identity } => identity,
            RefusedComputation { Code: var code, Reason: var reason } => $"{code} {reason}",
            _ => "",
        };
        var key = $"{job.Name}/{piece}";
        if (!_jobs.TryGetValue(key, out var known) || known.Standing != standing)
        {
            _jobs[key] = known = (standing, []);
        }

        return known.Told;
    }

    private bool IsChanged(CellStore store, Correction correction, CellJobSettings job) =>
        _computer.Identify(CorrectionRequests.OfRecalculation(store, correction, job)) is Identified { Basis.Identity: var identity }
            && identity != correction.Identity;
}
