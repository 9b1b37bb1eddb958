using ErrorMatching.Cell;
using ErrorMatching.Jobs;
using ErrorMatching.Refusals;

namespace ErrorMatching.Hmi;

/// <summary>The saved versions of the edited job. Each can be loaded into the form and saved from there.</summary>
/// <param name="editing">The edited job.</param>
/// <param name="edits">Reads the versions.</param>
/// <param name="clock">The clock.</param>
internal sealed class SavedVersions(JobEditing editing, JobEdits edits, TimeProvider clock)
{
    /// <summary>The versions, the latest first; empty until they are read.</summary>
    public RowList<VersionRow> Rows { get; } = [];

    /// <summary>Completes when the chosen version is in the form.</summary>
    public Task Restoring { get; private set; } = Task.CompletedTask;

    /// <summary>Reads the versions of a job. If the store is unavailable, there are none and the banner shows why.</summary>
    public async Task ReadAsync(CellJobSettings job)
    {
        IReadOnlyList<JobVersion> versions = [];
        if (await Failures.OfAsync(() => versions = edits.Versions(job), clock) is null && job == editing.Job)
        {
            Rows.Show([.. versions.Select(Row)]);
        }
    }

    /// <summary>Shows none, because another job is opened.</summary>
    public void Clear() => Rows.Show([]);

    /// <summary>Updates for another user.</summary>
    public void Refresh()
    {
        foreach (var row in Rows)
        {
            row.Restore.Refresh();
        }
    }

    private VersionRow Row(JobVersion version)
    {
        var time = Shown.Time(version.At, clock);
        return new(version, time, new(() => Restoring = RestoreAsync(editing.Job!, version, time).Watched(), () => editing.CanEdit));
    }

    private async Task RestoreAsync(CellJobSettings job, JobVersion version, string time)
    {
        MatingDraft? draft = null;
        string? refusal = null;
        var isRead = await editing.TryAsync(() =>
        {
            try
            {
                draft = edits.Open(job, version);
            }
            catch (Exception e) when (e is InputException or DraftException)
            {
                refusal = Failures.Of(e, clock);
            }
        });
        if (!isRead || job != editing.Job)
        {
            return;
        }

        if (refusal is not null)
        {
            editing.Message = Texts.Current.With("Setup.NotOpened", refusal);
            return;
        }

        editing.Change("", _ => draft!);
        editing.Note(() => Texts.Current.With(editing.IsBeside ? "Setup.RestoredBeside" : "Setup.Restored", time));
    }
}

/// <summary>A row for a saved version of a job.</summary>
/// <param name="Version">The version.</param>
/// <param name="Time">When it was saved.</param>
/// <param name="Restore">Loads it into the form.</param>
public sealed record VersionRow(JobVersion Version, string Time, Command Restore)
{
    private const int Digits = 8;

    /// <summary>Time, job name, user, and the first digits of the hash.</summary>
    public string Text => $"{Time} · {Version.Name} · {Version.By} · {Version.Sha256[..Digits]}…";

    /// <summary>The button's name with the version, for screen readers.</summary>
    public string Name => $"{Texts.Current["System.Restore"]} {Text}";

    public string AutomationId => "version-" + Shown.Id(Version.Entry);
}
