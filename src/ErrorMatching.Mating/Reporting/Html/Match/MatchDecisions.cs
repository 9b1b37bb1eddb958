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
