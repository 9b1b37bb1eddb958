using System.CommandLine;
using System.Diagnostics;
using ErrorMatching.Freeform;
using ErrorMatching.Jobs;

namespace ErrorMatching.Console;

/// <summary><c>errormatch surface compensate</c>.</summary>
internal sealed class SurfaceCompensate : Verb
{
    private readonly Argument<string> _job = new("JOB") { Description = "The job." };
    private readonly Option<string[]> _measured = SurfaceOptions.Measured(
        "The measured points: a table, or the log of the probing program. Several files are repeated measurements of the piece; their "
            + "mean is used.");
    private readonly Option<string> _cutBy = SurfaceOptions.CutBy();
    private readonly Option<string> _previous = SurfaceOptions.Previous();
    private readonly Option<string[]> _earlier = SurfaceOptions.Earlier();
    private readonly AcceptOption _accept = SurfaceOptions.Accept();
    private readonly Option<string> _out = SurfaceOptions.Out(
        "The folder to write the compensation points, the surface, the finishing program and the reports to. Without it nothing is "
            + "written.");

    public SurfaceCompensate()
        : base(
            "compensate",
            "Mirrors the measured error of a surface and writes the finishing program that cuts it away.",
            "errormatch surface compensate samples/surface-one/job.json --measured samples/surface-one/measured.csv --out out")
    {
        Arguments.Add(_job);
        Options.Add(_measured);
        Options.Add(_cutBy);
        Options.Add(_previous);
        Options.Add(_earlier);
        Options.Add(_accept);
        Options.Add(_out);
    }

    public override VerbResult Run(ParseResult arguments, CancellationToken cancellation)
    {
        var clock = Stopwatch.StartNew();
        using var progress = new LateProgress(ProgressTo);
        var files = new FreeformFiles(arguments.GetRequiredValue(_job));
        var folder = arguments.GetValue(_out);
        var outcome = SurfaceRun.Compensate(
            files,
            new()
            {
                Measured = [.. arguments.GetRequiredValue(_measured).Select(f => GivenMeasurement(f))],
                CutBy = GivenFile.At(arguments.GetValue(_cutBy)),
                Previous = GivenFile.At(arguments.GetValue(_previous)),
                Earlier = [.. (arguments.GetValue(_earlier) ?? []).Select(f => new GivenFile(f))],
                Folder = folder,
                Progress = progress,
                ElapsedS = () => clock.Elapsed.TotalSeconds,
            },
            cancellation);
        if (outcome.Result is not { } finished)
        {
            return new Failure(ExitCode.Refused, outcome.Refusals);
        }

        var obedient = finished.Obey(_accept.Of(arguments));
        var answer = new SurfaceCompensateAnswer(
            obedient,
            folder,
            FailureOf.NotToCut(
                obedient.Report.Acceptance,
                ProfileLead.Of(obedient.Report.Result, obedient.Report.Verdict),
                files.Job.File,
                SurfaceCompensateAnswer.Targets(folder),
                files.Opened));
        if (folder is not null)
        {
            progress.Report("making the reports");
            OutputFile.WriteAll(answer.Files(), files.Opened, cancellation);
        }

        return answer;
    }
}
