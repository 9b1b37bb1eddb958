using ErrorMatching.Geometry;
using ErrorMatching.Jobs;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Console;

/// <summary>Translates the libraries' exceptions and refusals for the console's user.</summary>
internal static class FailureOf
{
    /// <summary>An input that cannot be read or used, with all that is wrong in it.</summary>
    public static Failure Input(InputException e) => new(ExitCode.WrongInput, e.Refusals);

    /// <summary>Readable inputs whose result must not be used.</summary>
    /// <param name="file">The file that is to blame where a reason names none.</param>
    /// <param name="refusals">The reasons.</param>
    public static Failure Refused(string file, params IReadOnlyList<Refusal> refusals) =>
        new(ExitCode.Refused, InputRefusals.In(file, refusals));

    /// <summary>A wish file that was written for another program.</summary>
    public static Failure OtherProgram(string wish, string before, string expected) => new(ExitCode.WrongInput, new Refusal(
        "wish-of-other-program",
        $"{wish} was not written for {before}: it names a program with the SHA-256 {expected}. Name the program that was displaced.",
        new() { File = wish, Path = "$.beforeSha256" }));

    /// <summary>A wish file that was written in another dialect.</summary>
    public static Failure OtherDialect(string wish, string dialect, string expected) => new(ExitCode.WrongInput, new Refusal(
        "wish-of-other-dialect",
        $"{wish} was written in the dialect {expected}, and {dialect} is another. Name the file of {expected} with --dialect.",
        new() { File = wish, Path = "$.dialect" }));

    /// <summary>Points in a file that determine no usable result.</summary>
    public static Failure Geometry(GeometryException e, string file) => Input(InputRefusals.Of(e, file));

    /// <summary>A result that differs from what was requested. Blocks and lines are those of the original.</summary>
    public static Failure NotProved(string before, string after, NcProof proof) =>
        new(ExitCode.Refused, [.. proof.Failures.Distinct().Select(r => r with
        {
            Message = $"{after}: {r.Message}",
            Place = r.Place with { File = r.Place.Line is null ? after : before },
        })]);

    /// <summary>A match that must not lead to a program.</summary>
    /// <param name="job">The job, named unless a block is the cause.</param>
    /// <param name="program">The program, named if a block is the cause.</param>
    /// <param name="refusals">The reasons.</param>
    public static Failure Refused(string job, string program, IReadOnlyList<Refusal> refusals) =>
        new(ExitCode.Refused, InputRefusals.Of(refusals, job, program));

    /// <summary>An output that cannot be written, or must not be.</summary>
    public static Failure Output(OutputException e) =>
        new(
            e.Code == OutputException.Unwritable ? ExitCode.Outside : ExitCode.WrongInput,
            new Refusal(e.Code, e.Message, new() { File = e.File }));

    /// <summary>A defect of the program, which its user can only report.</summary>
    public static Failure Defect(Exception e) => new(
        ExitCode.Outside,
        new Refusal("internal-error",
            $"This is a defect of errormatch: please report it with the input that shows it. {e.ToString().ReplaceLineEndings(" ")}"));
}
