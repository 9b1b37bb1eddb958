using System.CommandLine;
using ErrorMatching.Geometry;
using ErrorMatching.Jobs;
using ErrorMatching.Mating;
using ErrorMatching.Refusals;

namespace ErrorMatching.Console;

/// <summary><c>errormatch verify</c>.</summary>
internal sealed class VerifyVerb : Verb
{
    private readonly Argument<string> _job = new("JOB") { Description = "The job." };
    private readonly Option<string> _before = FileOption(
        "--before",
        "The measured counterpart that was cut without compensation. Without this option, before is the counterpart as designed.");

    private readonly Option<string> _after = FileOption("--after", "The measured counterpart that was cut with compensation.");
    private readonly Option<string> _part = FileOption("--part", "The measured part, instead of the job's.");
    private readonly Option<bool> _require = new("--require-in-tolerance")
    {
        Description = "Exit with 2 unless the counterpart after compensation is in tolerance. What --out asks for is written all the "
            + "same: it says why.",
    };
    private readonly Option<string> _out = new("--out")
    {
        Description = "The folder to write verify.json, verify.html, verify.qif and verify.dfq to. Without it nothing is written.",
        HelpName = "DIR"
    };

    public VerifyVerb()
        : base(
            "verify",
            "Compares a counterpart, and the one that was cut without compensation, with the part.",
            "errormatch verify samples/complex-mating/job.json --before samples/complex-mating/counterpart.csv --after "
                + "samples/complex-mating/counterpart-after.csv")
    {
        _after.Required = true;
        Arguments.Add(_job);
        Options.Add(_before);
        Options.Add(_after);
        Options.Add(_part);
        Options.Add(_require);
        Options.Add(_out);
    }

    public override VerbResult Run(ParseResult arguments, CancellationToken cancellation)
    {
        var files = new JobFiles(arguments.GetRequiredValue(_job));
        var isRequired = arguments.GetValue(_require);
        if (isRequired && files.Job.Features.All(f => f.Tolerance.Band.WidthMm == 0))
        {
            return new Failure(ExitCode.WrongInput, new Refusal(
                "tolerance-missing",
                $"{files.Job.File} states no \"toleranceMm\" with a width, which --require-in-tolerance compares with. Enter the limits of "
                    + "a feature, in mm.",
                new() { File = files.Job.File, Path = "$.features" }));
        }

        var theoretical = files.Theoretical();
        var part = files.Part(GivenMeasurement(arguments.GetValue(_part)), theoretical);
        files.CheckFrame(theoretical, part);
        var (before, after) = (
            arguments.GetValue(_before) is { } given ? files.Counterpart(GivenMeasurement(given), part, theoretical) : null,
            files.Counterpart(GivenMeasurement(arguments.GetRequiredValue(_after)), part, theoretical));
        if (before is not null && before.Sha256 == after.Sha256)
        {
            throw InputRefusals.SameMeasurement(after.File, before.File);
        }

        var (program, bytes) = files.Program(null);
        var dialect = files.OwnDialect();
        cancellation.ThrowIfCancellationRequested();
        try
        {
            if (VerifyRun.Report(
                new(files.Job, theoretical, part, before, after, program, bytes) { OwnDialect = dialect, Library = files.Called().Find },
                out var refusals) is not { } report)
            {
                return FailureOf.Refused(files.Job.File, program, refusals);
            }

            var folder = arguments.GetValue(_out);
            var answer = new VerifyAnswer(report, VerifiedPiece.Of(report, files.Job), folder, isRequired);
            if (folder is not null)
            {
                OutputFile.WriteAll(answer.Files, files.Opened, cancellation);
            }

            return answer;
        }
        catch (GeometryException e)
        {
            return FailureOf.Geometry(e, files.Job.File);
        }
    }
}
