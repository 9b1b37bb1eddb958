using ErrorMatching.Json;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Cell;

/// <summary>Determines which job a file belongs to and which piece it measures. Time grows with the file's length, regardless of content.
/// Thread-safe.</summary>
internal sealed class Recognizer
{
    private const int MostShown = 100;
    private readonly CellSettings _settings;
    private readonly IReadOnlyList<JobPatterns> _patterns;

    /// <summary>Creates a recognizer for the jobs of a cell.</summary>
    public Recognizer(CellSettings settings)
    {
        ArgumentNullException.ThrowIfNull(settings);
        (_settings, _patterns) = (settings, [.. settings.Jobs.Select(j => new JobPatterns(j))]);
    }

    /// <summary>Recognizes a file.</summary>
    /// <param name="gauge">The gauge that it came from.</param>
    /// <param name="fileName">Its name.</param>
    /// <param name="bytes">Its content.</param>
    public RecognitionResult Recognize(string gauge, string fileName, ReadOnlyMemory<byte> bytes)
    {
        ArgumentNullException.ThrowIfNull(fileName);
        var source = _settings.Gauges.FirstOrDefault(g => g.Name == gauge);
        var content = new LookInside(fileName, bytes, source?.Format);
        try
        {
            var takers = _patterns
                .Where(p => p.Job.Gauges.Contains(gauge, StringComparer.Ordinal))
                .Select(p => (p.Job, Found: p.Match(content)))
                .Where(m => m.Found is not null)
                .ToArray();
            return takers switch
            {
                [] => RecognitionResult.Refused(
                    RecognitionResult.UnknownPiece, Recorded.UnknownPiece.With(Shown(fileName), gauge, Asked(gauge))),
                [var (job, found)] => Of(job, found!, fileName, bytes),
                _ => RecognitionResult.Refused(
                    RecognitionResult.AmbiguousPiece,
                    Recorded.AmbiguousPiece.With(Shown(fileName), string.Join(", ", takers.Select(t => $"\"{t.Job.Name}\"")))),
            };
        }
        catch (InputException e)
        {
            return RecognitionResult.Refused(e.Code, Recorded.UnreadableInside.With(Shown(fileName), e.Message));
        }
    }

    private static RecognitionResult Of(CellJobSettings job, FoundWords found, string fileName, ReadOnlyMemory<byte> bytes)
    {
        if (found.Contradiction is { } contradiction)
        {
            return RecognitionResult.Refused(
                RecognitionResult.ContradictoryPiece, Recorded.ContradictoryPiece.With(Shown(fileName), contradiction));
        }

        string piece;
        try
        {
            piece = job.Piece ?? Decide(job, fileName, bytes);
        }
        catch (Exception e) when (e is InputException or IOException or UnauthorizedAccessException)
        {
            return RecognitionResult.Refused(
                RecognitionResult.UnusableJob, Recorded.UnusableJob.With(job.File, Shown(fileName), e.Message));
        }

        return new() { Job = job, Piece = piece, Serial = found.Serial, WorkOrder = found.WorkOrder };
    }

    // The job reads the file itself, because its rules may need columns of its own format.
    private static string Decide(CellJobSettings job, string fileName, ReadOnlyMemory<byte> bytes) => NamedJob.Read(job.File).Mating switch
    {
        { Recognition: { } rules } mating =>
            rules.Decide(MeasurementReader.Read(bytes, fileName, mating.Gauge.Format)) == SourceSide.Part ? "part" : "counterpart",
        _ =>
            throw new InputException(new Refusal(
                "recognition-missing",
                "the job's rules of recognition are gone; expected the rules that were there when the cell started.",
                new() { File = job.File, Line = 1, Column = 1, Path = "$.recognition" })),
    };

    private string Asked(string gauge) =>
        _patterns.Where(p => p.Job.Gauges.Contains(gauge, StringComparer.Ordinal)).ToArray() is { Length: > 0 } asked
        ? string.Join("; ", asked.Select(p => Recorded.AskedWants.With(p.Job.Name, p)))
        : Recorded.AskedNobody.With();

    private static string Shown(string fileName) => fileName.Length <= MostShown ? fileName : fileName[..MostShown] + "...";
}
