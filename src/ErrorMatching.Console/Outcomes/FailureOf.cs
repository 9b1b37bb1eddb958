using ErrorMatching.Freeform;
using ErrorMatching.Geometry;
using ErrorMatching.Jobs;
using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;

namespace ErrorMatching.Console;

/// <summary>Translates the libraries' exceptions and refusals for the console's user.</summary>
internal static class FailureOf
{
    /// <summary>A measurement that cannot be used.</summary>
    public static Failure Measurement(MeasurementException e) => new(ExitCode.WrongInput, ErrorItems.Of(e));

    /// <summary>A job that cannot be used, with all its errors.</summary>
    public static Failure Job(JobException e) => new(ExitCode.WrongInput, ErrorItems.Of(e));

    /// <summary>A JSON document other than a job that cannot be used, with all its errors.</summary>
    public static Failure Json(JsonDocumentException e) => new(ExitCode.WrongInput, ErrorItems.Of(e));

    /// <summary>A surface, template or measurement of a free-form job that cannot be used.</summary>
    public static Failure Freeform(FreeformException e) => new(ExitCode.WrongInput, ErrorItems.Of(e));

    /// <summary>A free-form job whose result must not be used.</summary>
    public static Failure Refused(string job, IReadOnlyList<FreeformRefusal> refusals) =>
        new(ExitCode.Refused, ErrorItems.Of(refusals, job));

    /// <summary>A wish file that was written for another program.</summary>
    public static Failure OtherProgram(string wish, string before, string expected) => new(ExitCode.WrongInput, new ErrorItem(
        "wish-of-other-program",
        $"{wish} was not written for {before}: it names a program with the SHA-256 {expected}. Name the program that was displaced.")
    {
        File = wish,
        Path = "$.beforeSha256",
    });

    /// <summary>A wish file that was written in another dialect.</summary>
    public static Failure OtherDialect(string wish, string dialect, string expected) => new(ExitCode.WrongInput, new ErrorItem(
        "wish-of-other-dialect",
        $"{wish} was written in the dialect {expected}, and {dialect} is another. Name the file of {expected} with --dialect.")
    {
        File = wish,
        Path = "$.dialect",
    });

    /// <summary>Points in a file that determine no usable result.</summary>
    public static Failure Geometry(GeometryException e, string file) => new(ExitCode.WrongInput, ErrorItems.Of(e, file));

    /// <summary>A program, selector or dialect that cannot be read at all.</summary>
    public static Failure Nc(NcException e) => new(ExitCode.WrongInput, ErrorItems.Of(e));

    /// <summary>A program or wish file that can be read but must not be used.</summary>
    public static Failure Refused(string file, params IReadOnlyList<NcRefusal> refusals) =>
        new(ExitCode.Refused, ErrorItems.Of(refusals, file));

    /// <summary>A result that differs from what was requested. Blocks and lines are those of the original.</summary>
    public static Failure NotProved(string before, string after, NcProof proof) =>
        new(ExitCode.Refused, [.. proof.Failures.Distinct().Select(r => new ErrorItem(r.Code, $"{after}: {r.Message}")
    {
        File = r.Line > 0 ? before : after,
        Line = r.Line > 0 ? r.Line : null,
        Block = r.Block.Length > 0 ? r.Block : null,
        Problem = $"{after}: {r.Message}",
    })]);

    /// <summary>A match that must not lead to a program.</summary>
    /// <param name="job">The job, named unless a block is the cause.</param>
    /// <param name="program">The program, named if a block is the cause.</param>
    /// <param name="refusals">The reasons.</param>
    public static Failure Refused(string job, string program, IReadOnlyList<MatingRefusal> refusals) =>
        new(ExitCode.Refused, ErrorItems.Of(refusals, job, program));

    /// <summary>A measurement of the wrong piece.</summary>
    public static Failure WrongPiece(WrongPieceException e) => new(ExitCode.WrongInput, ErrorItems.Of(e));

    /// <summary>An input that cannot be opened.</summary>
    public static Failure Input(InputException e) => new(ExitCode.WrongInput, ErrorItems.Of(e));

    /// <summary>An output that cannot be written, or must not be.</summary>
    public static Failure Output(OutputException e) =>
        new(e.Code == OutputException.Unwritable ? ExitCode.Outside : ExitCode.WrongInput, ErrorItems.Of(e));

    /// <summary>Measured points that determine no result.</summary>
    public static Failure Points(PointsException e) => new(ExitCode.WrongInput, ErrorItems.Of(e));

    /// <summary>A defect of the program, which its user can only report.</summary>
    public static Failure Defect(Exception e) => new(
        ExitCode.Outside,
        new ErrorItem("internal-error", $"This is a defect of errormatch: please report it with the input that shows it. {e}"));
}
