using ErrorMatching.Freeform;
using ErrorMatching.Geometry;
using ErrorMatching.Json;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Jobs;

/// <summary>Runs a free-form job with measured points, files or bytes, to a finishing program, for
/// <c>errormatch surface compensate</c>, <c>surface displace</c> and other callers.</summary>
public static class SurfaceRun
{
    /// <summary>Generates the finishing program of the compensated surface.</summary>
    /// <param name="files">The job's files.</param>
    /// <param name="request">The other inputs.</param>
    /// <param name="cancellation">Checked between the stages of the calculation.</param>
    /// <exception cref="InputException">A file cannot be opened. A file cannot be used. The job's own dialect cannot be used, or
    /// does not exist. The measured points determine no fit.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The gain is out of range.</exception>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public static Outcome<FinishedSurface> Compensate(FreeformFiles files, SurfaceRequest request, CancellationToken cancellation)
    {
        var job = Job(files, request);
        var dialect = files.ToolpathDialect();
        var template = files.FinishingTemplate(dialect);
        cancellation.ThrowIfCancellationRequested();
        var made = request.Folder is { } folder ? PathText.In(folder, FinishedSurface.Name) : null;
        return Fitted<FinishedSurface>(request, () =>
        {
            var surface = files.Surface();
            var surfaceSha256 = files.Inputs.First(i => i.Role == FreeformFiles.SurfaceRole).Sha256;
            if (Compensated(
                files, job, surface, request, dialect.Syntax, made, surfaceSha256, cancellation, out var refusals, out var cutBy)
                is not { } result)
            {
                return Outcome.Refused<FinishedSurface>(refusals);
            }

            cancellation.ThrowIfCancellationRequested();
            var planned = ToolPathPlanner.Plan(
                result.Surface,
                job,
                CuttingStage.Finishing,
                dialect,
                MoreMm(result),
                ToolPathProgress.Of(request.Progress));
            if (!planned.IsUsable)
            {
                return planned.Refusal.In(job.File);
            }

            cancellation.ThrowIfCancellationRequested();
            var marker = new Marker(MeasuredPoints.Sha256Of(result.Input.Measured), surfaceSha256);
            Doing(request, "writing the program");
            var program = FinishingProgram.Write(planned.Path, job, dialect, marker: marker, template: template);
            var named = new ReportInput("finishing", made ?? FinishedSurface.Name, ContentHash.Sha256(program));
            return new FinishedSurface(program, new(files.Named, files.Inputs, result, planned.Path, named, request.ElapsedS?.Invoke())
            {
                CallsTool = template.CallsTool(job),
                CutBy = cutBy,
            });
        });
    }

    /// <summary>Displaces an existing finishing program by the compensation.</summary>
    /// <param name="files">The job's files.</param>
    /// <param name="request">The other inputs.</param>
    /// <param name="program">The shop's finishing program from its CAM system.</param>
    /// <param name="cancellation">Checked between the stages of the calculation.</param>
    /// <exception cref="InputException">A file cannot be opened. A file cannot be used. The job's own dialect cannot be used, or
    /// does not exist. The program is too large. The measured points determine no fit.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The gain is out of range.</exception>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public static Outcome<DisplacedSurface> Displace(
        FreeformFiles files, SurfaceRequest request, GivenFile program, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(program);
        var asked = Job(files, request);

        // A program's positions are displaced by the error there. They cannot follow a surface through the compensation points.
        var job = asked.Fit.OfError ? asked : asked with { Fit = asked.Fit with { Method = FitMethod.Best, OfError = true } };
        var dialect = files.ToolpathDialect();
        var bytes = files.Program(program);
        cancellation.ThrowIfCancellationRequested();
        var made = request.Folder is { } folder ? PathText.In(folder, Path.GetFileName(program.File)) : null;
        return Fitted<DisplacedSurface>(request, () =>
        {
            var programSha256 = ContentHash.Sha256(bytes.Span);
            var surface = files.Surface();
            if (Compensated(
                files, job, surface, request, dialect.Syntax, made, programSha256, cancellation, out var refusals, out var cutBy)
                is not { } compensation)
            {
                return Outcome.Refused<DisplacedSurface>(refusals);
            }

            if (!asked.Fit.OfError)
            {
                compensation = compensation with
                {
                    Warnings = [.. compensation.Warnings, ReportWarning.Of(SurfaceWarningForms.FollowsTheError)],
                };
            }

            Doing(request, "displacing the program");
            var displaced = SurfaceDisplacer.Displace(
                compensation.Input.Surface,
                compensation.Compensated,
                job,
                bytes,
                dialect,
                MeasuredPoints.Sha256Of(compensation.Input.Measured),
                MoreMm(compensation));
            return displaced.IsUsable
                ? new DisplacedSurface(new(files.Named, files.Inputs, program.File, displaced.Result, compensation, request.Folder)
                {
                    CutBy = cutBy,
                })
                : displaced.Refusal.In(program.File);
        });
    }

    // What may lie on the piece besides its stock, and by how much the ball goes lower. A piece that follows earlier ones shows less
    // error than the stock on the next one has.
    private static double MoreMm(CompensationResult result) =>
        Math.Max(result.LargestMoveMm, result.Samples.Max(s => s.ErrorMm)) + result.LargestMoveMm;

    private static FreeformJob Job(FreeformFiles files, SurfaceRequest request)
    {
        ArgumentNullException.ThrowIfNull(files);
        ArgumentNullException.ThrowIfNull(request);
        if (request.Gain is not { } given)
        {
            return files.Job;
        }

        return given is >= 0 and <= 2
            ? files.Job with { Compensation = files.Job.Compensation with { Gain = given } }
            : throw new ArgumentOutOfRangeException(nameof(request), given, "A gain is at least 0 and at most 2.");
    }

    private static CompensationResult? Compensated(
        FreeformFiles files,
        FreeformJob job,
        PartSurface surface,
        SurfaceRequest request,
        NcSyntax syntax,
        string? made,
        string baseSha256,
        CancellationToken cancellation,
        out IReadOnlyList<Refusal> refusals,
        out MeasuredPieceProgram cutBy)
    {
        Doing(request, "reading the measurement");
        var plan = files.Plan(surface);
        cutBy = new(null, null);

        // The points were measured, so they were reachable somehow: only a plan without points or a surface that faces down stops
        // here, not a point that this stylus cannot reach.
        if (plan.Points.Count == 0 || plan.FacesDown)
        {
            refusals = InputRefusals.In(job.File, plan.Refusals);
            return null;
        }

        var earlier = request.Earlier.Select(f => new[] { files.Measured("earlier", f, plan) }).ToArray();
        var points = request.Measured.Select(f => files.Measured("measured", f, plan)).ToArray();
        cancellation.ThrowIfCancellationRequested();
        var previous = PreviousReport.Read(files, request.Previous);
        var piece = new PieceProgram(files, request, syntax, previous);
        if (piece.Refusal(points, [.. earlier.SelectMany(e => e)], made, baseSha256) is { } compensated)
        {
            refusals = [compensated];
            return null;
        }

        cutBy = piece.Found with { Previous = previous?.File };
        Doing(request, "fitting the error");
        var outcome = Compensator.Compensate(new(job, surface, plan, points) { Previous = previous?.Lot, Earlier = earlier });
        refusals = InputRefusals.In(job.File, outcome.Refusals);
        return outcome.Result is { } result && GainNote.Of(request.Gain, files.Job.Compensation.Gain) is { } note
            ? result with { Notes = [.. result.Notes, note] }
            : outcome.Result;
    }

    private static void Doing(SurfaceRequest request, string what) => request.Progress?.Report(new(what, null));

    private static Outcome<T> Fitted<T>(SurfaceRequest request, Func<Outcome<T>> run)
        where T : class
    {
        try
        {
            return run();
        }
        catch (GeometryException e)
        {
            throw InputRefusals.Of(e, request.Measured[0].File);
        }
    }
}
