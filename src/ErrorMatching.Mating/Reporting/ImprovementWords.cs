namespace ErrorMatching.Mating;

/// <summary>Report texts on how much smaller an error became.</summary>
public static class ImprovementWords
{
    private const string Within = "within u", Better = "better", Worse = "worse";

    /// <summary>The improvement: a percentage, or words where the gauge cannot tell it.</summary>
    /// <param name="feature">The quantity.</param>
    /// <param name="percent">The text for a percentage.</param>
    /// <param name="none">The text where there was no error before.</param>
    public static string Of(VerifiedFeature feature, Func<double, string> percent, string none)
    {
        ArgumentNullException.ThrowIfNull(feature);
        ArgumentNullException.ThrowIfNull(percent);
        return feature switch
        {
            { ImprovementPercent: null } => none,
            { IsChangeUncertain: true } => Within,
            { IsBeforeUncertain: true } => feature.ImprovementPercent > 0 ? Better : Worse,
            _ => percent(feature.ImprovementPercent.Value),
        };
    }

    /// <summary>What the words mean, one sentence each; none if all improvements are percentages.</summary>
    /// <param name="features">The quantities.</param>
    public static IEnumerable<string> Legend(IReadOnlyList<VerifiedFeature> features)
    {
        var words = features.Select(f => Of(f, _ => "", "")).ToHashSet(StringComparer.Ordinal);
        if (words.Contains(Within))
        {
            yield return "Within u: the error changed by less than the gauge's uncertainty (k = 2).";
        }

        if (words.Contains(Better) || words.Contains(Worse))
        {
            yield return "Better, worse: the error before was within that uncertainty, so a percentage of it says nothing.";
        }
    }
}
