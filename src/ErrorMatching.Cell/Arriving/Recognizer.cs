using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

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

        MatingJob? rules;
        try
        {
            rules = job.Piece is null ? JobWithRules(job) : null;
        }
        catch (Exception e) when (e is InputException or IOException or UnauthorizedAccessException)
        {
            return RecognitionResult.Refused(
                RecognitionResult.UnusableJob, Recorded.UnusableJob.With(job.File, Shown(fileName), e.Message));
        }

        return new()
        {
            Job = job,
            Piece = rules is null ? job.Piece : Decide(rules, fileName, bytes),
            Serial = found.Serial,
            WorkOrder = found.WorkOrder,
        };
    }

    private static MatingJob JobWithRules(CellJobSettings job) => NamedJob.Read(job.File).Mating is { Recognition: not null } mating
        ? mating
        : throw new InputException(new Refusal(
            "recognition-missing",
            "the job's rules of recognition are gone; expected the rules that were there when the cell started.",
            new() { File = job.File, Line = 1, Column = 1, Path = "$.recognition" }));

    // The job reads the file itself, because its rules may need columns of its own format.
    private static string Decide(MatingJob job, string fileName, ReadOnlyMemory<byte> bytes) =>
        job.Recognition!.Decide(MeasurementReader.Read(bytes, fileName, job.Gauge.Format)) == SourceSide.Part
            ? PieceWords.Part
            : PieceWords.Counterpart;

    private Statement Asked(string gauge) =>
        _patterns.Where(p => p.Job.Gauges.Contains(gauge, StringComparer.Ordinal)).ToArray() is { Length: > 0 } asked
        ? Statement.InARow(asked.Select(p => Recorded.AskedWants.With(p.Job.Name, p.Like)))
        : Recorded.AskedNobody.With();

    private static string Shown(string fileName) => fileName.Length <= MostShown ? fileName : fileName[..MostShown] + "...";
}

/// <summary>Which job and piece a file belongs to, or why that cannot be decided.</summary>
public sealed record RecognitionResult
{
    /// <summary>Code of a file that no job takes.</summary>
    public const string UnknownPiece = "unknown-piece";

    /// <summary>Code of a file that several jobs take.</summary>
    public const string AmbiguousPiece = "ambiguous-piece";

    /// <summary>Code of a file whose patterns capture several serial numbers or work orders.</summary>
    public const string ContradictoryPiece = "contradictory-piece";

    /// <summary>Code of a file whose job can no longer be read.</summary>
    public const string UnusableJob = "unusable-job";

    /// <summary>Code of a file that exceeds the gauge's size limit.</summary>
    public const string TooLarge = "file-too-large";

    /// <summary>The job; null if the file is refused.</summary>
    public CellJobSettings? Job { get; init; }

    /// <summary><c>part</c>, <c>counterpart</c> or <c>surface</c>; null if the file is refused.</summary>
    public string? Piece { get; init; }

    /// <summary>Serial number of the piece; null if no pattern captures it.</summary>
    public string? Serial { get; init; }

    /// <summary>The work order; null if no pattern captures it.</summary>
    public string? WorkOrder { get; init; }

    /// <summary>Stable code for why the file is refused: one of the codes here, or the code of a measurement that cannot be read. Null if
    /// it is recognized.</summary>
    public string? Code { get; init; }

    /// <summary>The reason in a setter's terms; null if the file is recognized.</summary>
    public Statement? Reason { get; init; }

    internal static RecognitionResult Refused(string code, Statement reason) => new() { Code = code, Reason = reason };
}

/// <summary>A file whose content is read at most once, and only if a pattern needs it.</summary>
/// <param name="name">Its name.</param>
/// <param name="bytes">Its content.</param>
/// <param name="format">Its format; null for a probing log.</param>
internal sealed class LookInside(string name, ReadOnlyMemory<byte> bytes, MeasurementFormat? format)
{
    private MeasurementFile? _table;
    private IReadOnlyList<HeaderField>? _fields;

    public string Name => name;

    /// <summary>The values of a header field; none if the file does not have it.</summary>
    /// <exception cref="InputException">The file cannot be read.</exception>
    public IReadOnlyList<string> HeaderField(string field)
    {
        _fields ??= format is null ? ProbingLogHeader.Read(bytes.Span) : Table().HeaderFields;
        return [.. _fields.Where(f => string.Equals(f.Name, field, StringComparison.OrdinalIgnoreCase)).Select(f => f.Value)];
    }

    /// <summary>The values of a column; none if the file does not have it.</summary>
    /// <exception cref="InputException">The file cannot be read.</exception>
    public IReadOnlyList<string> Column(string column) => format is null ? [] : Table().ColumnTexts(column) ?? [];

    private MeasurementFile Table() => _table ??= MeasurementReader.Read(bytes, name, format!);
}
