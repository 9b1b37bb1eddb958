using ErrorMatching.Reporting;

namespace ErrorMatching.Freeform;

/// <summary>Writes tables in the style of tables 2, 3 and 4 of Lee 2019: standard deviation, mean and profile in micrometers.</summary>
internal static class SurfaceTables
{
    /// <summary>Writes a table of statistics, one per row.</summary>
    public static void WriteStatistics(
        HtmlText html, string id, string caption, IEnumerable<(string Name, DeviationStatistics Statistics)> rows) =>
        HtmlTable.Write(
            html,
            id,
            caption,
            [
                new("What"),
                new("Points", true),
                new("Mean, µm", true),
                new("Standard deviation, µm", true),
                new("Profile, ISO 1101, µm", true),
                new("Largest − smallest, µm", true)],
            rows,
            (row, item) =>
        {
            row.Header(item.Name);
            row.Number(ReportNumber.Count(item.Statistics.Count));
            row.Number(Micrometres.SignedOfMm(item.Statistics.MeanMm));
            row.Number(Micrometres.OfMm(item.Statistics.StandardDeviationMm));
            row.Number(Micrometres.OfMm(item.Statistics.ProfileIsoMm));
            row.Number(Micrometres.OfMm(item.Statistics.ProfileRangeMm));
        });

    /// <summary>Writes a table of the measured points.</summary>
    public static void WritePoints(HtmlText html, string id, string caption, IReadOnlyList<ErrorSample> samples) =>
        HtmlTable.Write(
            html,
            id,
            caption,
            [
                new("Point"), new("i", true), new("j", true), new("X, mm", true), new("Y, mm", true), new("Z, mm", true),
                new("Error, µm", true)],
            samples,
            (row, s) =>
        {
            row.Header(ReportNumber.Count(s.Point));
            row.Number(ReportNumber.Count(s.I));
            row.Number(ReportNumber.Count(s.J));
            row.Number(ReportNumber.Plain(s.Nominal.X));
            row.Number(ReportNumber.Plain(s.Nominal.Y));
            row.Number(ReportNumber.Plain(s.Nominal.Z));
            row.Number(Micrometres.SignedOfMm(s.ErrorMm));
        }, isLong: true);
}
