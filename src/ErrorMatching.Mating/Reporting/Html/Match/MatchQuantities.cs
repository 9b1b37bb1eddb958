using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

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
