using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The sections with features and key points of a verification.</summary>
internal static class VerifyTables
{
    private static readonly TableColumn[] FeatureColumns =
        [
            new("Feature"), new("Quantity"), new("Unit"), new("Wanted", true), new("Before", true), new("After", true),
            new("before", true, "Error"), new("after", true, "Error"), new("Improvement, %", true)];

    private static readonly TableColumn[] PointColumns =
        [
            new("Point"), new("X", true, "Part"), new("Y", true, "Part"), new("X", true, "Before - part"), new("Y", true, "Before - part"),
            new("along normal", true, "Before - part"), new("X", true, "After - part"), new("Y", true, "After - part"),
            new("along normal", true, "After - part")];

    public static void WriteFeatures(HtmlText html, VerifyReport report)
    {
        var (result, isKnown) = (report.Result, report.IsBeforeMeasured);
        HtmlTable.Write(
            html,
            "features-table",
            "Quantities of the counterpart: wanted, without compensation, with it",
            FeatureColumns,
            result.Features,
            (row, f) =>
        {
            row.Header(f.Name);
            row.Text(f.Quantity.Words);
            row.Text(f.Quantity.Unit);
            row.Number(ReportNumber.Plain(f.Wanted));
            row.Number(ReportNumber.Plain(f.Before));
            row.Number(ReportNumber.Plain(f.After));
            row.Number(ReportNumber.Signed(f.Before - f.Wanted));
            row.Number(ReportNumber.Signed(f.After - f.Wanted));
            row.Number(isKnown ? ImprovementWords.Of(f, ReportNumber.Percent, ReportNumber.None) : ReportNumber.None);
        });
        html.Put(
            "p",
            "Error: found - wanted. Improvement: by how much of the error before the error after is smaller; negative where it grew. "
                + (isKnown
                    ? string.Join(' ', ImprovementWords.Legend(result.Features))
                    : "Before is the counterpart as designed, so it is not known."),
            ("class", "small"));
    }

    public static void WritePoints(HtmlText html, VerificationResult result)
    {
        HtmlTable.Write(html, "points-table", "Key points in the order of cutting, mm", PointColumns, result.Points, (row, p) =>
        {
            row.Header(p.Label);
            row.Number(ReportNumber.Plain(p.Part.X));
            row.Number(ReportNumber.Plain(p.Part.Y));
            WriteError(row, p.BeforeError);
            WriteError(row, p.AfterError);
        });
        html.Put(
            "p",
            "Counterpart - part, as measured. Along the normal from the counterpart's material to its tool: positive overlaps, negative "
                + "leaves a gap.",
            ("class", "small"));
    }

    private static void WriteError(TableRow row, MatingError error)
    {
        row.Number(ReportNumber.Signed(error.Vector.X));
        row.Number(ReportNumber.Signed(error.Vector.Y));
        row.Number(ReportNumber.Signed(error.NormalMm));
    }
}
