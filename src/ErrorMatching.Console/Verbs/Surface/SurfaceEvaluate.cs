using System.CommandLine;
using ErrorMatching.Freeform;
using ErrorMatching.Jobs;
using ErrorMatching.Refusals;

namespace ErrorMatching.Console;

/// <summary><c>errormatch surface evaluate</c>.</summary>
internal sealed class SurfaceEvaluate : Verb
{
    private readonly Argument<string> _job = new("JOB") { Description = "The job." };
    private readonly Option<string[]> _measured = SurfaceOptions.Measured(
        "The measured surface; several files are replicas of one design.");
    private readonly Option<string[]> _before = new("--before")
    {
        Description = "The surface before compensation, to compare with; several files are replicas.",
        HelpName = "FILE",
        AllowMultipleArgumentsPerToken = true
    };
    private readonly Option<string[]> _radius = new("--tool-radius")
    {
        Description = "Pieces that were compensated by tool radius instead, to set beside.",
        HelpName = "FILE",
        AllowMultipleArgumentsPerToken = true
    };
    private readonly Option<string[]> _radiusBefore = new("--tool-radius-before")
    {
        Description = "Those before compensation.",
        HelpName = "FILE",
        AllowMultipleArgumentsPerToken = true
    };
    private readonly Option<bool> _require = new("--require-in-tolerance")
    {
        Description = "Exit with 2 unless all measured pieces are in the job's profileToleranceMm. What --out asks for is written all "
            + "the same: it says why.",
    };
    private readonly Option<string> _out = SurfaceOptions.Out(
        "The folder to write evaluation.json, evaluation.html, evaluation.qif and evaluation.dfq to. Without it nothing is written.");

    public SurfaceEvaluate()
        : base(
            "evaluate",
            "Says what the errors of a measured surface come to: mean, standard deviation, profile, and where they are.",
            "errormatch surface evaluate samples/surface-one/job.json --measured samples/surface-one/after.csv --before "
                + "samples/surface-one/measured.csv --out out")
    {
        Arguments.Add(_job);
        Options.Add(_measured);
        Options.Add(_before);
        Options.Add(_radius);
        Options.Add(_radiusBefore);
        Validators.Add(result =>
        {
            if (result.GetValue(_radiusBefore) is { Length: > 0 } && result.GetValue(_radius) is not { Length: > 0 })
            {
                result.AddError("--tool-radius-before goes with --tool-radius: there is nothing to compare it with.");
            }
        });
        Options.Add(_require);
        Options.Add(_out);
    }

    public override VerbResult Run(ParseResult arguments, CancellationToken cancellation)
    {
        using var progress = new LateProgress(ProgressTo);
        progress.Report("reading the measurements");
        var files = new FreeformFiles(arguments.GetRequiredValue(_job));
        var isRequired = arguments.GetValue(_require);
        if (isRequired && files.Job.Profile is null)
        {
            return new Failure(ExitCode.WrongInput, new Refusal(
                "tolerance-missing",
                $"{files.Job.File} states no \"profileToleranceMm\", which --require-in-tolerance compares with. Enter the width of the "
                    + "zone, ISO 1101, in mm.",
                new() { File = files.Job.File, Path = "$" }));
        }

        var surface = files.Surface();
        var plan = files.Plan(surface);
        // The points were measured, so they were reachable: only a plan without points stops here, not one that this stylus does not reach.
        if (plan.Points.Count == 0)
        {
            return FailureOf.Refused(files.Job.File, plan.Refusals);
        }

        var measured = Read("measured", arguments.GetRequiredValue(_measured));
        var before = Read("before", arguments.GetValue(_before));
        var radius = Read("toolRadius", arguments.GetValue(_radius));
        var radiusBefore = Read("toolRadiusBefore", arguments.GetValue(_radiusBefore));
        cancellation.ThrowIfCancellationRequested();
        progress.Report("evaluating the errors");
        var report = new EvaluationReport(
            files.Named,
            files.Inputs,
            surface,
            SurfaceEvaluation.Evaluate(files.Job, surface, measured),
            Of(before),
            Of(radius),
            Of(radiusBefore))
        {
            Tolerance = files.Job.Profile,
        };
        var folder = arguments.GetValue(_out);
        var answer = new SurfaceEvaluateAnswer(report, files.Job.Stock, folder, isRequired);
        if (folder is not null)
        {
            progress.Report("making the reports");
            OutputFile.WriteAll(answer.Files, files.Opened, cancellation);
        }

        return answer;

        MeasuredPoints[] Read(string name, string[]? paths) =>
            [.. (paths ?? []).Select(f => files.Measured(name, GivenMeasurement(f), plan))];

        SurfaceEvaluation? Of(MeasuredPoints[] pieces) =>
            pieces.Length == 0 ? null : SurfaceEvaluation.Evaluate(files.Job, surface, pieces);
    }
}
