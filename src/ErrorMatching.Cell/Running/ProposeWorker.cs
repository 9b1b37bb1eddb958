using ErrorMatching.Mating;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Proposes computed corrections, supersedes older ones of the same piece, and approves by the policy.</summary>
internal sealed class ProposeWorker(CellFlow flow)
{
    private const int Most = 100;
    private const int MostOfOneSerial = 1000;
    private bool _hasLookedBack;

    /// <summary>Processes all pending work.</summary>
    /// <returns>How long to wait before looking again.</returns>
    public Task<TimeSpan> WorkAsync(CancellationToken stop)
    {
        if (!_hasLookedBack)
        {
            // Automatic approvals are left over if the cell ended between the two steps, or if the policy changed.
            foreach (var proposed in flow.Store.Corrections.First(CorrectionState.Proposed, int.MaxValue, jobs: flow.Jobs))
            {
                try
                {
                    ApproveByPolicy(proposed, IsToCut(proposed));
                }
                catch (StoreException e) when (e.Error == StoreError.Tampered)
                {
                    flow.ReportTampered(Recorded.Correction.With(proposed.Id), e.Statement);
                }
            }

            _hasLookedBack = true;
        }

        var next = flow.Store.Corrections.First(CorrectionState.Computed, Most, jobs: flow.Jobs);
        foreach (var computed in next)
        {
            if (stop.IsCancellationRequested)
            {
                break;
            }

            using var activity = CellTelemetry.Start("propose", computed);
            try
            {
                Propose(computed);
            }
            catch (StoreException e) when (e.Error == StoreError.Tampered)
            {
                flow.Step(computed, CorrectionState.Refused, e.Statement, c =>
                    c with { Code = CellCodes.Of(e.Error), Reason = e.Statement, Identity = null });
            }
        }

        return Task.FromResult(next.Count < Most ? flow.Idle : TimeSpan.Zero);
    }

    private void Propose(Correction computed)
    {
        if (RevertedBase.Of(flow, computed) is { } reverted)
        {
            flow.Step(
                computed,
                CorrectionState.Refused,
                reverted.Reason,
                c => c with { Code = CellCodes.BaseReverted, Reason = reverted.Reason, Identity = null });
            return;
        }

        var others = OfSamePiece(computed);
        if (others.FirstOrDefault(c => c.Turn > computed.Turn && TakesPlace(c)) is { } newer)
        {
            Supersede(computed, newer);
            return;
        }

        // The older ones first: if the cell ends in between, this one is still in the computed state and is processed again.
        foreach (var older in others.Where(c => c.Turn < computed.Turn && CorrectionSteps.Allows(c.State, CorrectionState.Superseded)))
        {
            Supersede(older, computed);
        }

        var isToCut = IsToCut(computed);
        var basis = isToCut ? Basis(computed) : Statement.InARow(Recorded.NotToCut.With(), Basis(computed));
        ApproveByPolicy(flow.Step(computed, CorrectionState.Proposed, basis), isToCut);
    }

    private void ApproveByPolicy(Correction proposed, bool isToCut)
    {
        // The limits may have become tighter since it was computed: then a person decides.
        if (isToCut && flow.PolicyOf(proposed) is { Automatic: true } policy && IsWithin(proposed, policy))
        {
            flow.Step(
                proposed, CorrectionState.Approved, policy.LimitMm is { } mm ? Recorded.PolicyWithin.With(mm) : Recorded.Policy.With());
        }
    }

    // False if the verdict says not to cut, and nobody is asked anyway. A report without a verdict leaves it to the limits.
    private bool IsToCut(Correction correction)
    {
        if (correction.ReportSha256 is not { } report || flow.PolicyOf(correction) is not { Automatic: true })
        {
            return true;
        }

        var verdict = ReportReader.ObjectOf(flow.Store.Content(report), "verdict");

        // Whether the origin is right, no program can tell.
        return (verdict?.OptionalFlag("cut") ?? verdict?.OptionalFlag("inTolerance")) != false
            && verdict?.OptionalText("code") != ReportWords.Of(VerdictCode.CheckOrigin);
    }

    private static bool IsWithin(Correction proposed, PolicySettings policy) =>
        !(policy.LimitMm is { } limit && !(proposed.LargestMm <= limit))
            && !((policy.SumLimitMm ?? policy.LimitMm) is { } sum && !(proposed.SumMm <= sum));

    private IReadOnlyList<Correction> OfSamePiece(Correction correction) => correction.Serial is not { } serial
        ? []
        : [
            .. flow.Store.Search(new() { Serial = serial, Most = MostOfOneSerial }).Where(
                c => c.Id != correction.Id
                    && c.Job == correction.Job
                    && c.Piece == correction.Piece
                    && c.WorkOrder == correction.WorkOrder)];

    private static bool TakesPlace(Correction newer) => newer.State == CorrectionState.Failed
        ? newer.ProgramSha256 is not null
        : CorrectionSteps.Of(newer.State).NamesProgram && !CorrectionSteps.IsEnd(newer.State);

    private void Supersede(Correction older, Correction newer) => flow.Step(
        older,
        CorrectionState.Superseded,
        Recorded.NewerMeasurement.With(newer.Id, newer.Serial),
        c => c with { Code = CellCodes.Superseded, Reason = Recorded.NewerOfSamePiece.With(newer.Id, newer.FileName) });

    private static Statement Basis(Correction computed) =>
        computed.Offset is { } offset ? Statement.InARow([.. offset.Parts, Millimeters(computed)]) : Millimeters(computed);

    private static Statement Millimeters(Correction computed) => (computed.LargestMm, computed.SumMm) switch
    {
        ({ } largest, { } sum) when sum > largest => Recorded.DisplacedInSum.With(largest, sum),
        ({ } largest, _) => Recorded.Displaced.With(largest),
        _ => Recorded.Computed.With(),
    };
}
