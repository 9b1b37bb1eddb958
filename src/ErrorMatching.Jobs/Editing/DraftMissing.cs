namespace ErrorMatching.Jobs;

/// <summary>Distinguishes fields that are not filled in yet from wrong ones.</summary>
internal static class DraftMissing
{
    // How the job's reader reports an empty field.
    private const string NoText = "the text \"\"";

    private static readonly string[] Codes = ["too-short", "empty-cell", "too-few-items", "stylus-diameter-missing", "measured-missing"];

    /// <summary>The problem, marked if the field is only not filled in yet.</summary>
    /// <param name="draft">The draft.</param>
    /// <param name="problem">The problem.</param>
    public static DraftProblem Marked(MatingDraft draft, DraftProblem problem) => problem with
    {
        IsMissing = problem.Found == NoText
            || Codes.Contains(problem.Code)
            || (problem.Field == MatingDraftCheck.Program && string.IsNullOrWhiteSpace(draft.Counterpart.Program)),
    };
}
