namespace ErrorMatching.Jobs;

/// <summary>Tells what is still to be filled in from what is wrong.</summary>
internal static class DraftMissing
{
    // As the job's reader says that nothing stands in a field.
    private const string NoText = "the text \"\"";

    private static readonly string[] Codes = ["too-short", "empty-cell", "too-few-items", "stylus-diameter-missing", "measured-missing"];

    /// <summary>A problem, marked if it is only that nothing was filled in there yet.</summary>
    /// <param name="draft">The draft.</param>
    /// <param name="problem">The problem.</param>
    public static DraftProblem Marked(MatingDraft draft, DraftProblem problem) => problem with
    {
        IsMissing = problem.Found == NoText
            || Codes.Contains(problem.Code)
            || (problem.Field == MatingDraftCheck.Program && string.IsNullOrWhiteSpace(draft.Counterpart.Program)),
    };
}
