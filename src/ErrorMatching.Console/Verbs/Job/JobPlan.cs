using System.CommandLine;
using ErrorMatching.Jobs;
using ErrorMatching.Json;

namespace ErrorMatching.Console;

/// <summary><c>errormatch job plan</c>.</summary>
internal sealed class JobPlan : Verb
{
    private readonly Argument<string> _job = new("JOB") { Description = "A mating job. Its part need not be measured." };
    private readonly Option<string> _out = FileOption(
        "--out", "The folder to write plan.csv and a job with its points to. Without it nothing is written.");

    private readonly Option<double?> _stylus = ProbeOptions.Stylus();
    private readonly Option<double?> _within = ProbeOptions.Positive(
        "--within", "How well the boundary must be known everywhere, 95 %. Without it: a fifth of the limits.", "MM");

    public JobPlan()
        : base(
            "plan",
            "Chooses where to touch the part, and predicts what that will tell.",
            "errormatch job plan samples/complex-mating/job.json --out out")
    {
        Arguments.Add(_job);
        Options.Add(_out);
        Options.Add(_stylus);
        Options.Add(_within);
    }

    public override VerbResult Run(ParseResult arguments, CancellationToken cancellation)
    {
        using var progress = new LateProgress(ProgressTo);
        progress.Report("choosing the points");
        var (file, folder) = (arguments.GetRequiredValue(_job), arguments.GetValue(_out));
        var outcome = PlannedJob.Make(
            file, folder ?? ".", arguments.GetValue(_stylus), arguments.GetValue(_within), cancellation);
        if (outcome.Result is not { } planned)
        {
            return new Failure(ExitCode.Refused, outcome.Refusals);
        }

        var (plan, job) = folder is null
            ? (null, null)
            : (PathText.In(folder, PlannedJob.PlanFile), PathText.In(folder, PlannedJob.FileOf(file)));
        if (plan is not null)
        {
            OutputFile.WriteAll([(plan, planned.Table), (job!, planned.Document)], planned.Read, cancellation);
        }

        return new JobPlanAnswer(planned, plan, job);
    }
}
