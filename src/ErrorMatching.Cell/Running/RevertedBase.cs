using ErrorMatching.Jobs;
using ErrorMatching.Json;
using ErrorMatching.Nc;

namespace ErrorMatching.Cell;

/// <summary>A program that a correction adds to, and that was taken back meanwhile: what is built on it is not sent.</summary>
/// <param name="By">The correction that made the program and was reverted.</param>
internal sealed record RevertedBase(Correction By)
{
    /// <summary>Why the correction is not sent, and what to do.</summary>
    public string Reason => Recorded.BaseReverted.With(By.Id, By.Reason);

    /// <summary>The reverted program that a correction adds to; null where it adds to none, or to one that was not reverted.</summary>
    /// <param name="flow">What workers share.</param>
    /// <param name="correction">A correction that is computed.</param>
    public static RevertedBase? Of(CellFlow flow, Correction correction)
    {
        if (correction is not { BaseSha256: { } program, SumsSha256: not null, Job: { } job })
        {
            return null;
        }

        var made = flow.Store.OfProgram(job, program);
        return made.Any(c => c.State is CorrectionState.Verified or CorrectionState.Released) || made.LastOrDefault(c => c.State == CorrectionState.Reverted) is not { } reverted || IsOriginal(flow, job, program)
            ? null
            : new(reverted);
    }

    // A correction that had nothing to displace sent the original itself.
    private static bool IsOriginal(CellFlow flow, string job, string sha256)
    {
        try
        {
            return flow.Settings.Jobs.FirstOrDefault(j => j.Name == job) is { } settings && OriginalPrograms.Of(settings) is { } original && new KeptFile("", original).Sha256 == sha256;
        }
        catch (Exception e) when (e is InputException or JsonDocumentException or NcException)
        {
            // What cannot be read now cannot be told from the reverted one: that stays the careful answer.
            return false;
        }
    }
}
