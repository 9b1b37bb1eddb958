using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The section with the decision on each feature and its reason.</summary>
internal static class MatchDecisions
{
    public static void Write(HtmlText html, MatchReport report)
    {
        var (between, probable) = (
            report.Features.Any(f => f.WorstBetween is not null), report.Features.Any(f => f.ProbabilityAfter is not null));
        var columns = Columns(between, probable);
        HtmlTable.Write(html, "decisions-table", "What was decided about each feature", columns, report.Features, (row, feature) =>
        {
            var outside = report.OutsideOf(feature);
            row.Header(feature.Name);
            row.Text(feature.Kind.Word);
            using (row.Cell())
            {
                DecisionMark.Write(html, feature.Decision);
            }

            row.Number(ReportNumber.Signed(feature.Tolerance.Band.LowerMm));
            row.Number(ReportNumber.Signed(feature.Tolerance.Band.UpperMm));
            row.Text(ReportWords.Of(feature.Tolerance.Source));
            row.Number(ReportNumber.Signed(feature.LargestMm));
            row.Number(ReportNumber.Fine(feature.UncertaintyMm));
            row.Number(
                report.PointsOf(feature).MaxBy(p => Math.Abs(p.PredictedMm)) is { } left
                    ? (outside.Points.Count > 0 ? "⚠ " : "") + MatchKeyPoints.Left(left)
                    : ReportNumber.None);
            if (between)
            {
                row.Number(
                    ErrorLeft.Between(feature) is { } worst
                        ? (worst.IsOutside ? "⚠ " : "") + (worst.IsKnown ? VerdictWords.Signed(worst) : "not known")
                        : ReportNumber.None);
                row.Text(ErrorLeft.Between(feature) is { } place ? VerdictWords.Place(place) : ReportNumber.None);
            }

            if (probable)
            {
                row.Number(feature.ProbabilityBefore is { } before ? ReportNumber.Probability(before) : ReportNumber.None);
                row.Number(feature.ProbabilityAfter is { } after ? ReportNumber.Probability(after) : ReportNumber.None);
            }

            using (row.Cell("prose"))
            {
                html.Text(string.Join(" ", [DecisionReason.Of(report, feature), .. OutsideWords.Of(outside)]));
            }
        });
        html.Put("p", string.Join(" ", [Meaning(report.Compensation), .. RuleWords.Of(report)]), ("class", "small"));
    }

    private static TableColumn[] Columns(bool between, bool probable) =>
        [
            new("Feature"), new("Kind"), new("Decision"), new("Lower, mm", true, "Tolerance"), new("Upper, mm", true, "Tolerance"),
            new("From", false, "Tolerance"),
            new("Largest deviation, mm", true), new("Standard uncertainty, mm", true), new("Left as predicted, mm", true),
            .. between ? [new("Worst, mm", true, "Left between the points"), new("Place", false, "Left between the points")]
                : Array.Empty<TableColumn>(),
            .. probable ? [new("without", true, "Within limits, with and without compensation"),
                    new("with", true, "Within limits, with and without compensation")]
                : Array.Empty<TableColumn>(),
            new("Reason"),
        ];

    private static string Meaning(JobCompensation compensation) =>
        (compensation.From == CompensationSource.Part
            ? "Deviations are part - design"
            : "Deviations are part - measured counterpart")
        + ", along the normal from the counterpart's material to its tool: positive where the counterpart has to keep more material. What "
            + "is left is the predicted mating error, counterpart - part: positive overlaps, negative leaves a gap, with its 95 % "
            + "interval; ⚠ marks what will be outside its limits. "
        + $"Asked for: {ReportWords.Of(compensation.Amount)} deviation, gain {ReportNumber.Short(compensation.Gain)}, along the "
            + $"{ReportWords.Of(compensation.Along)}; a deviation beyond {ReportNumber.Plain(compensation.LimitMm)} mm would have "
            + $"stopped the job.";
}

/// <summary>A decision as a mark and words, so that it does not depend on color.</summary>
internal static class DecisionMark
{
    public static void Write(HtmlText html, Decision decision) =>
        html.Put("span", $"{Mark(decision)} {Words(decision)}", ("class", "mark " + ReportWords.Of(decision)));

    /// <summary>The decision in words.</summary>
    public static string Words(Decision decision) => decision switch
    {
        Decision.WithinTolerance => "within tolerance",
        Decision.NotSignificant => "not significant",
        _ => "compensated",
    };

    private static string Mark(Decision decision) =>
        decision switch { Decision.WithinTolerance => "✓", Decision.NotSignificant => "○", _ => "◆" };
}

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

/// <summary>The section with ideal, actual and corrected lengths and angles, and the fits of the features.</summary>
internal static class MatchQuantities
{
    private static readonly TableColumn[] Columns =
        [
            new("Feature"), new("Quantity"), new("Unit"), new("Ideal", true), new("Actual", true), new("Deviation", true),
            new("Standard uncertainty", true), new("Corrected", true)];

    private static readonly TableColumn[] FitColumns =
        [
            new("Feature"), new("Degree", true), new("Ridge", true), new("Residual standard deviation, mm", true),
            new("Error when a point is left out, mm", true), new("Largest residual, mm", true), new("Stands out of its plane, mm", true)];

    public static void Write(HtmlText html, MatchReport report)
    {
        HtmlTable.Write(
            html,
            "quantities-table",
            "Lengths and angles of the features",
            Columns,
            report.Features.SelectMany(f => f.Quantities.Select(q => (Feature: f, q.Quantity, q.Corrected))),
            (row, q) =>
        {
            row.Header(q.Feature.Name);
            row.Text(QuantityName.Words(q.Quantity.Name));
            row.Text(QuantityName.Unit(q.Quantity.Name));
            row.Number(ReportNumber.Plain(q.Quantity.Theoretical));
            row.Number(ReportNumber.Plain(q.Quantity.Actual));
            row.Number(ReportNumber.Signed(-q.Quantity.Deviation));
            row.Number(ReportNumber.Fine(q.Quantity.StandardUncertainty));
            row.Number(q.Corrected is { } corrected ? ReportNumber.Plain(corrected) : ReportNumber.None);
        });
        html.Put(
            "p",
            "Ideal: by the theoretical points. Actual: by the measured ones. Deviation: actual - ideal. Corrected: on the counterpart as "
                + "the new program cuts it.",
            ("class", "small"));
        HtmlTable.Write(html, "fits-table", "How well the measured points fit their features", FitColumns, report.Features, (row, f) =>
        {
            row.Header(f.Name);
            row.Number(f.Curve is { } c ? ReportNumber.Count(c.Degree) : ReportNumber.None);
            row.Number(f.Curve is { } r ? ReportNumber.Rough(r.Ridge) : ReportNumber.None);
            row.Number(f.Curve is { } s ? ReportNumber.Fine(s.ResidualStandardDeviationMm) : ReportNumber.None);
            row.Number(f.Curve?.LeaveOneOutMm is { } left ? ReportNumber.Fine(left) : ReportNumber.None);
            row.Number(f.ResidualsMm.Count > 0 ? ReportNumber.Fine(f.ResidualsMm.Max(Math.Abs)) : ReportNumber.None);
            row.Number(f.StandsOutMm is { } height ? ReportNumber.Plain(height) : ReportNumber.None);
        });
    }
}

/// <summary>Display names of quantities.</summary>
internal static class QuantityName
{
    /// <summary>The name in words; an unknown name is returned unchanged.</summary>
    public static string Words(string name) =>
        FeatureKinds.All.Select(k => k.Quantities.GetValueOrDefault(name)).FirstOrDefault(words => words is not null) ?? name;

    /// <summary>The unit at the end of a name.</summary>
    public static string Unit(string name) =>
        name.EndsWith("Deg", StringComparison.Ordinal) ? "°" : name.EndsWith("Mm", StringComparison.Ordinal) ? "mm" : "";
}
