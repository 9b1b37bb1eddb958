using System.CommandLine;
using ErrorMatching.Freeform;
using ErrorMatching.Jobs;

namespace ErrorMatching.Console;

/// <summary><c>errormatch surface displace</c>.</summary>
internal sealed class SurfaceDisplace : Verb
{
    private readonly Argument<string> _job = new("JOB") { Description = "The job." };
    private readonly Option<string[]> _measured = SurfaceOptions.Measured(
        "The measured points: a table, or the log of the probing program. Several files are repeated measurements of the piece; their "
            + "mean is used.");
    private readonly Option<string> _cutBy = SurfaceOptions.CutBy();
    private readonly Option<string> _previous = SurfaceOptions.Previous();
    private readonly Option<string[]> _earlier = SurfaceOptions.Earlier();
    private readonly Option<string> _program = FileOption("--program", "The finishing program that the shop has from its CAM.");
    private readonly AcceptOption _accept = SurfaceOptions.Accept();
    private readonly Option<string> _out = SurfaceOptions.Out(
        "The folder to write the displaced program to, by the same name. Without it nothing is written.");

    public SurfaceDisplace()
        : base(
            "displace",
            "Lets every point of an existing finishing program follow the compensation, and proves what changed.",
            "errormatch surface displace samples/surface-one/job.json --measured samples/surface-one/measured.csv --program "
                + "samples/surface-one/cam.nc --out out")
    {
        _program.Required = true;
        Arguments.Add(_job);
        Options.Add(_measured);
        Options.Add(_cutBy);
        Options.Add(_previous);
        Options.Add(_earlier);
        Options.Add(_program);
        Options.Add(_accept);
        Options.Add(_out);
    }

    public override VerbResult Run(ParseResult arguments, CancellationToken cancellation)
    {
        using var progress = new LateProgress(ProgressTo);
        var files = new FreeformFiles(arguments.GetRequiredValue(_job));
        var folder = arguments.GetValue(_out);
        var outcome = SurfaceRun.Displace(
            files,
            new()
            {
                Measured = [.. arguments.GetRequiredValue(_measured).Select(f => GivenMeasurement(f))],
                CutBy = GivenFile.At(arguments.GetValue(_cutBy)),
                Previous = GivenFile.At(arguments.GetValue(_previous)),
                Earlier = [.. (arguments.GetValue(_earlier) ?? []).Select(f => new GivenFile(f))],
                Folder = folder,
                Progress = progress,
            },
            new(arguments.GetRequiredValue(_program)),
            cancellation);
        if (outcome.Result is not { } displaced)
        {
            return new Failure(ExitCode.Refused, outcome.Refusals);
        }

        var obedient = displaced.Obey(_accept.Of(arguments));
        if (folder is not null && !obedient.Report.Acceptance.IsWithheld)
        {
            OutputFile.Write(displaced.Report.File, displaced.Program, files.Opened, cancellation);
        }

        return new SurfaceDisplaceAnswer(
            obedient,
            FailureOf.NotToCut(
                obedient.Report.Acceptance,
                ProfileLead.Of(obedient.Report.Compensation, obedient.Report.Verdict),
                files.Job.File,
                folder is null ? [] : [displaced.Report.File],
                files.Opened));
    }
}
