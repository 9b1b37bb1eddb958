using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>Determines whose measurement an archived file is and what its correction is based on, and refuses repeated
/// measurements.</summary>
internal sealed class RecognizeWorker(CellFlow flow)
{
    private const int Most = 100;
    private readonly Recognizer _recognizer = new(flow.Settings);
    private readonly CorrectionComputer _computer = new(flow.Settings.Policy);

    /// <summary>Recognizes archived files, in order of arrival.</summary>
    /// <returns>How long to wait before looking again.</returns>
    public Task<TimeSpan> WorkAsync(CancellationToken stop)
    {
        var next = flow.Store.Corrections.First(CorrectionState.Archived, Most, gauges: flow.Gauges);
        foreach (var archived in next)
        {
            if (stop.IsCancellationRequested)
            {
                break;
            }

            using var activity = CellTelemetry.Start("recognize", archived);
            flow.FailingAlone(archived, () => Recognize(archived));
        }

        return Task.FromResult(next.Count < Most ? flow.Idle : TimeSpan.Zero);
    }

    private void Recognize(Correction archived)
    {
        var bytes = flow.Store.Content(archived.MeasurementSha256);
        var found = _recognizer.Recognize(archived.Gauge, archived.FileName, bytes);
        if (found.Job is not { } job)
        {
            Refuse(archived, archived, found.Code!, found.Reason!);
            return;
        }

        var slot = flow.Settings.Machines.First(m => m.Name == job.Machine).Slots.First(s => s.Name == job.Slot);
        var known = archived with
        {
            Job = job.Name,
            Piece = found.Piece,
            Serial = found.Serial,
            WorkOrder = found.WorkOrder,
            Machine = job.Machine,
            Slot = job.Slot,
            Program = slot.Program
        };
        var before = Before(known);
        var cut = !job.Accumulates || known.Piece is not (PieceWords.Counterpart or PieceWords.Surface)
            ? new(null, null)
            : before is { SumsSha256: not null }
            ? new(CutProgram.Before(flow.Store, before), null)
            : CutProgram.Of(flow.Store, known);
        var cutBy = cut.By;
        var part = known.Piece != PieceWords.Counterpart ? null : PartOf(before) ?? LastCut(known, job) ?? LastPart(known, job);
        known = known with { BaseSha256 = cutBy?.ProgramSha256, SumsSha256 = cutBy?.SumsSha256, PartSha256 = part?.MeasurementSha256 };
        if (Earlier(known, job) is { } earlier)
        {
            Refuse(archived, known, CellCodes.AlreadyKnown, AlreadyKnown(earlier));
            return;
        }

        if (cut.Undecided is not null)
        {
            Refuse(archived, known, CellCodes.NotReleased, cut.Reason);
            return;
        }

        if (cutBy is { SumsSha256: null })
        {
            Refuse(archived, known, CellCodes.SumsUnknown, Recorded.SumsUnknown.With(cutBy.Id, job.Name));
            return;
        }

        switch (_computer.Identify(CorrectionRequests.Of(flow, known, job, bytes)))
        {
            case Identified { Basis: var basis }:
                Begin(archived, known, basis, cutBy, part);
                break;
            case RefusedComputation { Code: CorrectionCodes.PartUnmeasured } when Named(known) is { } piece:
                Refuse(archived, known, CorrectionCodes.PartUnmeasured, Recorded.PartOfNumberUnmeasured.With(piece, piece, known.FileName));
                break;
            case RefusedComputation refused:
                Refuse(archived, known, refused.Code, refused.Reason);
                break;
            case var other:
                throw new InvalidOperationException($"A measurement that is not computed yet came to {other.GetType().Name}.");
        }
    }

    private void Begin(Correction archived, Correction known, CorrectionBasis basis, Correction? cutBy, Correction? part)
    {
        var words = (cutBy, part) switch
        {
            ({ } cut, { } other) => Recorded.OfCutAndPart.With(known.Piece, known.Job, cut.Id, other.Id),
            ({ } cut, null) => Recorded.OfCut.With(known.Piece, known.Job, cut.Id),
            (null, { } other) => Recorded.OfPart.With(known.Piece, known.Job, other.Id),
            _ => Recorded.Of.With(known.Piece, known.Job),
        };
        try
        {
            flow.Step(
                archived,
                CorrectionState.Recognized,
                words,
                _ => known with
                {
                    Identity = basis.Identity,
                    JobSha256 = basis.JobSha256,
                    JobWorkOrder = basis.WorkOrder,
                    BaseSha256 = basis.BaseSha256
                },
                [basis.Job, .. basis.Base is { } program ? new[] { program } : []]);
        }
        catch (DuplicateCorrectionException e)
        {
            Refuse(archived, known, CellCodes.AlreadyKnown, AlreadyKnown(flow.Store.Find(e.Existing)!));
        }
    }

    // A recalculated measurement is of the same piece as before: it is compared with the same part and was cut by the same program,
    // whatever has been measured since. Null if it arrived from its gauge, or is now recognized as another piece.
    private Correction? Before(Correction known) =>
        known.MeasuredAs is { } id && flow.Store.Find(id) is { } first && first.Job == known.Job && first.Piece == known.Piece
            ? first
            : null;

    private Correction? PartOf(Correction? counterpart) =>
        counterpart?.PartSha256 is { } part
            ? flow.Store.Corrections.OfMeasurement(part).LastOrDefault(c => c.Piece == PieceWords.Part)
            : null;

    // If corrections accumulate, each has another base program and so another identity. The same file is still the same measurement, and
    // must not be added twice.
    private Correction? Earlier(Correction known, CellJobSettings job) =>
        !job.Accumulates ? null : flow.Store.Corrections.OfMeasurement(known.MeasurementSha256)
        .FirstOrDefault(c => c.Id != known.Id && c.Job == known.Job && c.Piece == known.Piece && c.Identity is not null);

    // The part whose program cut it, if parts make programs. A value that either of the two lacks may be anything.
    private Correction? LastCut(Correction counterpart, CellJobSettings job) => flow.Settings.Jobs.Where(j => j.File == job.File)
        .Select(j => flow.Store.Corrections.LastSent(j.Name, counterpart.Serial)).OfType<Correction>()
            .Where(c => c.Piece == PieceWords.Part
                && (counterpart.WorkOrder is null || c.WorkOrder is null || c.WorkOrder == counterpart.WorkOrder))
            .MaxBy(c => c.Id);

    // A configuration may name the same job file twice, once for each piece.
    private Correction? LastPart(Correction counterpart, CellJobSettings job) => flow.Settings.Jobs.Where(j => j.File == job.File)
        .Select(j => flow.Store.Corrections.LastPart(j.Name, counterpart.Serial, counterpart.WorkOrder))
        .OfType<Correction>().MaxBy(c => c.Turn);

    private static Statement? Named(Correction piece) => (piece.Serial, piece.WorkOrder) switch
    {
        ({ } serial, { } order) => Recorded.NamedBoth.With(serial, order),
        ({ } serial, null) => Recorded.NamedSerial.With(serial),
        (null, { } order) => Recorded.NamedOrder.With(order),
        _ => null,
    };

    private static Statement AlreadyKnown(Correction other) =>
        Recorded.AlreadyKnown.With(other.Id, other.FileName, other.State.ToString().ToLowerInvariant());

    private void Refuse(Correction archived, Correction known, string code, Statement reason) =>
        flow.Step(archived, CorrectionState.Refused, reason, _ =>
            known with { Code = code, Reason = reason, BaseSha256 = null, PartSha256 = null, SumsSha256 = null });
}
