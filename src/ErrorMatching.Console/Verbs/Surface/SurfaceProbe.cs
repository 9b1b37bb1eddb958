using System.CommandLine;
using ErrorMatching.Freeform;
using ErrorMatching.Jobs;

namespace ErrorMatching.Console;

/// <summary><c>errormatch surface probe</c>.</summary>
internal sealed class SurfaceProbe : Verb
{
    private readonly Argument<string> _job = new("JOB") { Description = "The job." };
    private readonly Option<string> _after = FileOption(
        "--after", "A semi-finishing program: probing follows it in one program, which then stops for the finishing program.");
    private readonly Option<string> _out = SurfaceOptions.Out(
        "The folder to write probe.nc and plan.csv to. Without it nothing is written.");

    public SurfaceProbe()
        : base(
            "probe",
            "Writes the program that measures the surface on the machine.",
            "errormatch surface probe samples/surface-one/job.json --out out")
    {
        Arguments.Add(_job);
        Options.Add(_after);
        Options.Add(_out);
    }

    public override VerbResult Run(ParseResult arguments, CancellationToken cancellation)
    {
        using var progress = new LateProgress(ProgressTo);
        progress.Report("planning the points");
        var files = new FreeformFiles(arguments.GetRequiredValue(_job));
        var plan = files.Plan(files.Surface());
        if (plan.Refusals.Count > 0)
        {
            return FailureOf.Refused(files.Job.File, plan.Refusals);
        }

        var dialect = files.MeasuringDialect();
        cancellation.ThrowIfCancellationRequested();
        var probing = ProbingProgram.Of(plan, files.Job.Name, dialect, files.Template(dialect), files.Job.WorkOrder);
        var after = arguments.GetValue(_after);
        var program = after is null ? probing.Bytes : probing.MergeAfter(files.Program(new(after)), after, files.Job.Toolpath.Dialect);
        var answer = new SurfaceProbeAnswer(files.Job, plan, probing, after, arguments.GetValue(_out));
        OutputFile.WriteAll(answer.Files(program), files.Opened, cancellation);
        return answer;
    }
}
