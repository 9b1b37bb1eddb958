using ErrorMatching.Cell;

namespace ErrorMatching.Hmi;

/// <content>Corrections that wait and were made with the job as it was before it was saved.</content>
public sealed partial class JobEditing
{
    private IReadOnlyList<Correction> _waiting = [];
    private long? _first;

    /// <summary>Lets the corrections that still wait, are approved or failed be computed with the job as it is now.</summary>
    public LongCommand ComputeAnew { get; }

    /// <summary>True where that is offered: as long as it is said that the job was saved, to whoever may.</summary>
    public bool CanComputeAnew => _notice is not null && _waiting.Count > 0 && _who() is { } who && Rights.Allows(who.Role, Act.Reject);

    /// <summary>That, and for how many.</summary>
    public string ComputeAnewText => Texts.Current.With("Setup.ComputeAnew", _waiting.Count);

    /// <summary>The first of the corrections that is spoken of where it is said that the job was saved, or that they were computed anew;
    /// null if none is.</summary>
    public long? FirstWaiting => _notice is null ? null : _first;

    // Of all names under which the configuration has this job.
    private Correction[] Undecided(CellJobSettings job)
    {
        var names = _station.Settings.Jobs.Where(j => j.File == job.File).Select(j => j.Name).ToArray();
        return [
            .. _station.Store.InState(
                CorrectionState.Proposed, CorrectionState.Approved, CorrectionState.Failed).Where(c => names.Contains(c.Job))];
    }

    // In the order of their lines.
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
                    // The others are computed all the same.
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

        // What a decision stands against, it does the next time as well; what could not be reached may be tried again.
        _waiting = [.. failed.Where(f => f.Failure is not DecisionException).Select(f => f.Correction)];
        Refresh();
    }
}
