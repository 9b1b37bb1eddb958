using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The reason for the decision on a feature, in a sentence.</summary>
internal static class DecisionReason
{
    public static string Of(MatchReport report, ReportFeature feature)
    {
        var band = feature.Acceptance ?? feature.Tolerance.Band;
        var outside = report.BeyondTolerance(feature);
        var beyond = outside is [var worst, ..]
            ? $"{(outside.Count == 1 ? "Its" : ReportNumber.Count(outside.Count) + " of its")} "
                + $"{(outside.Count == 1 ? $"point {worst.Point} lies" : "points lie")} outside, "
                + $"{(outside.Count == 1 ? "" : $"point {worst.Point} the furthest: ")}{ReportNumber.Plain(Math.Abs(worst.ExcessMm))} mm "
                + $"beyond its {(report.Rule is { IsGuarded: true } ? "acceptance limit" : "limit")}."
            : "It lies outside its tolerance.";
        return feature.Decision switch
        {
            Decision.WithinTolerance =>
                $"Every point lies between {ReportNumber.Signed(band.LowerMm)} and {ReportNumber.SignedMm(band.UpperMm)}." + Risk(feature),
            Decision.NotSignificant when report.Lot?.Next is not null && feature.SignificantMm is { } worth =>
                $"{beyond} But what the counterparts so far say of the next one is off by no more than {ReportNumber.Fine(worth)} mm, and "
                    + "correcting that gains next to nothing. What else the part shows may be its measurement's." + Risk(feature),
            Decision.NotSignificant when feature.SignificantMm is { } significant =>
                $"{beyond} But none lies more than {ReportNumber.Fine(significant)} mm off, which the gauge may show on a perfect part."
                    + Risk(feature),
            Decision.NotSignificant =>
                $"{beyond} But no deviation is larger than "
                    + $"{ReportNumber.Fine(UncertaintyBudget.CoverageFactor * feature.UncertaintyMm)} mm, "
                    + $"{ReportNumber.Short(UncertaintyBudget.CoverageFactor)} times its uncertainty: it may be the gauge's.",
            _ =>
                $"{beyond}{Together(feature)} The counterpart follows "
                    + $"{(report.Compensation.Amount == CompensationAmount.Whole ? "the whole deviation" : "what lies beyond the limit")}.",
        };
    }

    private static string Together(ReportFeature feature) => feature is { IsSignificantTogether: true, SignificantMm: { } significant }
        ? $" None of them is off by more than {ReportNumber.Fine(significant)} mm, but together they are off by more than the gauge may "
            + "show on a perfect part."
        : "";

    private static string Risk(ReportFeature feature) =>
        RuleWords.Risk(feature) is { } risk ? $" Risk that one lies outside the limits all the same: {risk}." : "";
}
