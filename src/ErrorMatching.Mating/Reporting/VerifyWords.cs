using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>Report texts of the verdict on a counterpart that is cut and measured.</summary>
public static class VerifyWords
{
    /// <summary>within-limits, no-limits or outside-limits.</summary>
    public static string Of(VerifyCode code) => code switch
    {
        VerifyCode.Within => "within-limits",
        VerifyCode.NoLimits => "no-limits",
        _ => "outside-limits",
    };

    /// <summary>The verdict in words: how many points are within their limits, and which are not.</summary>
    public static string Of(VerifyVerdict verdict)
    {
        ArgumentNullException.ThrowIfNull(verdict);
        return verdict.Code switch
        {
            VerifyCode.NoLimits => $"No feature has limits with a width; the worst mating error is {VerdictWords.Size(verdict.Worst)}, "
                + $"at point {verdict.Worst.Point}.",
            VerifyCode.Outside => Outside(verdict),
            _ when verdict.NotAccepted.Count > 0 =>
                $"{Within(verdict)}, but the decision rule does not accept {VerdictWords.Points(verdict.NotAccepted)}: too near the "
                    + $"{(verdict.NotAccepted.Count == 1 ? "limit" : "limits")}.",
            _ => Within(verdict) + ".",
        };
    }

    /// <summary>Whether the two measured pieces go together.</summary>
    /// <param name="pair">The pair.</param>
    /// <param name="report">The report with its limits.</param>
    public static string Of(PairAssembly pair, VerifyReport report)
    {
        ArgumentNullException.ThrowIfNull(pair);
        ArgumentNullException.ThrowIfNull(report);
        return PairWords.Of(pair, [.. report.Result.Boundaries.Select(b => b.ErrorBand)]);
    }

    /// <summary>The risk that a point truly is outside its limits; null if it is not known.</summary>
    public static string? Risk(VerifyVerdict verdict)
    {
        ArgumentNullException.ThrowIfNull(verdict);
        return verdict.Probability is { } within
            ? $"Risk that a point is outside its limits: {ReportNumber.Probability(1 - within)}."
            : null;
    }

    private static string Within(VerifyVerdict verdict) =>
        $"{ReportNumber.Count(verdict.Within)} of {ReportNumber.Count(verdict.Points, "point")} {(verdict.Within == 1 ? "is" : "are")} "
            + $"within {Limits(verdict, verdict.Points)}" + (verdict switch
            {
                { Limits: null, Tightest: { } tightest } =>
                    $" (tightest {VerdictWords.Size(tightest)} within {VerdictWords.Band(tightest.Limits)}, at point {tightest.Point})",
                _ => $" (worst {VerdictWords.Size(verdict.Worst)})",
            });

    private static string Outside(VerifyVerdict verdict)
    {
        var (count, furthest) = (verdict.Outside.Count, verdict.Tightest!);
        return $"{ReportNumber.Count(count)} of {ReportNumber.Count(verdict.Points, "point")} {(count == 1 ? "is" : "are")} outside "
            + $"{Limits(verdict, count)}: {VerdictWords.Points(verdict.Outside)}"
            + (count == 1 ? "" : $", point {furthest.Point} the furthest")
            + $", by {VerdictWords.Size(-furthest.MarginMm, furthest.Interval95Mm)}.";
    }

    private static string Limits(VerifyVerdict verdict, int points) =>
        verdict.Limits is { } limits ? VerdictWords.Band(limits) : points == 1 ? "its limits" : "their limits";
}
