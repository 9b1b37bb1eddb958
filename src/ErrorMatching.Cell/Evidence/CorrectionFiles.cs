using System.Globalization;

namespace ErrorMatching.Cell;

/// <summary>The stored files of a correction, for export: measurement, job, programs and report, as written by <c>cell show --out</c> and
/// the station's export.</summary>
public static class CorrectionFiles
{
    /// <summary>The files: names without folders, and the contents by their SHA-256. Files that a correction lacks are omitted.</summary>
    /// <remarks>Names from a gauge or a machine cannot lead out of the folder; the number prefix keeps two corrections apart.</remarks>
    public static IReadOnlyList<(string Name, string Sha256)> Of(Correction correction)
    {
        ArgumentNullException.ThrowIfNull(correction);
        var number = correction.Id.ToString(CultureInfo.InvariantCulture);
        var program = correction.Program ?? "program.nc";
        return [.. new (string Name, string? Sha256)[]
        {
            (
                $"{number}-measurement-{Plain(correction.FileName)}",
                correction.Code == RecognitionResult.TooLarge ? null : correction.MeasurementSha256),
            ($"{number}-job.json", correction.JobSha256),
            ($"{number}-base-{program}", correction.BaseSha256),
            ($"{number}-previous-{program}", correction.PreviousSha256),
            ($"{number}-report.json", correction.ReportSha256),
            ($"{number}-report.html", correction.PageSha256),
            ($"{number}-{program}", correction.ProgramSha256),
        }.Where(f => f.Sha256 is not null).Select(f => (f.Name, f.Sha256!))];
    }

    private static string Plain(string name) =>
        string.Concat(name.Select(c => char.IsAsciiLetterOrDigit(c) || c is '.' or '-' or '_' ? c : '_'));
}
