using ErrorMatching.Json;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>A reverted program that a correction builds on. Such a correction is not sent.</summary>
/// <param name="By">The correction that made the program and was reverted.</param>
internal sealed record RevertedBase(Correction By)
{
    /// <summary>Why the correction is not sent, and what to do.</summary>
    public Statement Reason => Recorded.BaseReverted.With(By.Id, By.Reason);

    /// <summary>The reverted program that a correction builds on; null if it builds on none, or on one that was not reverted.</summary>
    /// <param name="flow">State shared by the workers.</param>
    /// <param name="correction">A computed correction.</param>
    public static RevertedBase? Of(CellFlow flow, Correction correction)
    {
        if (correction is not { BaseSha256: { } program, SumsSha256: not null, Job: { } job })
        {
            return null;
        }

        var made = flow.Store.Corrections.OfProgram(job, program);
        return made.Any(c => CorrectionSteps.Of(c.State).IsSent)
            || made.LastOrDefault(c => c.State == CorrectionState.Reverted) is not { } reverted
            || IsOriginal(flow, job, program)
            ? null
            : new(reverted);
    }

    // If there was nothing to displace, a correction sent the original itself.
    private static bool IsOriginal(CellFlow flow, string job, string sha256)
    {
        try
        {
            return flow.Settings.Jobs.FirstOrDefault(j => j.Name == job) is { } settings
                && OriginalPrograms.Of(settings) is { } original
                && ContentHash.Sha256(original.Span) == sha256;
        }
        catch (InputException)
        {
            // An unreadable program cannot be distinguished from the reverted one, so this gives the cautious answer.
            return false;
        }
    }
}
