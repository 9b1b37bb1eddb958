using System.CommandLine;
using ErrorMatching.Freeform;
using ErrorMatching.Jobs;

namespace ErrorMatching.Console;

/// <summary><c>errormatch surface toolpath</c>.</summary>
internal sealed class SurfaceToolpath : Verb
{
    private readonly Argument<string> _job = new("JOB") { Description = "The job." };
    private readonly Option<string> _stage = new("--stage")
    {
        Description = "How much stock is left: that of roughing, that of semi-finishing, or none.",
        HelpName = "roughing|semi-finishing|finishing",
        DefaultValueFactory = _ => "finishing",
    };

    private readonly Option<string> _out = SurfaceOptions.Out("The folder to write the program to. Without it nothing is written.");

    public SurfaceToolpath()
        : base(
            "toolpath",
            "Writes the program that cuts the nominal surface, with its scallop and chordal error measured.",
            "errormatch surface toolpath samples/surface-one/job.json --stage semi-finishing --out out")
    {
        _stage.AcceptOnlyFromAmong("roughing", "semi-finishing", "finishing");
        Arguments.Add(_job);
        Options.Add(_stage);
        Options.Add(_out);
    }

    public override VerbResult Run(ParseResult arguments, CancellationToken cancellation)
    {
        using var progress = new LateProgress(ProgressTo);
        progress.Report("reading the surface");
        var files = new FreeformFiles(arguments.GetRequiredValue(_job));
        var job = files.Job;
        var stage = arguments.GetRequiredValue(_stage) switch
        {
            "roughing" => CuttingStage.Roughing,
            "semi-finishing" => CuttingStage.SemiFinishing,
            _ => CuttingStage.Finishing,
        };
        var surface = files.Surface();
        var dialect = files.ToolpathDialect();
        var template = files.FinishingTemplate(dialect);
        cancellation.ThrowIfCancellationRequested();
        var planned = ToolPathPlanner.Plan(surface, job, stage, dialect, progress: ToolPathProgress.Of(progress));
        if (!planned.IsUsable)
        {
            return FailureOf.Refused(job.File, [planned.Refusal]);
        }

        cancellation.ThrowIfCancellationRequested();
        var folder = arguments.GetValue(_out);
        var answer = new SurfaceToolpathAnswer(job, planned.Path, dialect, stage, template.CallsTool(job), folder);
        if (folder is not null)
        {
            progress.Report("writing the program");
            OutputFile.Write(
                answer.File, FinishingProgram.Write(planned.Path, job, dialect, stage, template: template), files.Opened, cancellation);
        }

        return answer;
    }
}
