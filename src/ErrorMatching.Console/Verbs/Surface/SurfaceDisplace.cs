using System.CommandLine;
using ErrorMatching.Freeform;
using ErrorMatching.Geometry;
using ErrorMatching.Jobs;

namespace ErrorMatching.Console;

/// <summary><c>errormatch surface displace</c>.</summary>
internal sealed class SurfaceDisplace : Verb
{
    private readonly Argument<string> _job = new("JOB") { Description = "The job." };
    private readonly Option<string[]> _measured = SurfaceOptions.Measured("The measured points: a table, or the log of the probing program. Several files are repeated measurements of the piece; their mean is used.");
    private readonly Option<string> _program = FileOption("--program", "The finishing program that the shop has from its CAM.");
    private readonly Option<string> _out = SurfaceOptions.Out("The folder to write the displaced program to, by the same name. Without it nothing is written.");

    /// <summary>The verb.</summary>
    public SurfaceDisplace()
        : base(
            "displace",
            "Lets every point of an existing finishing program follow the compensation, and proves what changed.",
            "errormatch surface displace samples/surface-one/job.json --measured samples/surface-one/measured.csv --program samples/surface-one/cam.nc --out out")
    {
        _program.Required = true;
        Arguments.Add(_job);
        Options.Add(_measured);
        Options.Add(_program);
        Options.Add(_out);
    }

    /// <inheritdoc/>
    public override Outcome Run(ParseResult arguments, CancellationToken cancellation)
    {
        var files = new FreeformFiles(arguments.GetRequiredValue(_job));
        var job = files.Job;
        var measured = arguments.GetRequiredValue(_measured);
        var dialect = files.Dialect(job.Toolpath.Dialect);
        var program = arguments.GetRequiredValue(_program);
        var bytes = files.Program(program);
        cancellation.ThrowIfCancellationRequested();
        try
        {
            var compensated = MeasuredCompensation.Of(files, measured, cancellation);
            if (compensated.Result is not { } compensation)
            {
                return FailureOf.Refused(job.File, compensated.Refusals);
            }

            var displaced = SurfaceDisplacer.Displace(compensation.Input.Surface, compensation.Compensated, job.Compensation.Gain, job.Tool, bytes, dialect, job.Toolpath.ProgramsTip);
            if (!displaced.IsUsable)
            {
                return FailureOf.Refused(program, displaced.Refusal);
            }

            var folder = arguments.GetValue(_out);
            var answer = new SurfaceDisplaceAnswer(job, program, displaced.Value, compensation, folder);
            if (folder is not null)
            {
                OutputFile.Write(answer.File, displaced.Value.Program.Bytes, files.Read, cancellation);
            }

            return answer;
        }
        catch (GeometryException e)
        {
            return FailureOf.Geometry(e, measured[0]);
        }
    }
}
