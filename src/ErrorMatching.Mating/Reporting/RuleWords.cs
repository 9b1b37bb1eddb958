using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>Report texts on the decision rule and its risk.</summary>
public static class RuleWords
{
    /// <summary>The rule with the probability that the pair conforms without compensation, and the risk of each feature that is not
    /// compensated; none for a report older than decision rules.</summary>
    /// <param name="report">The report.</param>
    public static IEnumerable<string> Of(MatchReport report)
    {
        ArgumentNullException.ThrowIfNull(report);
        if (report.Rule is not { } rule || report.Features.Count == 0)
        {
            yield break;
        }

        var guard = ReportNumber.Fine(rule.GuardMm(report.Features[0].UncertaintyMm));
        yield return rule.RiskPercent is { } risk
            ? $"Decision rule guard-band: points are accepted {guard} mm inside their limits, for a risk of at most "
                + $"{ReportNumber.Short(risk)} % at each limit."
            : "Decision rule simple: points are accepted up to their limits.";
        if (report.ProbabilityBefore is { } probability)
        {
            yield return $"Probability that every point is within its limits without compensation: {ReportNumber.Probability(probability)}"
                + (report is { ProbabilityAfter: { } after, IsCorrected: true } ? $", with it: {ReportNumber.Probability(after)}" : "")
                + ", if the errors of the points are independent.";
        }

        var risks = report.Features.Where(f => f.Decision != Decision.Compensated && f.ProbabilityBefore is not null)
            .Select(f => $"{f.Name} {Risk(f)}").ToArray();
        if (risks.Length > 0)
        {
            yield return $"Risk of leaving a point outside its limits: {string.Join(", ", risks)}.";
        }
    }

    /// <summary>Writes the member <c>decisionRule</c> into the open object.</summary>
    internal static void Write(ReportWriter w, DecisionRule? rule) => w.Optional("decisionRule", rule, r =>
    {
        w.Text("rule", ReportWords.Of(r));
        w.Number("riskPercent", r.RiskPercent);
    });

    /// <summary>Reads that member; null in reports older than decision rules.</summary>
    internal static DecisionRule? Read(ReportReader document) => document.OptionalObject("decisionRule") is not { } rule
        ? null
        : rule.OptionalNumber("riskPercent") switch
        {
            null => DecisionRule.Simple,
            >= 0.01 and <= 50 and var risk => DecisionRule.GuardBand(risk),
            _ => throw rule.Refusal("riskPercent", "number-out-of-range", "a number from 0.01 to 50"),
        };

    /// <summary>The probability that a point of a feature is outside its limits without compensation; null if it is not known.</summary>
    internal static string? Risk(ReportFeature feature) =>
        feature.ProbabilityBefore is { } probability ? ReportNumber.Probability(1 - probability) : null;
}
