using System.CommandLine;
using System.Diagnostics;
using System.Security.Cryptography;
using ErrorMatching.Freeform;
using ErrorMatching.Geometry;
using ErrorMatching.Jobs;
using ErrorMatching.Reporting;

namespace ErrorMatching.Console;

/// <summary><c>errormatch surface compensate</c>.</summary>
internal sealed class SurfaceCompensate : Verb
{
    private readonly Argument<string> _job = new("JOB") { Description = "The job." };
    private readonly Option<string[]> _measured = SurfaceOptions.Measured("The measured points: a table, or the log of the probing program. Several files are repeated measurements of the piece; their mean is used.");
    private readonly Option<string> _out = SurfaceOptions.Out("The folder to write the compensation points, the surface, the finishing program and the reports to. Without it nothing is written.");

    /// <summary>The verb.</summary>
    public SurfaceCompensate()
        : base(
            "compensate",
            "Mirrors the measured error of a surface and writes the finishing program that cuts it away.",
            "errormatch surface compensate samples/surface-one/job.json --measured samples/surface-one/measured.csv --out out")
    {
        Arguments.Add(_job);
        Options.Add(_measured);
        Options.Add(_out);
    }

    /// <inheritdoc/>
    public override Outcome Run(ParseResult arguments, CancellationToken cancellation)
    {
        var clock = Stopwatch.StartNew();
        var files = new FreeformFiles(arguments.GetRequiredValue(_job));
        var job = files.Job;
        var measured = arguments.GetRequiredValue(_measured);
        var dialect = files.Dialect(job.Toolpath.Dialect);
        cancellation.ThrowIfCancellationRequested();
        try
        {
            var compensated = MeasuredCompensation.Of(files, measured, cancellation);
            if (compensated.Result is not { } result)
            {
                return FailureOf.Refused(job.File, compensated.Refusals);
            }

            cancellation.ThrowIfCancellationRequested();
            var path = ToolPathPlanner.Plan(result.Surface, job.Tool, job.Toolpath, 0, dialect);
            if (path.Path is not { } toolPath)
            {
                return FailureOf.Refused(job.File, [path.Refusal!]);
            }

            cancellation.ThrowIfCancellationRequested();
            var folder = arguments.GetValue(_out);
            var program = FinishingProgram.Write(toolPath, job, dialect);
            var named = new ReportInput("finishing", Path.Combine(folder ?? "", "finishing.nc"), Convert.ToHexStringLower(SHA256.HashData(program)));
            var answer = new SurfaceCompensateAnswer(new(files.Named, files.Inputs, result, toolPath, named, clock.Elapsed.TotalSeconds), folder);
            if (folder is not null)
            {
                OutputFile.WriteAll(answer.Files(program), files.Read, cancellation);
            }

            return answer;
        }
        catch (GeometryException e)
        {
            return FailureOf.Geometry(e, measured[0]);
        }
    }
}
