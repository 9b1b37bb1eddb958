using System.Text.RegularExpressions;
using ErrorMatching.Json;
using ErrorMatching.Measurement;

namespace ErrorMatching.Cell;

/// <summary>Tells which job a file belongs to, and which piece it measures. Its time grows with the file's length, whatever the file holds. Safe for use by several threads.</summary>
public sealed class Recognizer
{
    private const int MostShown = 100;
    private readonly CellSettings _settings;
    private readonly IReadOnlyList<JobPatterns> _patterns;

    /// <summary>A recognizer for the jobs of a cell.</summary>
    public Recognizer(CellSettings settings)
    {
        ArgumentNullException.ThrowIfNull(settings);
        (_settings, _patterns) = (settings, [.. settings.Jobs.Select(j => new JobPatterns(j))]);
    }

    /// <summary>Whose measurement a file is.</summary>
    /// <param name="gauge">The gauge that it came from.</param>
    /// <param name="fileName">Its name.</param>
    /// <param name="bytes">Its content.</param>
    public Recognition Recognize(string gauge, string fileName, ReadOnlyMemory<byte> bytes)
    {
        ArgumentNullException.ThrowIfNull(fileName);
        var source = _settings.Gauges.FirstOrDefault(g => g.Name == gauge);
        var content = new LookInside(fileName, bytes, source?.Format);
        try
        {
            var takers = _patterns.Where(p => p.Job.Gauges.Contains(gauge, StringComparer.Ordinal)).Select(p => (p.Job, Found: p.Match(content))).Where(m => m.Found is not null).ToArray();
            return takers switch
            {
                [] => Recognition.Refused(Recognition.UnknownPiece, $"No job takes {Shown(fileName)} from \"{gauge}\": {Asked(gauge)}."),
                [var (job, found)] => Of(job, found!, fileName, bytes),
                _ => Recognition.Refused(Recognition.AmbiguousPiece, $"Several jobs take {Shown(fileName)}: {string.Join(", ", takers.Select(t => $"\"{t.Job.Name}\""))}. Make their patterns narrower."),
            };
        }
        catch (MeasurementException e)
        {
            return Recognition.Refused(e.Code, $"The patterns of the jobs must look into {Shown(fileName)}, which cannot be read: {e.Message}");
        }
        catch (RegexMatchTimeoutException e)
        {
            return Recognition.Refused(MeasurementError.BadPattern, $"A pattern takes too long on {Shown(fileName)}: {e.Pattern}. Make it simpler.");
        }
    }

    private static Recognition Of(CellJobSettings job, FoundWords found, string fileName, ReadOnlyMemory<byte> bytes)
    {
        if (found.Contradiction is { } contradiction)
        {
            return Recognition.Refused(Recognition.ContradictoryPiece, $"{Shown(fileName)} says two things about its piece: {contradiction}.");
        }

        string piece;
        try
        {
            piece = job.Piece ?? Decide(job, fileName, bytes);
        }
        catch (Exception e) when (e is JsonDocumentException or IOException or UnauthorizedAccessException)
        {
            return Recognition.Refused(Recognition.UnusableJob, $"The job {job.File} cannot be used any more, so nobody can tell whose measurement {Shown(fileName)} is: {e.Message}");
        }

        return new() { Job = job, Piece = piece, Serial = found.Serial, WorkOrder = found.WorkOrder };
    }

    // The file is read as the job reads it, for the job's rules may ask for columns of its own format.
    private static string Decide(CellJobSettings job, string fileName, ReadOnlyMemory<byte> bytes) => NamedJob.Read(job.File).Mating switch
    {
        { Recognition: { } rules } mating => rules.Decide(MeasurementReader.Read(bytes, fileName, mating.Gauge.Format)) == SourceSide.Part ? "part" : "counterpart",
        _ => throw new JsonDocumentException(job.File, [new("recognition-missing", "$.recognition", new(1, 1), "no rules", "the rules that were there when the cell started", "the job's rules of recognition are gone")]),
    };

    private string Asked(string gauge) => _patterns.Where(p => p.Job.Gauges.Contains(gauge, StringComparer.Ordinal)).ToArray() is { Length: > 0 } asked
        ? string.Join("; ", asked.Select(p => $"\"{p.Job.Name}\" wants {p}"))
        : "no job listens to this gauge";

    private static string Shown(string fileName) => $"\"{(fileName.Length <= MostShown ? fileName : fileName[..MostShown] + "...")}\"";
}
