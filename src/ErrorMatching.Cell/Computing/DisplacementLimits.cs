using System.Globalization;

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
        ? new(CorrectionCodes.OverLimit, string.Create(
            CultureInfo.InvariantCulture,
            $"At {at} the program would move by {mm:0.0000} mm; the policy allows {limit:0.####} mm in one step. Look for a wrong part, a chip or a wrong probe; if the piece really is so, a setter raises limitMm."))
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
            ? new(CorrectionCodes.OverSumLimit, string.Create(
                CultureInfo.InvariantCulture,
                $"At {at} the program would lie {mm:0.0000} mm from the original one; the policy allows {limit:0.####} mm in sum. Find out why errors add up: worn tool, drift, wrong clamping. If it is meant, a setter raises sumLimitMm."))
            { Block = block }
            : null;
    }
}
