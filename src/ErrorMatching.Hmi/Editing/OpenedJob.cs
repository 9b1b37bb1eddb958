using ErrorMatching.Cell;
using ErrorMatching.Jobs;
using ErrorMatching.Json;
using ErrorMatching.Refusals;

namespace ErrorMatching.Hmi;

/// <summary>A job read from its file to be edited.</summary>
/// <param name="Sha256">Hash of the job.</param>
/// <param name="Draft">The saved job as a draft; null if it cannot be read.</param>
/// <param name="HasComments">True if the job's file has comments.</param>
/// <param name="Stored">Earlier unsaved changes; null if there are none.</param>
/// <param name="IsKeptBroken">True if these cannot be read.</param>
/// <param name="Message">What cannot be read, and why; null if all can.</param>
internal sealed record OpenedJob(
    string Sha256, MatingDraft? Draft, bool HasComments, StoredDraft? Stored, bool IsKeptBroken, string? Message)
{
    /// <summary>Reads a job. Do not call it on the UI thread.</summary>
    public static OpenedJob Read(CellJobSettings job, DraftRecovery recovery, TimeProvider clock)
    {
        StoredDraft? kept = null;
        var (isBroken, message) = (false, (string?)null);
        try
        {
            kept = recovery.Find(job);
        }
        catch (InputException e)
        {
            (isBroken, message) = (true, Texts.Current.With("Setup.StoredBroken", Failures.Of(e, clock)));
        }

        try
        {
            var sha256 = JobEdits.Sha256Of(job);
            var draft = MatingDraftFiles.Open(job.File);
            return new(
                sha256,
                draft,
                MatingDraftFiles.HasComments(InputFile.Bytes(job.File, JsonLimits.Default.MaxBytes)),
                kept is { } k && k.BaseSha256 == sha256 && k.Draft.IsSame(draft) ? null : kept,
                isBroken,
                message);
        }
        catch (Exception e) when (e is InputException or DraftException)
        {
            return new("", null, false, null, isBroken, Texts.Current.With("Setup.NotOpened", Failures.Of(e, clock)));
        }
    }
}
