using System.Globalization;

namespace ErrorMatching.Cell;

/// <summary>What the store keeps of a correction, as files to hand out: measurement, job, programs and report, as <c>cell show --out</c> and the station's export write them.</summary>
public static class CorrectionFiles
{
    /// <summary>The files: names without folders, and the contents by their SHA-256. What a correction lacks is left out.</summary>
    /// <remarks>Names that come from a gauge or a machine lead nowhere else; the number in front keeps two corrections apart.</remarks>
    public static IReadOnlyList<(string Name, string Sha256)> Of(Correction correction)
    {
        ArgumentNullException.ThrowIfNull(correction);
        var number = correction.Id.ToString(CultureInfo.InvariantCulture);
        var program = correction.Program ?? "program.nc";
        return [.. new (string Name, string? Sha256)[]
        {
            ($"{number}-measurement-{Plain(correction.FileName)}", correction.Code == FileSource.TooLarge ? null : correction.MeasurementSha256),
            ($"{number}-job.json", correction.JobSha256),
            ($"{number}-base-{program}", correction.BaseSha256),
            ($"{number}-previous-{program}", correction.PreviousSha256),
            ($"{number}-report.json", correction.ReportSha256),
            ($"{number}-report.html", correction.PageSha256),
            ($"{number}-{program}", correction.ProgramSha256),
        }.Where(f => f.Sha256 is not null).Select(f => (f.Name, f.Sha256!))];
    }

    private static string Plain(string name) => string.Concat(name.Select(c => char.IsAsciiLetterOrDigit(c) || c is '.' or '-' or '_' ? c : '_'));
}
