using ErrorMatching.Cell;
using ErrorMatching.Jobs;
using ErrorMatching.Refusals;

namespace ErrorMatching.Hmi;

/// <summary>Stores unsaved changes off the UI thread, so that they outlive the station.</summary>
internal sealed class DraftRecovery
{
    private readonly Station _station;
    private readonly Action<string> _tell;
    private readonly SynchronizationContext _screen = SynchronizationContext.Current!;
    private readonly DraftFolder _drafts;
    private readonly Latest<DraftSnapshot> _keeping;

    /// <summary>Stores them next to the cell's configuration. Call it on the UI thread.</summary>
    /// <param name="station">The station.</param>
    /// <param name="tell">Receives a failure in words, on the UI thread.</param>
    public DraftRecovery(Station station, Action<string> tell)
    {
        (_station, _tell) = (station, tell);
        _drafts = new(Path.Combine(Path.GetDirectoryName(Path.GetFullPath(station.Settings.File))!, "drafts"));
        _keeping = new(KeepAway);
    }

    /// <summary>Completes when nothing is being stored.</summary>
    public Task Running => _keeping.Running;

    /// <summary>Stores a draft; deletes the stored one if it is the same as the saved job.</summary>
    public void Keep(DraftSnapshot snapshot) => _keeping.Give(snapshot);

    /// <summary>The stored changes of a job; null if there are none.</summary>
    /// <exception cref="InputException">They cannot be read.</exception>
    public StoredDraft? Find(CellJobSettings job) => NamesOf(job).Select(_drafts.Find).FirstOrDefault(k => k is not null);

    /// <summary>Deletes the stored changes of a job.</summary>
    /// <exception cref="OutputException">They cannot be deleted.</exception>
    public void Forget(CellJobSettings job)
    {
        foreach (var name in NamesOf(job))
        {
            _drafts.Forget(name);
        }
    }

    // Changes may be stored under the name of another job of the cell with the same file.
    private IEnumerable<string> NamesOf(CellJobSettings job) =>
        _station.Settings.Jobs.Where(j => j.File == job.File).Select(j => j.Name).Prepend(job.Name).Distinct(StringComparer.Ordinal);

    private void KeepAway(DraftSnapshot snapshot)
    {
        try
        {
            if (snapshot.Draft.IsSame(snapshot.Base))
            {
                Forget(snapshot.Job);
            }
            else
            {
                _drafts.Keep(
                    new()
                    {
                        Job = snapshot.Job.Name,
                        By = snapshot.By,
                        At = snapshot.At,
                        BaseSha256 = snapshot.BaseSha256,
                        Draft = snapshot.Draft
                    });
            }
        }
        catch (OutputException e)
        {
            _screen.Post(_ => _tell(Texts.Current.With("Setup.NotKept", Failures.Of(e, _station.Clock))), null);
        }
    }
}
