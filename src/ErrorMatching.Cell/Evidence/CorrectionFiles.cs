using System.Globalization;
using ErrorMatching.Reporting;

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
            ($"{number}-undo-{program}", correction.UndoSha256),
            ($"{number}-report.json", correction.ReportSha256),
            ($"{number}-report.html", correction.PageSha256),
            ($"{number}-{program}", correction.ProgramSha256),
        }.Where(f => f.Sha256 is not null).Select(f => (f.Name, f.Sha256!))];
    }

    /// <summary>Reads the files from a store.</summary>
    /// <remarks>A page that this version of the program draws differently from the recorded one gets a name of its own and a
    /// notice.</remarks>
    /// <exception cref="StoreException">A content is missing or damaged.</exception>
    public static IReadOnlyList<CorrectionFile> Read(CellStore store, Correction correction)
    {
        ArgumentNullException.ThrowIfNull(store);
        return [.. Of(correction).Select(f => Read(store, correction, f.Name, f.Sha256))];
    }

    private static CorrectionFile Read(CellStore store, Correction correction, string name, string sha256)
    {
        try
        {
            return new(name, store.Content(sha256), null);
        }
        catch (StoreException e) when (e.Error == StoreError.Redrawn
            && ReportPages.Of(store.Content(correction.ReportSha256!)) is { } page)
        {
            return new(name.Replace("-report.html", "-report-redrawn.html", StringComparison.Ordinal), page, e.Statement);
        }
    }

    private static string Plain(string name) =>
        string.Concat(name.Select(c => char.IsAsciiLetterOrDigit(c) || c is '.' or '-' or '_' ? c : '_'));
}

/// <summary>A stored file of a correction.</summary>
/// <param name="Name">Its name, without folders.</param>
/// <param name="Bytes">Its content.</param>
/// <param name="Notice">Why it is not the recorded one; null if it is.</param>
public sealed record CorrectionFile(string Name, ReadOnlyMemory<byte> Bytes, Statement? Notice);
