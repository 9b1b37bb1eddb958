using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The section with the key points. Every deviation is actual - nominal.</summary>
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

            row.Number(ReportNumber.Signed(-p.Deviation.X));
            row.Number(ReportNumber.Signed(-p.Deviation.Y));
            row.Number(ReportNumber.Signed(p.NormalMm));
            row.Number(ReportNumber.Signed(p.Correction.X));
            row.Number(ReportNumber.Signed(p.Correction.Y));
            row.Number(ReportNumber.Signed(p.UncompensatedMm));
            row.Number((outside.Contains(p.Point) ? "⚠ " : "") + Left(p));
            row.Code(string.Join(' ', p.Blocks));
        });
        html.Put(
            "p",
            "Deviation: actual - theoretical; along the normal from the counterpart's material to its tool, positive where the counterpart "
                + "needs more material. Correction: what is added to the program, in the program's frame. Mating error: counterpart - part "
                + "along the normal, positive where too much material stands (overlap), negative where it lacks (gap); after: as predicted "
                + "from the program that was written, with its 95 % interval; ⚠ marks one that is outside its limits.",
            ("class", "small"));
    }

    /// <summary>The mating error left at a key point, with its interval if it is known.</summary>
    internal static string Left(ReportKeyPoint point) => point.Interval95Mm is { } half
        ? ReportNumber.Interval(point.PredictedMm, half)
        : ReportNumber.Signed(point.PredictedMm);

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
            new("X", true, "Deviation"), new("Y", true, "Deviation"), new("along normal", true, "Deviation"), new("X", true, "Correction"),
            new("Y", true, "Correction"),
            new("before", true, "Mating error"), new("after", true, "Mating error"), new("Blocks")]);
        return columns;
    }
}
