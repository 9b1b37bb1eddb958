using ErrorMatching.Geometry;
using ErrorMatching.Measurement;

namespace ErrorMatching.Console;

/// <summary>What each exception of the libraries means to the user of the console.</summary>
internal static class FailureOf
{
    /// <summary>A measurement that cannot be used.</summary>
    public static Failure Measurement(MeasurementException e) => new(ExitCode.WrongInput, new ErrorItem(e.Code, e.Message)
    {
        File = e.File,
        Line = e.Line,
        Column = e.Column,
        Path = e.Path,
        Problem = e.Problem,
    });

    /// <summary>Points of a file without a usable answer.</summary>
    public static Failure Geometry(GeometryException e, string file) => new(ExitCode.WrongInput, new ErrorItem(CodeOf(e.Error), $"{file}: {e.Message}") { File = file, Problem = e.Message });

    /// <summary>An output that cannot be written, or must not be.</summary>
    public static Failure Output(OutputException e) =>
        new(e.IsInput ? ExitCode.WrongInput : ExitCode.Outside, new ErrorItem(e.IsInput ? "output-is-input" : "file-unwritable", e.Message) { File = e.File });

    /// <summary>A defect of the program, which its user can only report.</summary>
    public static Failure Defect(Exception e) => new(ExitCode.Outside, new ErrorItem("internal-error", $"This is a defect of errormatch: please report it with the input that shows it. {e}"));

    private static string CodeOf(GeometryError error) => error switch
    {
        GeometryError.TooFewPoints => "too-few-points",
        GeometryError.CoincidentPoints => "coincident-points",
        GeometryError.CollinearPoints => "collinear-points",
        GeometryError.NearParallel => "near-parallel",
        GeometryError.RankDeficient => "rank-deficient",
        GeometryError.NotConverged => "not-converged",
        GeometryError.NotFinite => "not-finite",
        _ => throw new ArgumentOutOfRangeException(nameof(error), error, "A geometric error without a code."),
    };
}
