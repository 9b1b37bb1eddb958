using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <content>Undecided corrections that were computed with the job before it was saved.</content>
public sealed partial class JobEditing
{
    private IReadOnlyList<Correction> _waiting = [];
    private long? _first;

    /// <summary>Recalculates the corrections that are waiting, approved or failed with the current job.</summary>
    public LongCommand ComputeAnew { get; }

    /// <summary>True while the notice about saving is shown and the user may recalculate.</summary>
    public bool CanComputeAnew => _notice is not null && _waiting.Count > 0 && _who() is { } who && Rights.Allows(who.Role, Act.Reject);

    /// <summary>Button text with the number of corrections.</summary>
    public string ComputeAnewText => Texts.Current.With("Setup.ComputeAnew", _waiting.Count);

    /// <summary>The first correction in the notice about saving or recalculating; null if there is none.</summary>
    public long? FirstWaiting => _notice is null ? null : _first;

    // Under all names that the configuration has for this job.
    private Correction[] Undecided(CellJobSettings job)
    {
        var names = _station.Settings.Jobs.Where(j => j.File == job.File).Select(j => j.Name).ToArray();
        return [
            .. _station.Store.InState(
                CorrectionState.Proposed, CorrectionState.Approved, CorrectionState.Failed).Where(c => names.Contains(c.Job))];
    }

    // In queue order.
    private IReadOnlyList<Correction> MadeBefore(CellJobSettings job)
    {
        var undecided = Undecided(job);
        var changed = new ChangedJobs(_station.Settings).Among(_station.Store, undecided);
        return [.. undecided.Where(c => changed.Contains(c.Id)).OrderBy(c => c.Turn)];
    }

    private async Task ComputeAnewAsync()
    {
        var (waiting, by, given, failed) = (
            _waiting, _who()!, new List<Correction>(), new List<(Correction Correction, Exception Failure)>());
        await Task.Run(() =>
        {
            var anew = new ComputingAnew(_station.Settings, _station.Store);
            foreach (var correction in waiting)
            {
                try
                {
                    _station.Users.Demand(by, Act.Reject);
                    given.Add(anew.GiveAgain(correction.Id, by.Name, null));
                }
                catch (Exception e) when (Failures.IsKnown(e))
                {
                    // Recalculate the others all the same.
                    failed.Add((correction, e));
                }
            }
        });
        _notice = () => Sentence.Joined(
        [
            waiting.Count > failed.Count ? Texts.Current.With("Setup.ComputedAnew", waiting.Count - failed.Count) : "",
            .. failed.Select(f => Texts.Current.With(
                "Setup.NotComputedAnew", CorrectionLabel.Of(f.Correction), Failures.Of(f.Failure, _station.Clock))),
        ]);

        _first = given.Concat(failed.Select(f => f.Correction)).FirstOrDefault()?.Id;

        // A decision would stop them again. Those that failed for another reason can be retried.
        _waiting = [.. failed.Where(f => f.Failure is not DecisionException).Select(f => f.Correction)];
        Refresh();
    }
}
