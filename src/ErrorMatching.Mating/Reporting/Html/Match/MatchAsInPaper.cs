using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The appendix with key points and quantities as figure 9 of Wang 2021 prints them: deviations are theoretical -
/// actual.</summary>
internal static class MatchAsInPaper
{
    private static readonly TableColumn[] PointColumns =
        [
            new("Point"), new("X", true, "Theoretical"), new("Y", true, "Theoretical"), new("X", true, "Actual"), new("Y", true, "Actual"),
            new("X", true, "Theoretical - actual"), new("Y", true, "Theoretical - actual")];

    private static readonly TableColumn[] QuantityColumns =
        [
            new("Feature"), new("Quantity"), new("Unit"), new("Ideal", true), new("Actual", true), new("Ideal - actual", true),
            new("Corrected", true)];

    public static void Write(HtmlText html, MatchReport report)
    {
        html.Put(
            "p",
            "Wang 2021 prints deviations as theoretical - actual, the opposite sign of everything above. These columns are for the "
                + "comparison with its tables; do not mix them with the others.");
        HtmlTable.Write(
            html, "paper-points-table", "Key points as in figure 9 of the paper, mm", PointColumns, report.KeyPoints, (row, p) =>
        {
            row.Header(p.Point);
            row.Number(ReportNumber.Plain(p.Theoretical.X));
            row.Number(ReportNumber.Plain(p.Theoretical.Y));
            row.Number(ReportNumber.Plain(p.Actual.X));
            row.Number(ReportNumber.Plain(p.Actual.Y));
            row.Number(ReportNumber.Signed(p.Deviation.X));
            row.Number(ReportNumber.Signed(p.Deviation.Y));
        });
        HtmlTable.Write(
            html,
            "paper-quantities-table",
            "Lengths and angles as in figure 9 of the paper",
            QuantityColumns,
            report.Features.SelectMany(f => f.Quantities.Select(q => (Feature: f, q.Quantity, q.Corrected))),
            (row, q) =>
        {
            row.Header(q.Feature.Name);
            row.Text(QuantityName.Words(q.Quantity.Name));
            row.Text(QuantityName.Unit(q.Quantity.Name));
            row.Number(ReportNumber.Plain(q.Quantity.Theoretical));
            row.Number(ReportNumber.Plain(q.Quantity.Actual));
            row.Number(ReportNumber.Signed(q.Quantity.Deviation));
            row.Number(q.Corrected is { } corrected ? ReportNumber.Plain(corrected) : ReportNumber.None);
        });
    }
}
