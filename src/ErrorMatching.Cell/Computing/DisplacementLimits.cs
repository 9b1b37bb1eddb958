using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>The limits of the policy for one correction.</summary>
/// <param name="policy">The policy.</param>
/// <param name="jobLimitMm">The job's own limit, used for the sum if the policy has none.</param>
internal sealed class DisplacementLimits(PolicySettings policy, double jobLimitMm)
{
    /// <summary>Why one step is too large; null if it is not.</summary>
    /// <param name="mm">Its largest displacement.</param>
    /// <param name="at">Where that is.</param>
    /// <param name="block">The block concerned; null for none.</param>
    public RefusedComputation? OfStep(double mm, Statement at, string? block) => policy.LimitMm is { } limit && !(mm <= limit)
        ? new(CorrectionCodes.OverLimit, Recorded.OverLimit.With(at, mm, limit))
        { Block = block }
        : null;

    /// <summary>Why the sum since the original program is too large; null if it is not. Without its own limit, the limit for one step
    /// applies.</summary>
    /// <param name="mm">The largest distance from the original program.</param>
    /// <param name="at">Where that is.</param>
    /// <param name="block">The block concerned; null for none.</param>
    public RefusedComputation? OfSum(double mm, Statement at, string? block)
    {
        var limit = policy.SumLimitMm ?? policy.LimitMm ?? jobLimitMm;
        return !(mm <= limit)
            ? new(CorrectionCodes.OverSumLimit, Recorded.OverSumLimit.With(at, mm, limit))
            { Block = block }
            : null;
    }
}
