using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The section with the key points, as in figure 9 of Wang 2021.</summary>
internal static class MatchKeyPoints
{
    public static void Write(HtmlText html, MatchReport report)
    {
        var outside = report.Outside.Points;
        var measured = report.KeyPoints.Any(p => p.Counterpart is not null);
        HtmlTable.Write(html, "key-points-table", "Key points in the order of cutting, mm", Columns(measured), report.KeyPoints, (row, p) =>
        {
            row.Header(p.Point);
            row.Text(p.Feature);
            row.Number(ReportNumber.Plain(p.Theoretical.X));
            row.Number(ReportNumber.Plain(p.Theoretical.Y));
            row.Number(ReportNumber.Plain(p.Actual.X));
            row.Number(ReportNumber.Plain(p.Actual.Y));
            if (measured)
            {
                row.Number(p.Counterpart is { } c ? ReportNumber.Plain(c.X) : ReportNumber.None);
                row.Number(p.Counterpart is { } d ? ReportNumber.Plain(d.Y) : ReportNumber.None);
            }

            row.Number(ReportNumber.Signed(p.Deviation.X));
            row.Number(ReportNumber.Signed(p.Deviation.Y));
            row.Number(ReportNumber.Signed(p.NormalMm));
            row.Number(ReportNumber.Signed(p.Correction.X));
            row.Number(ReportNumber.Signed(p.Correction.Y));
            row.Number(ReportNumber.Signed(p.UncompensatedMm));
            row.Number((outside.Contains(p.Point) ? "⚠ " : "") + ReportNumber.Signed(p.PredictedMm));
            row.Code(string.Join(' ', p.Blocks));
        });
        html.Put(
            "p",
            "Deviation: theoretical - actual. Normal deviation: actual - theoretical, along the normal from the counterpart's material "
                + "to its tool. Correction: what is added to the program, in the program's frame. Mating error: counterpart - part along "
                + "the normal, positive overlaps, negative leaves a gap; after: as predicted from the program that was written; ⚠ marks "
                + "one that is outside its limits.",
            ("class", "small"));
    }

    private static List<TableColumn> Columns(bool measured)
    {
        var columns = new List<TableColumn>
        {
            new("Point"),
            new("Feature"),
            new("X", true, "Theoretical"),
            new("Y", true, "Theoretical"),
            new("X", true, "Actual part"),
            new("Y", true, "Actual part")
        };
        if (measured)
        {
            columns.AddRange([new("X", true, "Counterpart"), new("Y", true, "Counterpart")]);
        }

        columns.AddRange([
            new("X", true, "Deviation"), new("Y", true, "Deviation"), new("Normal deviation", true), new("X", true, "Correction"),
            new("Y", true, "Correction"),
            new("before", true, "Mating error"), new("after", true, "Mating error"), new("Blocks")]);
        return columns;
    }
}
