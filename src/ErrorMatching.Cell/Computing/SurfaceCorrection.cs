using System.Globalization;
using ErrorMatching.Freeform;
using ErrorMatching.Jobs;
using ErrorMatching.Json;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>A correction of a free-form surface. The measured points generate the finishing program, or displace an existing one.</summary>
internal sealed class SurfaceCorrection
{
    private readonly CorrectionRequest _request;
    private readonly PolicySettings _policy;
    private readonly byte[] _job;
    private readonly FreeformFiles _files;

    /// <summary>Reads the job.</summary>
    /// <param name="request">What is computed from it.</param>
    /// <param name="policy">The policy that applies to it.</param>
    /// <param name="job">The bytes of the job's file.</param>
    /// <exception cref="InputException">The job cannot be used.</exception>
    public SurfaceCorrection(CorrectionRequest request, PolicySettings policy, byte[] job) =>
        (_request, _policy, _job, _files) = (request, policy, job, new(FreeformJob.Parse(job, request.Job.File)));

    /// <summary>Determines the correction's inputs.</summary>
    public Computation Identify()
    {
        var dialect = _files.ToolpathDialect();
        if (_request.Job.Program is null)
        {
            _ = _files.FinishingTemplate(dialect);
        }

        _ = _files.SurfaceBytes();
        return new Identified(Basis(_request.Job.Program is { } program ? _files.Program(new(program)) : default(ReadOnlyMemory<byte>?)));
    }

    /// <summary>Computes it.</summary>
    public Computation Compute(CancellationToken cancellation)
    {
        // A piece that still has stock has not been cut by a finishing program.
        var job = _files.Job;
        var cutBy = job.Stock.Of(job.Measuring.After) > 0 || _request.LastSent is not { } sent
            ? null
            : new GivenFile(sent.Name, sent.Bytes);
        var measured = new SurfaceRequest
        {
            Measured = [new(_request.Measurement.Name, _request.Measurement.Bytes)],
            CutBy = cutBy,
            Previous = _request.Previous is { } previous ? new(previous.Name, previous.Bytes) : null,
            Gain = _policy.Gain
        };
        return _request.Job.Program is { } program ? Displace(measured, program, cancellation) : Compensate(measured, cancellation);
    }

    private Computation Compensate(SurfaceRequest measured, CancellationToken cancellation)
    {
        var outcome = SurfaceRun.Compensate(_files, measured, cancellation);
        if (outcome.Result is not { } finished)
        {
            return CorrectionComputer.Refused(outcome.Refusals);
        }

        var result = finished.Report.Result;
        return Within(result, result.LargestMoveMm, (steps, largest, at) => new()
        {
            Basis = Basis(null),
            ProgramName = FinishedSurface.Name,
            Program = finished.Program,
            Report = finished.ReportJson(),
            Page = finished.ReportHtml(),
            LargestMm = largest,
            LargestAt = at,
            Corrections = steps,
            Sums = _request.Sums.Plus(steps),
            SumMm = result.LargestMoveMm,
            ChangedBlocks = null,
            ChangedWords = null,
            Warnings = [.. finished.Report.Warnings.Select(SurfaceWarningForms.StatementOf)],
        });
    }

    private Computation Displace(SurfaceRequest measured, string program, CancellationToken cancellation)
    {
        var bytes = InputFile.Program(program);
        var outcome = SurfaceRun.Displace(_files, measured, new(program, bytes), cancellation);
        if (outcome.Result is not { } displaced)
        {
            return CorrectionComputer.Refused(outcome.Refusals);
        }

        var (report, compensation) = (displaced.Report, displaced.Report.Compensation);
        var (rewrite, sum) = (report.Displaced.Rewrite, report.Displaced.LargestMoveMm);
        return Within(compensation, sum, (steps, largest, at) => new()
        {
            Basis = Basis(bytes),
            ProgramName = report.Name,
            Program = displaced.Program,
            Report = displaced.ReportJson(),
            Page = displaced.ReportHtml(),
            LargestMm = largest,
            LargestAt = at,
            Corrections = steps,
            Sums = _request.Sums.Plus(steps),
            SumMm = sum,
            ChangedBlocks = rewrite.ChangedBlocks.Count,
            ChangedWords = rewrite.ChangedWords,
            Warnings = [.. compensation.Warnings.Select(SurfaceWarningForms.StatementOf)],
        });
    }

    // A program starts from the nominal surface. The step is the change since the program that cut the piece: without one, the whole.
    private Computation Within(
        CompensationResult result, double sumMm, Func<PointCorrection[], double, Statement, ComputedProgram> computed)
    {
        var limits = new DisplacementLimits(_policy, result.Input.Job.Compensation.LimitMm);
        var sums = Moves(result);
        var accumulates = _request.Previous is not null;
        var before = _request.Sums.Points.ToDictionary(p => p.Point, StringComparer.Ordinal);
        PointCorrection[] steps = accumulates
            ? [
                .. sums.Select(s => before.TryGetValue(s.Point, out var was)
                    ? s with { X = s.X - was.X, Y = s.Y - was.Y, Z = s.Z - was.Z }
                    : s)]
            : sums;
        var largest = accumulates ? steps.Max(s => s.LengthMm) : sumMm;
        var at = At(steps, largest);
        return limits.OfStep(largest, at, block: null)
            ?? (accumulates ? limits.OfSum(sumMm, At(sums, sumMm), block: null) : null)
            ?? (Computation)computed(steps, largest, at);
    }

    private static Statement At(PointCorrection[] moves, double largestMm)
    {
        var worst = moves.MaxBy(s => s.LengthMm)!;
        return largestMm > 0 ? (largestMm > worst.LengthMm ? Recorded.AtPointAndBeside : Recorded.AtPoint).With(worst.Point) : "";
    }

    private CorrectionBasis Basis(ReadOnlyMemory<byte>? program)
    {
        var baseSha256 = program is { } bytes ? ContentHash.Sha256(bytes.Span) : null;
        return new(
            CorrectionIdentity.Of(
                _request.Previous is { } previous ? [_request.Measurement.Sha256, previous.Sha256] : [_request.Measurement.Sha256],
                CorrectionIdentity.OfJob(_files.Job.Sha256, _files.Inputs),
                baseSha256,
                _policy.Gain),
            _files.Job.Sha256,
            _job,
            baseSha256,
            program,
            _files.Job.WorkOrder);
    }

    private static PointCorrection[] Moves(CompensationResult result) => [.. result.Samples.Select(s =>
    {
        var by = result.MoveAt(s);
        return new PointCorrection(s.Point.ToString(CultureInfo.InvariantCulture), by.X, by.Y, by.Z);
    })];
}
