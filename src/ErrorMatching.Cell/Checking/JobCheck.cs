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
            }

            if (program is null)
            {
                return new(job, null, null, null);
            }

            var path = NcInterpreter.Run(
                NcProgram.Read(InputFile.Program(program)), dialect, new ProgramFolder(program).Find, cancellation);
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
