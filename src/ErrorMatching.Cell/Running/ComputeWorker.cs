using ErrorMatching.Json;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Computes recognized corrections. Several loops may run concurrently: each takes a different correction, the earliest
/// first.</summary>
internal sealed class ComputeWorker(CellFlow flow)
{
    private readonly CorrectionComputer _computer = new(flow.Settings.Policy);
    private readonly HashSet<long> _taken = [];
    private readonly Lock _gate = new();

    /// <summary>Computes one correction, if any.</summary>
    /// <returns>How long to wait before looking again.</returns>
    public async Task<TimeSpan> WorkAsync(CancellationToken stop)
    {
        if (Take() is not { } recognized)
        {
            return flow.Idle;
        }

        try
        {
            using var activity = CellTelemetry.Start("compute", recognized);
            await Task.Yield();
            flow.FailingAlone(recognized, () => Compute(recognized, stop));
        }
        finally
        {
            lock (_gate)
            {
                _taken.Remove(recognized.Id);
            }
        }

        return TimeSpan.Zero;
    }

    private Correction? Take()
    {
        lock (_gate)
        {
            var next = flow.Store.Corrections.First(
                CorrectionState.Recognized, _taken.Count + 1, jobs: flow.Jobs).FirstOrDefault(c => !_taken.Contains(c.Id));
            if (next is not null)
            {
                _taken.Add(next.Id);
            }

            return next;
        }
    }

    private void Compute(Correction recognized, CancellationToken stop)
    {
        var job = flow.Settings.Jobs.First(j => j.Name == recognized.Job);
        switch (_computer.Compute(CorrectionRequests.Of(flow, recognized, job, flow.Store.Content(recognized.MeasurementSha256)), stop))
        {
            case ComputedProgram computed when flow.Store.Corrections.LastSent(job.Name, null) is { } last
                && last.Offset is null != computed.Offset is null:
                Refuse(recognized, CorrectionCodes.KindChanged, RecordedOffset.KindChanged.With(last.Id, job.Name));
                break;
            case ComputedProgram computed:
                Keep(recognized, job, computed);
                break;
            case NothingToSend nothing:
                Record(recognized, nothing);
                break;
            case RefusedComputation { MayPass: true } refused:
                flow.Step(
                    recognized,
                    CorrectionState.Failed,
                    refused.Reason,
                    c => c with { Code = refused.Code, Reason = refused.Reason, Identity = null });
                break;
            case RefusedComputation refused:
                Refuse(recognized, refused.Code, refused.Reason);
                break;
            case var other:
                throw new InvalidOperationException($"A computation came to {other.GetType().Name}.");
        }
    }

    private void Record(Correction recognized, NothingToSend nothing) => flow.Step(
        recognized,
        CorrectionState.Recorded,
        nothing.Reason,
        c => c with
        {
            Code = nothing.Code,
            Reason = nothing.Reason,
            ReportSha256 = nothing.Report is { } report ? ContentHash.Sha256(report.Span) : null,
            PageSha256 = nothing.Page is { } page ? ContentHash.Sha256(page.Span) : null,
        },
        [.. new[] { nothing.Report, nothing.Page }.OfType<ReadOnlyMemory<byte>>()],
        nothing.IsPageOfReport);

    private void Keep(Correction recognized, CellJobSettings job, ComputedProgram computed)
    {
        // Plain null would become empty content: a byte array converts to memory, and a null array to empty memory.
        var sums = job.Accumulates ? computed.Sums.ToJson() : default(ReadOnlyMemory<byte>?);
        var basis = computed.LargestMm > 0
            ? Recorded.DisplacedAt.With(computed.LargestMm, computed.LargestAt)
            : Recorded.DisplacedNothing.With();
        flow.Step(
            recognized,
            CorrectionState.Computed,
            Statement.InARow([.. computed.Offset?.Parts ?? [], basis, .. computed.Warnings]),
            c => c with
            {
                ProgramSha256 = ContentHash.Sha256(computed.Program.Span),
                Offset = computed.Offset,
                UndoSha256 = computed.Undo is { } undo ? ContentHash.Sha256(undo.Span) : null,
                ReportSha256 = ContentHash.Sha256(computed.Report.Span),
                PageSha256 = ContentHash.Sha256(computed.Page.Span),
                LargestMm = computed.LargestMm,
                SumMm = computed.SumMm,
                SumsSha256 = sums is { } kept ? ContentHash.Sha256(kept.Span) : null,
            },
            [computed.Program, computed.Report, computed.Page, .. new[] { sums, computed.Undo }.OfType<ReadOnlyMemory<byte>>()],
            computed.IsPageOfReport);
    }

    // Its identity becomes free: the refused measurement may come again once the reason is gone.
    private void Refuse(Correction recognized, string code, Statement reason) =>
        flow.Step(recognized, CorrectionState.Refused, reason, c => c with { Code = code, Reason = reason, Identity = null });
}
