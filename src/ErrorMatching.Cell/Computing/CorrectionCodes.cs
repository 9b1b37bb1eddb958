namespace ErrorMatching.Cell;

/// <summary>Stable words for what the cell decides about a measurement beside what the console says to the same inputs.</summary>
public static class CorrectionCodes
{
    /// <summary>A correction is larger than the policy allows.</summary>
    public const string OverLimit = "over-limit";

    /// <summary>The sum of corrections since the original program is larger than the policy allows.</summary>
    public const string OverSumLimit = "over-sum-limit";

    /// <summary>A counterpart is to be compared with its part, and no measurement of the part is there.</summary>
    public const string PartUnmeasured = "part-unmeasured";

    /// <summary>The job's files were changed between recognizing and computing.</summary>
    public const string JobChanged = "job-changed";

    /// <summary>A job shall accumulate that is no feedback.</summary>
    public const string NotFeedback = "not-feedback";

    /// <summary>Recorded: a counterpart of a feed-forward job was measured, which verifies and sends nothing.</summary>
    public const string FirstArticle = "first-article";

    /// <summary>Recorded: the part of a feedback job, which counterparts are compared with.</summary>
    public const string PartRecorded = "part-recorded";
}
