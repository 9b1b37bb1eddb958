using ErrorMatching.Jobs;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Cell;

/// <summary>Reads the files that a job names and follows its base program.</summary>
internal static class JobCheck
{
    public static CheckedJob Of(CellJobSettings job, CancellationToken cancellation)
    {
        string? program = null;
        try
        {
            NcDialect dialect;
            ProgramFolder? called = null;
            if (job.IsFreeform)
            {
                var files = new FreeformFiles(job.File);
                _ = files.Surface();
                (program, dialect) = (job.Program, files.ToolpathDialect());
            }
            else
            {
                var files = new JobFiles(job.File);
                _ = files.Theoretical();
                (program, dialect) = (files.Job.PathOf(files.Job.Counterpart.Program), InputFile.DialectOf(files.Job));
                called = files.Called();
            }

            if (program is null)
            {
                return new(job, null, null, null);
            }

            var path = NcInterpreter.Run(
                NcProgram.Read(InputFile.Program(program)), dialect, (called ?? new ProgramFolder(program)).Find, cancellation);
            return path.Refusal is { } refusal
                ? new(job, program, null, new([refusal.In(program)]))
                : new(job, program, path.Motions.Length, null);
        }
        catch (InputException e)
        {
            return new(job, program, null, new(e.Refusals));
        }
    }
}

/// <summary>Whether a job could start: its files can be read, and its base program can be followed to its end.</summary>
/// <param name="Job">The job.</param>
/// <param name="Program">Its base program; null for a job that generates one.</param>
/// <param name="Motions">Number of motions in that program; null if there is none or it cannot be followed.</param>
/// <param name="Problem">What is wrong; null if nothing is.</param>
public sealed record CheckedJob(CellJobSettings Job, string? Program, int? Motions, CheckProblem? Problem);
