using ErrorMatching.Cell;
using ErrorMatching.Jobs;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;

namespace ErrorMatching.Hmi;

/// <content>The versions of the job: each that was saved can be brought back into the form, and is saved from there as any other.</content>
public sealed partial class JobEditing
{
    /// <summary>The saved versions of the job, the latest first; none before they are read.</summary>
    public RowList<VersionRow> Versions { get; } = [];

    /// <summary>The version that is chosen; null if none is.</summary>
    public VersionRow? Version
    {
        get;
        set
        {
            if (Set(ref field, value))
            {
                Restore.Refresh();
            }
        }
    }

    /// <summary>Brings the chosen version back into the form. Nothing is saved by that.</summary>
    public LongCommand Restore { get; }

    // A store that is away leaves the list empty; the banner says so.
    private async Task ReadVersionsAsync(CellJobSettings job)
    {
        IReadOnlyList<JobVersion> versions = [];
        if (await Failures.OfAsync(() => versions = Edits.Versions(job), _station.Clock) is null && job == Job)
        {
            ShowVersions(versions);
        }
    }

    private JobEdits Edits => new(_station.Settings, _station.Store, _station.Users);

    private void ShowVersions(IReadOnlyList<JobVersion> versions)
    {
        Versions.Show([.. versions.Select(v => new VersionRow(v, Hmi.Shown.Time(v.At, _station.Clock)))]);
        Version = Versions.FirstOrDefault(v => v.Version.Entry == Version?.Version.Entry);
    }

    private async Task RestoreAsync()
    {
        var (job, row) = (Job!, Version!);
        MatingDraft? draft = null;
        string? refusal = null;
        var isRead = await TryAsync(() =>
        {
            try
            {
                draft = Edits.Open(job, row.Version);
            }
            catch (Exception e) when (e is JobException or MeasurementException or DraftException)
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
        Note(() => Texts.Current.With("Setup.Restored", row.Time));
    }
}
