using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <summary>Undecided corrections that were computed with the job before it was saved.</summary>
/// <param name="station">The station.</param>
/// <param name="who">Returns the signed-in user.</param>
internal sealed class EarlierCorrections(Station station, Func<SignedIn?> who)
{
    /// <summary>Those that the notice about saving offers to recalculate, in queue order.</summary>
    public IReadOnlyList<Correction> Waiting { get; private set; } = [];

    /// <summary>The first correction in the notice about saving or recalculating; null if there is none.</summary>
    public long? First { get; private set; }

    /// <summary>True if there are any and the user may recalculate them.</summary>
    public bool CanCompute => Waiting.Count > 0 && who() is { } user && Rights.Allows(user.Role, Act.Reject);

    /// <summary>Offers to recalculate corrections.</summary>
    public void Offer(IReadOnlyList<Correction> waiting) => (Waiting, First) = (waiting, waiting is [var first, ..] ? first.Id : null);

    /// <summary>The corrections of a job that are waiting, approved or failed, under all names that the configuration has for it.</summary>
    public IReadOnlyList<Correction> Undecided(CellJobSettings job)
    {
        var names = station.Settings.Jobs.Where(j => j.File == job.File).Select(j => j.Name).ToArray();
        return [
            .. station.Store.Corrections.InState([.. CorrectionSteps.Before(CorrectionState.Rejected)])
                .Where(c => names.Contains(c.Job))];
    }

    /// <summary>Those of them that were computed with another version of the job, in queue order.</summary>
    public IReadOnlyList<Correction> MadeBefore(CellJobSettings job)
    {
        var undecided = Undecided(job);
        var changed = new ChangedJobs(station.Settings).Among(station.Store, undecided);
        return [.. undecided.Where(c => changed.Contains(c.Id)).OrderBy(c => c.Turn)];
    }

    /// <summary>Recalculates the offered corrections with the current job.</summary>
    /// <returns>The result, in words.</returns>
    public async Task<Func<string>> ComputeAsync()
    {
        var (waiting, by, given, failed) = (
            Waiting, who()!, new List<Correction>(), new List<(Correction Correction, Exception Failure)>());
        await Task.Run(() =>
        {
            var recalculation = new Recalculation(station.Settings, station.Store);
            foreach (var correction in waiting)
            {
                try
                {
                    station.Users.Demand(by, Act.Reject);
                    given.Add(recalculation.Recalculate(correction.Id, by.Name, null));
                }
                catch (Exception e) when (Failures.IsKnown(e))
                {
                    // Recalculate the others all the same.
                    failed.Add((correction, e));
                }
            }
        });
        First = given.Concat(failed.Select(f => f.Correction)).FirstOrDefault()?.Id;

        // A decision would stop them again. Those that failed for another reason can be retried.
        Waiting = [.. failed.Where(f => f.Failure is not DecisionException).Select(f => f.Correction)];
        return () => Sentence.Joined(
        [
            waiting.Count > failed.Count ? Texts.Current.With("Setup.Recalculated", waiting.Count - failed.Count) : "",
            .. failed.Select(f => Texts.Current.With(
                "Setup.NotRecalculated", CorrectionLabel.Of(f.Correction), Failures.Of(f.Failure, station.Clock))),
        ]);
    }
}
