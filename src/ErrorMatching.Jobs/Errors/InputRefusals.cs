using ErrorMatching.Geometry;
using ErrorMatching.Json;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>Says which file of the user a refusal of the libraries concerns.</summary>
public static class InputRefusals
{
    private const string WrongPieceCode = "wrong-piece";

    /// <summary>Points of a file without a usable solution, such as a line through coincident points.</summary>
    /// <param name="e">The geometry error.</param>
    /// <param name="file">The file as the user named it.</param>
    public static InputException Of(GeometryException e, string file) => new(
        new Refusal(CodeOf((e ?? throw new ArgumentNullException(nameof(e))).Error), e.Message, new() { File = file }), e);

    /// <summary>A measurement of the other piece.</summary>
    /// <param name="file">The file as the user or the job named it.</param>
    /// <param name="expected">The piece whose measurement is expected.</param>
    /// <param name="by">What says so.</param>
    public static InputException WrongPiece(string file, SourceSide expected, string by = "the job's rules of recognition")
    {
        var (found, wanted) = expected == SourceSide.Part ? ("counterpart", "part") : ("part", "counterpart");
        return new(Refusal.Of(
            WrongPieceCode,
            $"a measurement of the {found} by {by}",
            $"one of the {wanted}",
            new() { File = file }));
    }

    /// <summary>A measurement of the other piece, because its content is that of the other piece's file.</summary>
    /// <param name="file">The file as the user or the job named it.</param>
    /// <param name="expected">The piece whose measurement is expected.</param>
    /// <param name="other">The file with the same content.</param>
    public static InputException SameContent(string file, SourceSide expected, string other)
    {
        var (found, wanted) = expected == SourceSide.Part ? ("counterpart", "part") : ("part", "counterpart");
        return new(Refusal.Of(
            WrongPieceCode,
            $"the content of {other}, which is the measured {found}",
            $"a measurement of the {wanted}: name its file",
            new() { File = file, Line = 1, Column = 1 }));
    }

    /// <summary>Points that are where the counterpart's program has them, not where the part has them.</summary>
    /// <param name="file">The file as the user or the job named it.</param>
    public static InputException CounterpartFrame(string file) => new(Refusal.Of(
        WrongPieceCode,
        "points that are where the program of the counterpart has them, by the job's counterpart.frame",
        "the measured part in its own frame: name the part's file, or measure in the frame of the part",
        new() { File = file, Line = 1, Column = 1 }));

    /// <summary>One measurement where two are needed.</summary>
    /// <param name="file">The second file.</param>
    /// <param name="other">The file with the same content.</param>
    public static InputException SameMeasurement(string file, string other) => new(Refusal.Of(
        "same-measurement",
        $"the content of {other} again",
        "another measurement: name that of the counterpart that was cut with compensation",
        new() { File = file, Line = 1, Column = 1 }));

    /// <summary>A file that cannot be opened, reported where a job names it, because the job is the file to correct.</summary>
    /// <param name="job">The job's file.</param>
    /// <param name="path">JSON path of the name in the job.</param>
    /// <param name="place">Line and column of the name in the job.</param>
    /// <param name="cause">What is wrong with the file.</param>
    public static InputException NamedAt(string job, string path, JsonPlace place, InputException cause)
    {
        ArgumentNullException.ThrowIfNull(cause);
        return new(
            [
                .. cause.Refusals.Select(r => r with
                {
                    Message = r.Sentence,
                    Place = new() { File = job, Line = place.Line, Column = place.Column, Path = path },
                }),
            ],
            cause);
    }

    /// <summary>The refusals of a job: those about a block concern the program, the others the job.</summary>
    /// <param name="refusals">The reasons.</param>
    /// <param name="job">The job's file.</param>
    /// <param name="program">The program's file.</param>
    public static IReadOnlyList<Refusal> Of(IEnumerable<Refusal> refusals, string job, string program) =>
        [.. refusals.Select(r => r.In(r.Place is { Block: null, Line: null } or { Path: not null } ? job : program))];

    /// <summary>The refusals of one file.</summary>
    /// <param name="refusals">The reasons.</param>
    /// <param name="file">The file as the user named it.</param>
    public static IReadOnlyList<Refusal> In(string file, IEnumerable<Refusal> refusals) => [.. refusals.Select(r => r.In(file))];

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
}
