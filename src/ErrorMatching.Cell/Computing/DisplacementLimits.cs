namespace ErrorMatching.Cell;

/// <summary>The limits of the policy for one correction.</summary>
/// <param name="policy">The policy.</param>
/// <param name="jobLimitMm">The job's own limit, which stands in where the policy has none for the sum.</param>
internal sealed class DisplacementLimits(PolicySettings policy, double jobLimitMm)
{
    /// <summary>Why one step is too large, or null.</summary>
    /// <param name="mm">Its largest displacement.</param>
    /// <param name="at">Where that is.</param>
    /// <param name="block">The block concerned, or null.</param>
    public RefusedComputation? OfStep(double mm, string at, string? block) => policy.LimitMm is { } limit && !(mm <= limit)
        ? new(CorrectionCodes.OverLimit, Recorded.OverLimit.With(at, mm, limit))
        { Block = block }
        : null;

    /// <summary>Why the sum since the original program is too large, or null. Without a limit of its own, that of one step counts.</summary>
    /// <param name="mm">The largest distance from the original program.</param>
    /// <param name="at">Where that is.</param>
    /// <param name="block">The block concerned, or null.</param>
    public RefusedComputation? OfSum(double mm, string at, string? block)
    {
        var limit = policy.SumLimitMm ?? policy.LimitMm ?? jobLimitMm;
        return !(mm <= limit)
            ? new(CorrectionCodes.OverSumLimit, Recorded.OverSumLimit.With(at, mm, limit))
            { Block = block }
            : null;
    }
}
