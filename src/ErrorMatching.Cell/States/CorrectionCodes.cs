namespace ErrorMatching.Cell;

/// <summary>Stable codes for the cell's decisions about a measurement, in addition to the console's codes for the same inputs.</summary>
internal static class CorrectionCodes
{
    /// <summary>A correction is larger than the policy allows.</summary>
    public const string OverLimit = "over-limit";

    /// <summary>The sum of corrections since the original program is larger than the policy allows.</summary>
    public const string OverSumLimit = "over-sum-limit";

    /// <summary>A counterpart must be compared with its part, but there is no measurement of the part.</summary>
    public const string PartUnmeasured = "part-unmeasured";

    /// <summary>The job's files were changed between recognition and computation.</summary>
    public const string JobChanged = "job-changed";

    /// <summary>A job that is not feedback is configured to accumulate.</summary>
    public const string NotFeedback = "not-feedback";

    /// <summary>The job allows offsets alone, and none of them can be set.</summary>
    public const string OffsetNotWritten = "offset-not-written";

    /// <summary>The job's last correction at the machine was made by an offset, and this one by blocks, or the other way around.</summary>
    public const string KindChanged = "correction-kind-changed";

    /// <summary>The control's offset would change by more than the job allows in a step.</summary>
    public const string OffsetStep = "offset-step-too-large";

    /// <summary>Recorded: the measured counterpart of a feed-forward job, which is only verified; nothing is sent.</summary>
    public const string FirstArticle = "first-article";

    /// <summary>Recorded: the part of a feedback job, which counterparts are compared with.</summary>
    public const string PartRecorded = "part-recorded";
}
