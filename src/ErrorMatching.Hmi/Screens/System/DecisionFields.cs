using ErrorMatching.Jobs;

namespace ErrorMatching.Hmi;

/// <summary>The fields of the decision near limits: the rule with its risk, and the gauge for which it is made.</summary>
internal static class DecisionFields
{
    /// <summary>The rule; with guard bands also its risk.</summary>
    /// <param name="editing">The edited job.</param>
    public static IEnumerable<EditField> Of(JobEditing editing)
    {
        yield return new ChoiceField(
            editing,
            "$.decision.rule",
            "System.Rule",
            [DecisionDraft.Simple, "guard-band"],
            d => d.Decision.Rule,
            (d, t) => d with { Decision = d.Decision with { Rule = t } });
        if (editing.Draft.Decision.Rule != DecisionDraft.Simple)
        {
            // The default is that of the job's schema.
            yield return new TextField(
                editing,
                "$.decision.riskPercent",
                "System.Risk",
                d => d.Decision.Risk,
                (d, t) => d with { Decision = d.Decision with { Risk = t } })
            {
                Default = "5",
                MayBeEmpty = _ => true,
            };
        }
    }

    /// <summary>Whether a gauge is accepted whose uncertainty exceeds a tolerance.</summary>
    /// <param name="editing">The edited job.</param>
    public static SwitchField AcceptCoarse(JobEditing editing) => new(
        editing,
        "$.gauge.acceptCoarse",
        "System.AcceptCoarse",
        d => d.Gauge.AcceptsCoarse,
        (d, on) => d with { Gauge = d.Gauge with { AcceptsCoarse = on } });
}
