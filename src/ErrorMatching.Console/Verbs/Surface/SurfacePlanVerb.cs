using System.CommandLine;
using ErrorMatching.Freeform;
using ErrorMatching.Jobs;

namespace ErrorMatching.Console;

/// <summary><c>errormatch surface plan</c>.</summary>
internal sealed class SurfacePlanVerb : Verb
{
    private readonly Argument<string> _job = new("JOB") { Description = "The job." };
    private readonly Option<string> _out = SurfaceOptions.Out("The folder to write plan.csv to. Without it nothing is written.");

    public SurfacePlanVerb()
        : base(
            "plan",
            "Decides where the surface is touched and in which order.",
            "errormatch surface plan samples/surface-one/job.json --out out")
    {
        Arguments.Add(_job);
        Options.Add(_out);
    }

    public override VerbResult Run(ParseResult arguments, CancellationToken cancellation)
    {
        using var progress = new LateProgress(ProgressTo);
        progress.Report("planning the points");
        var files = new FreeformFiles(arguments.GetRequiredValue(_job));
        var plan = files.Plan(files.Surface());
        cancellation.ThrowIfCancellationRequested();
        if (plan.Refusals.Count > 0 && !plan.FacesDown)
        {
            return FailureOf.Refused(files.Job.File, plan.Refusals);
        }

        var folder = arguments.GetValue(_out);
        if (folder is not null)
        {
            OutputFile.Write(Path.Combine(folder, SurfacePlanAnswer.FileName), PlanCsv.Write(plan), files.Opened, cancellation);
        }

        return new SurfacePlanAnswer(files.Job, plan, folder);
    }
}
