using ErrorMatching.Geometry;
using ErrorMatching.Jobs;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>How well a counterpart that was cut with a correction fits its part: the result of <c>errormatch verify</c> for the same
/// measurements.</summary>
/// <param name="Report">The result; null if nothing was compared.</param>
/// <param name="Otherwise">Why not, in a setter's terms; empty if there is a report.</param>
internal sealed record CounterpartVerification(VerifyReport? Report, Statement Otherwise)
{
    /// <summary>Compares a counterpart with its part. The state before is the job's measured counterpart or, if it names none, the nominal
    /// one.</summary>
    /// <param name="files">The job's files.</param>
    /// <param name="part">The part's measurement; null if none is known for which a program was sent.</param>
    /// <param name="counterpart">The counterpart.</param>
    public static CounterpartVerification Of(JobFiles files, StoredFile? part, MeasurementFile counterpart)
    {
        if (part is null)
        {
            return new(null, Recorded.NotCompared.With());
        }

        try
        {
            var (program, bytes) = files.Program(null);
            var theoretical = files.Theoretical();
            var measured = files.Part(new(part.Name, part.Bytes), theoretical);
            JobFiles.CheckPieces(measured, counterpart);
            var before = files.Job.Counterpart.Measured is { } cut
                ? files.Counterpart(new(files.Job.PathOf(cut)), measured, theoretical)
                : null;
            var input = new VerifyInput(files.Job, theoretical, measured, before, counterpart, program, bytes)
            {
                OwnDialect = files.OwnDialect(),
                Library = files.Called().Find,
            };
            return VerifyRun.Report(input, out var refusals) is { } report
                ? new(report, "")
                : Failed(RefusalForms.StatementOf(refusals[0]));
        }
        catch (GeometryException e)
        {
            return Failed(e.Message);
        }
        catch (InputException e)
        {
            return Failed(e.Refusals[0].Sentence);
        }
    }

    // A measurement is evidence even if it cannot be compared.
    private static CounterpartVerification Failed(Statement why) => new(null, Recorded.NotComparable.With(why));
}
