using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The section with what was decided about each feature, and why.</summary>
internal static class MatchDecisions
{
    private static readonly TableColumn[] Columns =
    [
        new("Feature"), new("Kind"), new("Decision"), new("Lower, mm", true, "Tolerance"), new("Upper, mm", true, "Tolerance"), new("From", false, "Tolerance"),
        new("Largest deviation, mm", true), new("Standard uncertainty, mm", true), new("Left as predicted, mm", true), new("Reason"),
    ];

    public static void Write(HtmlText html, MatchReport report)
    {
        HtmlTable.Write(html, "decisions-table", "What was decided about each feature", Columns, report.Features, (row, feature) =>
        {
            row.Header(feature.Name);
            row.Text(ReportWords.Of(feature.Kind));
            using (row.Cell())
            {
                DecisionMark.Write(html, feature.Decision);
            }

            row.Number(ReportNumber.Signed(feature.Tolerance.Band.LowerMm));
            row.Number(ReportNumber.Signed(feature.Tolerance.Band.UpperMm));
            row.Text(ReportWords.Of(feature.Tolerance.Source));
            row.Number(ReportNumber.Signed(feature.LargestMm));
            row.Number(ReportNumber.Fine(feature.UncertaintyMm));
            row.Number(Left(report, feature) is { } left ? (StaysOutside(feature, left) ? "⚠ " : "") + ReportNumber.Signed(left) : ReportNumber.None);
            using (row.Cell("prose"))
            {
                html.Text(DecisionReason.Of(report, feature));
            }
        });
        html.Put("p", Meaning(report.Compensation), ("class", "small"));
    }

    /// <summary>The mating error of the largest size that the corrected counterpart will leave at the feature.</summary>
    internal static double? Left(MatchReport report, ReportFeature feature) => Points(report, feature).MaxBy(p => Math.Abs(p.PredictedMm))?.PredictedMm;

    /// <summary>True if what is left of a compensated feature is still more than its tolerance allows. The job limits part - counterpart, a mating error is counterpart - part.</summary>
    internal static bool StaysOutside(ReportFeature feature, double left) => feature.Decision == Decision.Compensated && !feature.Tolerance.Band.Contains(-left);

    /// <summary>The key points of a feature.</summary>
    internal static IEnumerable<ReportKeyPoint> Points(MatchReport report, ReportFeature feature) => report.KeyPoints.Where(p => p.Feature == feature.Name);

    private static string Meaning(JobCompensation compensation) =>
        (compensation.From == CompensationSource.Part
            ? "Deviations are part - design"
            : "Deviations are part - measured counterpart")
        + ", along the normal from the counterpart's material to its tool: positive where the counterpart has to keep more material. What is left is the predicted mating error, counterpart - part: positive overlaps, negative leaves a gap; ⚠ marks one that is still outside the tolerance. "
        + $"Asked for: {ReportWords.Of(compensation.Amount)} deviation, gain {ReportNumber.Short(compensation.Gain)}, along the {ReportWords.Of(compensation.Along)}; a deviation beyond {ReportNumber.Plain(compensation.LimitMm)} mm would have stopped the job.";
}
