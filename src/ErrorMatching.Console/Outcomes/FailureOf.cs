using ErrorMatching.Geometry;
using ErrorMatching.Jobs;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

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

    /// <summary>A program that is withheld because of its verdict; null if it is not.</summary>
    /// <param name="acceptance">What became of it.</param>
    /// <param name="verdict">The verdict in a sentence.</param>
    /// <param name="job">The job.</param>
    /// <param name="targets">The files that are not written. Some may be there from an earlier run.</param>
    /// <param name="inputs">The files that were read, which are no results of an earlier run.</param>
    public static Failure? NotToCut(
        Acceptance acceptance, string verdict, string job, IEnumerable<string> targets, IEnumerable<string> inputs)
    {
        string[] read = [.. inputs.Select(Path.GetFullPath)];
        return !acceptance.IsWithheld ? null : new(ExitCode.Refused, [
            new Refusal("not-to-cut", $"{verdict} {acceptance.Sentence}", new() { File = job }),
            .. targets.Where(t => File.Exists(t) && !read.Contains(Path.GetFullPath(t))).Select(t => new Refusal(
                "earlier-result",
                "was there before this run and stays as it is: it is not the result of this run.",
                new() { File = t }))]);
    }

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
