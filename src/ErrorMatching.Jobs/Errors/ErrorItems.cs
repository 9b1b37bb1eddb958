using System.Globalization;
using ErrorMatching.Freeform;
using ErrorMatching.Geometry;
using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;

namespace ErrorMatching.Jobs;

/// <summary>Converts the libraries' exceptions and refusals to errors about the inputs.</summary>
public static class ErrorItems
{
    /// <summary>The errors of an input, by the exception that it caused.</summary>
    /// <returns>At least one item; null if the exception is not caused by an input, but by a defect or an external failure.</returns>
    public static IReadOnlyList<ErrorItem>? OfInput(Exception exception) => exception switch
    {
        MeasurementException e => [Of(e)],
        JobException e => Of(e),
        JsonDocumentException e => Of(e),
        FreeformException e => [Of(e)],
        PointsException e => [Of(e)],
        NcException e => [Of(e)],
        WrongPieceException e => [Of(e)],
        InputException e => [Of(e)],
        _ => null,
    };

    /// <summary>A measurement that cannot be used.</summary>
    public static ErrorItem Of(MeasurementException e) =>
        new(NotNull(e).Code, e.Message) { File = e.File, Line = e.Line, Column = e.Column, Path = e.Path, Problem = e.Problem };

    /// <summary>A job that cannot be used: all of its errors.</summary>
    public static IReadOnlyList<ErrorItem> Of(JobException e) => Document(NotNull(e).File, e.Problems);

    /// <summary>A JSON document other than a job that cannot be used: all of its errors.</summary>
    public static IReadOnlyList<ErrorItem> Of(JsonDocumentException e) => Document(NotNull(e).File, e.Problems);

    /// <summary>A surface, template or measurement of a free-form job that cannot be used.</summary>
    public static ErrorItem Of(FreeformException e) =>
        new(NotNull(e).Code, e.Message) { File = e.File, Line = e.Line, Column = e.Column, Problem = e.Problem };

    /// <summary>Points of a file without a usable solution.</summary>
    public static ErrorItem Of(PointsException e) => Of(NotNull(e).Why, e.File);

    /// <summary>Points of a file without a usable solution.</summary>
    /// <param name="e">The geometry error.</param>
    /// <param name="file">The file as the user named it.</param>
    public static ErrorItem Of(GeometryException e, string file) =>
        new(CodeOf(NotNull(e).Error), $"{file}: {e.Message}") { File = file, Problem = e.Message };

    /// <summary>A program, selector or dialect that cannot be read at all.</summary>
    public static ErrorItem Of(NcException e) => new(CodeOf(NotNull(e).Code), e.Message);

    /// <summary>A measurement of the other piece.</summary>
    public static ErrorItem Of(WrongPieceException e) => new("wrong-piece", NotNull(e).Message) { File = e.File, Problem = e.Problem };

    /// <summary>An input that cannot be opened. If a job names it, the job is the file to correct.</summary>
    public static ErrorItem Of(InputException e) => NotNull(e).NamedAt is { } at
        ? At(at, MeasurementError.FileUnreadable, e.Message)
        : new(MeasurementError.FileUnreadable, e.Message) { File = e.File };

    /// <summary>An output that cannot be written, or must not be.</summary>
    public static ErrorItem Of(OutputException e) => new(NotNull(e).Code, e.Message) { File = e.File };

    /// <summary>A free-form job whose result must not be used.</summary>
    /// <param name="refusals">The reasons.</param>
    /// <param name="job">The job's file.</param>
    public static IReadOnlyList<ErrorItem> Of(IEnumerable<FreeformRefusal> refusals, string job) =>
        [.. refusals.Select(r => new ErrorItem(r.Code, r.Message) { File = job, Problem = r.Message })];

    /// <summary>A readable program or wish that must not be used.</summary>
    /// <param name="refusals">The reasons.</param>
    /// <param name="file">The program or wish.</param>
    public static IReadOnlyList<ErrorItem> Of(IEnumerable<NcRefusal> refusals, string file) =>
        [.. refusals.Select(r => new ErrorItem(r.Code, $"{file}: {r.Message}")
    {
        File = file,
        Line = r.Line > 0 ? r.Line : null,
        Block = r.Block.Length > 0 ? r.Block : null,
        Problem = WithoutLine(r.Message, r.Line),
    })];

    /// <summary>A match that must not lead to a program.</summary>
    /// <param name="refusals">The reasons.</param>
    /// <param name="job">The job, if no block is to blame.</param>
    /// <param name="program">The program, if a block is to blame.</param>
    public static IReadOnlyList<ErrorItem> Of(IEnumerable<MatingRefusal> refusals, string job, string program) =>
        [.. refusals.Select(r => Of(r, job, program))];

    /// <summary>An error about a file that another file names.</summary>
    /// <param name="at">Where it is named.</param>
    /// <param name="code">A stable code.</param>
    /// <param name="problem">What was found and what is expected, as a sentence.</param>
    internal static ErrorItem At(NamedPlace at, string code, string problem) =>
        new(code, Placed(at.File, at.Place, at.Path, problem))
        {
            File = at.File,
            Line = at.Place.Line,
            Column = at.Place.Column,
            Path = at.Path,
            Problem = problem
        };

    private static ErrorItem Of(MatingRefusal refusal, string job, string program) => refusal is { Path: { } path, Place: { } place }
        ? At(new(job, path, place), refusal.Code, refusal.Message)
        : new(refusal.Code, refusal.Message)
        {
            File = refusal.Line > 0 || refusal.Block is not null ? program : job,
            Line = refusal.Line > 0 ? refusal.Line : null,
            Block = refusal.Block,
            Problem = WithoutLine(refusal.Message, refusal.Line),
        };

    private static T NotNull<T>(T value) => value ?? throw new ArgumentNullException(nameof(value));

    private static IReadOnlyList<ErrorItem> Document(string file, IReadOnlyList<JsonProblem> problems) =>
        [.. problems.Select(p => new ErrorItem(p.Code, Placed(file, p.Place, p.Path, Sentence(p.Message)))
    {
        File = file,
        Line = p.Line,
        Column = p.Column,
        Path = p.Path,
        Problem = Sentence(p.Message),
    })];

    // A block without a number is named by its line, which the problem's prefix already contains.
    private static string WithoutLine(string message, int line) =>
        string.Create(CultureInfo.InvariantCulture, $"line {line}: ") is var name && message.StartsWith(name, StringComparison.Ordinal)
            ? message[name.Length..]
            : message;

    private static string Placed(string file, JsonPlace place, string path, string problem) =>
        string.Create(CultureInfo.InvariantCulture, $"{file}, line {place.Line}, column {place.Column}, {path}: {problem}");

    private static string Sentence(string problem) => problem.EndsWith('?') ? problem : problem.TrimEnd('.') + ".";

    private static string CodeOf(GeometryError error) => error switch
    {
        GeometryError.TooFewPoints => "too-few-points",
        GeometryError.CoincidentPoints => "coincident-points",
        GeometryError.CollinearPoints => "collinear-points",
        GeometryError.NearParallel => "near-parallel",
        GeometryError.RankDeficient => "rank-deficient",
        GeometryError.NotConverged => "not-converged",
        GeometryError.NotFinite => "not-finite",
        GeometryError.FoldedCurve => "folded-curve",
        GeometryError.NotAround => "not-around",
        GeometryError.BadKnots => "bad-knots",
        GeometryError.BadPoles => "bad-poles",
        GeometryError.OpenMesh => "open-mesh",
        _ => throw new ArgumentOutOfRangeException(nameof(error), error, "A geometric error without a code."),
    };

    private static string CodeOf(NcErrorCode code) => code switch
    {
        NcErrorCode.NumberTooLong => "number-too-long",
        NcErrorCode.BadSelector => "bad-selector",
        NcErrorCode.UnknownDialect => "unknown-dialect",
        NcErrorCode.ProgramTooLarge => "program-too-large",
        _ => throw new ArgumentOutOfRangeException(nameof(code), code, "An error of a program without a code."),
    };
}
