using ErrorMatching.Cell;
using ErrorMatching.Jobs;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Hmi;

/// <content>The saved versions of the job. Each can be loaded into the form and saved from there.</content>
public sealed partial class JobEditing
{
    /// <summary>The saved versions of the job, the latest first; empty until they are read.</summary>
    public RowList<VersionRow> Versions { get; } = [];

    /// <summary>Completes when the chosen version is in the form.</summary>
    internal Task Restoring { get; private set; } = Task.CompletedTask;

    // If the store is unavailable, the list is empty and the banner shows why.
    private async Task ReadVersionsAsync(CellJobSettings job)
    {
        IReadOnlyList<JobVersion> versions = [];
        if (await Failures.OfAsync(() => versions = Edits.Versions(job), _station.Clock) is null && job == Job)
        {
            ShowVersions(versions);
        }
    }

    private JobEdits Edits => new(_station.Settings, _station.Store, _station.Users);

    private void ShowVersions(IReadOnlyList<JobVersion> versions) => Versions.Show([.. versions.Select(Row)]);

    private VersionRow Row(JobVersion version)
    {
        var time = Hmi.Shown.Time(version.At, _station.Clock);
        return new(version, time, new(() => Restoring = RestoreAsync(Job!, version, time).Watched(), () => CanEdit));
    }

    private async Task RestoreAsync(CellJobSettings job, JobVersion version, string time)
    {
        MatingDraft? draft = null;
        string? refusal = null;
        var isRead = await TryAsync(() =>
        {
            try
            {
                draft = Edits.Open(job, version);
            }
            catch (Exception e) when (e is InputException or DraftException)
            {
                refusal = Failures.Of(e, _station.Clock);
            }
        });
        if (!isRead || job != Job)
        {
            return;
        }

        if (refusal is not null)
        {
            Message = Texts.Current.With("Setup.NotOpened", refusal);
            return;
        }

        Change("", _ => draft!);
        Note(() => Texts.Current.With(IsBeside ? "Setup.RestoredBeside" : "Setup.Restored", time));
    }
}
