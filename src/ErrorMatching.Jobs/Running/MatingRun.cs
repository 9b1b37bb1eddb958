using ErrorMatching.Geometry;
using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>Runs a mating job with measurements, files or bytes, to a program and its report, for <c>errormatch match</c> and
/// others.</summary>
public static class MatingRun
{
    /// <summary>Runs a job.</summary>
    /// <param name="files">The job's files.</param>
    /// <param name="request">The other inputs; null for the job's own.</param>
    /// <param name="cancellation">Checked between reading and calculating.</param>
    /// <exception cref="InputException">A file cannot be opened. A measurement cannot be used. A measurement is of the other piece.
    /// The job's own dialect cannot be used. The dialect, a selector or the program cannot be read. The measured points determine
    /// no solution.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The gain is out of range.</exception>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public static Outcome<MatchedProgram> Run(JobFiles files, MatingRequest? request = null, CancellationToken cancellation = default)
    {
        ArgumentNullException.ThrowIfNull(files);
        request ??= new();
        var job = WithGain(files.Job, request.Gain);
        job = job with { Counterpart = job.Counterpart with { Assumed = job.Counterpart.Assumed.With(request.Assumed) } };
        var theoretical = files.Theoretical(request.Theoretical);
        var part = files.Part(request.Part, theoretical);
        files.CheckFrame(theoretical, part);
        var counterpart = request.Counterpart is { } given
            ? files.Counterpart(given, part, theoretical)
            : NamedCounterpart(files, part, theoretical);
        var (program, bytes) = files.Program(request.Program);
        var dialect = files.OwnDialect();
        cancellation.ThrowIfCancellationRequested();
        var read = NcProgram.Read(bytes, job.Counterpart.DialectOf(dialect).Syntax);
        var (previous, newLot) = Previous(request, job, theoretical, read);
        try
        {
            var called = files.Called();
            var outcome = Matcher.Match(
                new(job, theoretical, part, counterpart, program, bytes)
                {
                    OwnDialect = dialect,
                    Previous = previous,
                    Latest = Latest(request, job, theoretical, previous, read, program),
                    ToolChanged = request.ToolChanged,
                    Library = called.Find,
                    OffsetsFile = request.OffsetsFile,
                });
            if (outcome.Result is not { } result)
            {
                var why = InputRefusals.Of(outcome.Refusals, job.File, program);
                return Outcome.Refused<MatchedProgram>(
                    DialectFit.Refusal(NcProgram.Read(bytes), job.Counterpart.DialectOf(dialect)) is { } other
                        ? [other.In(program), .. why]
                        : why);
            }

            // What comes from a pipe has no name of its own.
            var name = Path.GetFileName(SharedFile.IsStream(program) ? job.Counterpart.Program : program);
            var report = MatchReporter.Report(result, PathText.In(request.Folder, name), request.ElapsedS?.Invoke());
            if (request.Counterpart is null && MissingMeasured.Of(job) is { } missing)
            {
                report = report with { Warnings = [.. report.Warnings, missing] };
            }

            report = newLot is null ? report : report with { Notes = [.. report.Notes, newLot] };
            return new MatchedProgram(
                result,
                GainNote.Of(request.Gain, files.Job.Compensation.Gain) is { } note
                    ? report with { Notes = [.. report.Notes, note] }
                    : report)
            {
                Name = name,
            };
        }
        catch (GeometryException e)
        {
            throw InputRefusals.Of(e, part.File);
        }
    }

    // The match before, or why a new lot begins.
    private static (PreviousMatch? Match, string? Anew) Previous(
        MatingRequest request, MatingJob job, MeasurementFile theoretical, NcProgram program)
    {
        if (request.Previous is not { } given)
        {
            return !request.ToolChanged || request.Latest is not null ? default
                : throw new InputException(Refusal.Of(
                    "tool-changed-alone",
                    "a changed tool, but no match before it",
                    "the report of the match whose program cut the counterpart, because the first counterpart has nothing to forget",
                    new() { File = job.File }));
        }

        ThrowIfNotFeedback(job);
        try
        {
            return (PreviousMatchReport.Read(given, job, theoretical, program), null);
        }
        catch (InputException e) when (
            request.MayBeginAnew && e.Code is PreviousMatchReport.LotMissing or PreviousMatchReport.OtherPoints)
        {
            return (null, $"The pieces before do not count, and a new lot begins: {e.Message}");
        }
    }

    // The last match of the lot. It knows the counterpart that the program of this one followed, unless that was a nominal one.
    private static PreviousMatch? Latest(
        MatingRequest request,
        MatingJob job,
        MeasurementFile theoretical,
        PreviousMatch? previous,
        NcProgram program,
        string programFile)
    {
        if (request.Latest is not { } given)
        {
            return null;
        }

        ThrowIfNotFeedback(job);
        if (previous is null && Marker.Find(program).Any(m => m.Marker is not null))
        {
            throw new InputException(Refusal.Of(
                "previous-missing",
                "a program that follows a measurement already, without the report that says what it corrects",
                "that report as --previous, or the nominal program",
                new() { File = programFile }));
        }

        var latest = PreviousMatchReport.Read(given, job, theoretical, null);
        return previous is null || latest.Pieces.Pieces.Any(p => p.MeasuredSha256 == previous.Pieces.Pieces[^1].MeasuredSha256)
            ? latest
            : throw new InputException(Refusal.Of(
                "other-lot",
                "a report that does not know the counterpart that the program of this one followed",
                $"the report of the last match of the lot, which goes on from {previous.File}",
                new() { File = given.File, Path = "$.lot" }));
    }

    private static void ThrowIfNotFeedback(MatingJob job)
    {
        if (job.Compensation.From != CompensationSource.Counterpart)
        {
            throw new InputException(Refusal.Of(
                "previous-not-feedback",
                "a previous report for a job that follows the measured part, whose program starts from the nominal one each time",
                "a job with \"from\": \"counterpart\" in its compensation",
                new() { File = job.File }));
        }
    }

    private static MatingJob WithGain(MatingJob job, double? gain)
    {
        if (gain is not { } given)
        {
            return job;
        }

        return given is > 0 and <= 2
            ? job with { Compensation = job.Compensation with { Gain = given } }
            : throw new ArgumentOutOfRangeException(nameof(gain), given, "A gain is more than 0 and at most 2.");
    }

    // In feed-forward the counterpart need not exist yet, whatever the job says about its measurement.
    private static MeasurementFile? NamedCounterpart(JobFiles files, MeasurementFile part, MeasurementFile theoretical)
    {
        var job = files.Job;
        if (job.Compensation.From != CompensationSource.Counterpart || job.Counterpart.Measured is not { } measured)
        {
            return null;
        }

        try
        {
            return files.Counterpart(new(job.PathOf(measured)), part, theoretical);
        }
        catch (InputException e) when (e.Code == MeasurementError.FileUnreadable && job.MeasuredPlace is { } place)
        {
            throw InputRefusals.NamedAt(job.File, MissingMeasured.Path, place, e);
        }
    }
}
