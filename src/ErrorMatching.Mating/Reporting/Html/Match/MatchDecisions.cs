using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The section with the decision on each feature and its reason.</summary>
internal static class MatchDecisions
{
    private static readonly TableColumn[] Columns =
    [
        new("Feature"), new("Kind"), new("Decision"), new("Lower, mm", true, "Tolerance"), new("Upper, mm", true, "Tolerance"),
        new("From", false, "Tolerance"),
        new("Largest deviation, mm", true), new("Standard uncertainty, mm", true), new("Left as predicted, mm", true), new("Reason"),
    ];

    public static void Write(HtmlText html, MatchReport report)
    {
        HtmlTable.Write(html, "decisions-table", "What was decided about each feature", Columns, report.Features, (row, feature) =>
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
                report.LeftMm(feature) is { } left
                    ? (outside.Points.Count > 0 ? "⚠ " : "") + ReportNumber.Signed(left)
                    : ReportNumber.None);
            using (row.Cell("prose"))
            {
                html.Text(string.Join(" ", [DecisionReason.Of(report, feature), .. OutsideWords.Of(outside)]));
            }
        });
        html.Put("p", string.Join(" ", [Meaning(report.Compensation), .. RuleWords.Of(report)]), ("class", "small"));
    }

    private static string Meaning(JobCompensation compensation) =>
        (compensation.From == CompensationSource.Part
            ? "Deviations are part - design"
            : "Deviations are part - measured counterpart")
        + ", along the normal from the counterpart's material to its tool: positive where the counterpart has to keep more material. What "
            + "is left is the predicted mating error, counterpart - part: positive overlaps, negative leaves a gap; ⚠ marks a feature "
            + "of which a point will be outside its limits. "
        + $"Asked for: {ReportWords.Of(compensation.Amount)} deviation, gain {ReportNumber.Short(compensation.Gain)}, along the "
            + $"{ReportWords.Of(compensation.Along)}; a deviation beyond {ReportNumber.Plain(compensation.LimitMm)} mm would have "
            + $"stopped the job.";
}
