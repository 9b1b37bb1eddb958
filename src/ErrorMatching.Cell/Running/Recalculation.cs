using System.Globalization;

namespace ErrorMatching.Cell;

/// <summary>Recalculates a correction that was made with a previous version of its job, by a person's decision. Its measurement becomes a
/// new correction in the same place in line, and the old one ends. The caller must check the person's rights; the running cell computes and
/// proposes the new correction like any other.</summary>
/// <param name="settings">The cell's configuration.</param>
/// <param name="store">The store.</param>
public sealed class Recalculation(CellSettings settings, CellStore store)
{
    private readonly CorrectionComputer _computer = new(settings.Policy);
    private readonly CorrectionDecisions _decisions = new(store);

    /// <summary>Recalculates a correction. The new one supersedes the old one, which is never sent.</summary>
    /// <param name="id">Its number.</param>
    /// <param name="by">The user's name.</param>
    /// <param name="reason">Why; null if no reason is given.</param>
    /// <returns>The new correction, which the cell processes next.</returns>
    /// <exception cref="DecisionException">It cannot be recalculated, or the result would be the same.</exception>
    /// <exception cref="StoreException">The store cannot be used, or the measurement is not in it.</exception>
    public Correction Recalculate(long id, string by, string? reason)
    {
        // What may be rejected may be recalculated instead.
        var correction = _decisions.Demand(id, "recalculated", CorrectionSteps.Before(CorrectionState.Rejected));
        if (correction.Identity is null)
        {
            throw new DecisionException(
                DecisionException.NothingToSend,
                string.Create(
                    CultureInfo.InvariantCulture,
                    $"Correction {id} failed before it had a program: {correction.Reason} Reject it, put that right and measure again."));
        }

        DemandOther(correction, JobOf(correction));
        try
        {
            return store.Recalculate(correction, by, reason);
        }
        catch (StoreException e) when (e.Error == StoreError.Conflict)
        {
            throw CorrectionDecisions.ChangedMeanwhile(id);
        }
    }

    // The measurement needs its gauge and its job again.
    private CellJobSettings JobOf(Correction correction)
    {
        var job = settings.Jobs.FirstOrDefault(j => j.Name == correction.Job);
        var lacks = job is null
            ? $"job \"{correction.Job}\""
            : settings.Gauges.All(g => g.Name != correction.Gauge)
            ? $"gauge \"{correction.Gauge}\""
            : null;
        return lacks is null ? job! : throw new DecisionException(
            DecisionException.JobUnusable,
            string.Create(
                CultureInfo.InvariantCulture,
                $"Correction {correction.Id} stays as it is, for {settings.File} does not have the {lacks} any more: nobody would "
                    + $"compute it. Bring it back into the configuration, or reject the correction."));
    }

    private void DemandOther(Correction correction, CellJobSettings job)
    {
        switch (_computer.Identify(CorrectionRequests.OfRecalculation(store, correction, job)))
        {
            case Identified { Basis.Identity: var identity } when identity == correction.Identity:
                throw new DecisionException(
                    DecisionException.JobUnchanged,
                    string.Create(
                        CultureInfo.InvariantCulture,
                        $"Correction {correction.Id} was made with the job {job.Name} as it is now: recalculated, it would be the same. "
                            + $"Change and save the job first, or decide about the correction as it is."));
            case Identified { Basis.Identity: var identity }:
                if (store.Corrections.OfMeasurement(correction.MeasurementSha256).FirstOrDefault(
                    c => c.Id != correction.Id && IsSame(c, correction, job, identity)) is { } known)
                {
                    throw new DecisionException(
                        DecisionException.AlreadyKnown,
                        string.Create(
                            CultureInfo.InvariantCulture,
                            $"Correction {known.Id} is made of the same measurement with the job as it is now, or adds it already: a "
                                + $"correction is applied once. Look at that one, and reject correction {correction.Id}."));
                }

                break;
            case RefusedComputation refused:
                throw new DecisionException(
                    DecisionException.JobUnusable,
                    string.Create(
                        CultureInfo.InvariantCulture,
                        $"Correction {correction.Id} stays as it is, for the job {job.Name} cannot be used as it is now: "
                            + $"{refused.Reason} Put that right first."));
            case var other:
                throw new InvalidOperationException($"A measurement that is not computed yet came to {other.GetType().Name}.");
        }
    }

    // The same test by which recognition would refuse it.
    private static bool IsSame(Correction other, Correction correction, CellJobSettings job, string identity) =>
        other.Identity == identity
            || (job.Accumulates && other.Identity is not null && other.Job == correction.Job && other.Piece == correction.Piece);
}

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
