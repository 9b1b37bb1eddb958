namespace ErrorMatching.Cell;

/// <summary>Tells which corrections were made with a job as it was before somebody changed it: another one would be made of the same measurement now.</summary>
/// <remarks>By a correction's identity, as the cell itself tells it: it covers the job's file and all files that it names. To be asked by one thread at a time; it reads files.</remarks>
/// <param name="settings">The cell's configuration.</param>
public sealed class ChangedJobs(CellSettings settings)
{
    private readonly CorrectionComputer _computer = new(settings.Policy);
    private readonly Dictionary<string, (string Standing, Dictionary<long, bool> Told)> _jobs = new(StringComparer.Ordinal);

    /// <summary>The numbers of those that were made with a job as it was.</summary>
    /// <param name="store">The store.</param>
    /// <param name="corrections">Corrections that are not carried out yet.</param>
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
                changed.UnionWith(ofJob.Where(c => told.TryGetValue(c.Id, out var was) ? was : told[c.Id] = IsChanged(store, c, job)).Select(c => c.Id));
            }
        }

        return changed;
    }

    // What was found out holds as long as the job's files are the same: their identity with nothing measured is looked at, which is one for all corrections of the job.
    private Dictionary<long, bool> Told(CellJobSettings job, string piece)
    {
        var nothing = new KeptFile("", default);
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
        _computer.Identify(CorrectionRequests.Again(store, correction, job)) is Identified { Basis.Identity: var identity } && identity != correction.Identity;
}
