using ErrorMatching.Jobs;
using ErrorMatching.Json;
using ErrorMatching.Mating;
using ErrorMatching.Nc;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Cell;

/// <summary>A correction of a mating. The counterpart's program results from the part's measurement, or in feedback from the counterpart's
/// own.</summary>
internal sealed class MatingCorrection
{
    // The stored report lists all.
    private const int MostNamed = 6;

    private readonly CorrectionRequest _request;
    private readonly PolicySettings _policy;
    private readonly byte[] _job;
    private readonly JobFiles _files;

    /// <summary>Reads the job.</summary>
    /// <param name="request">What is computed from it.</param>
    /// <param name="policy">The policy that applies to it.</param>
    /// <param name="job">The bytes of the job's file.</param>
    /// <exception cref="InputException">The job cannot be used.</exception>
    public MatingCorrection(CorrectionRequest request, PolicySettings policy, byte[] job) =>
        (_request, _policy, _job, _files) = (request, policy, job, new(MatingJob.Parse(job, request.Job.File)));

    private bool IsFeedback => _files.Job.Compensation.From == CompensationSource.Counterpart;

    private bool IsOfPart => _request.Piece == PieceWords.Part;

    // The piece whose measurement makes the program: the part in feed-forward, the counterpart itself in feedback. The other piece is
    // evidence.
    private bool MakesProgram => IsOfPart != IsFeedback;

    // With offsets alone, the program stays the original one, whatever the slot held when the piece was cut.
    private bool IsByOffset => !_files.Job.Correction.Allows(CorrectionKind.Blocks);

    private GivenFile Base => new(_files.Job.PathOf(_files.Job.Counterpart.Program), IsByOffset ? null : _request.Base);

    /// <summary>Determines the correction's inputs.</summary>
    public Computation Identify()
    {
        if (Refusal() is { } refusal)
        {
            return refusal;
        }

        var (theoretical, program, dialect) = (_files.Theoretical(), _files.Program(Base).Bytes, _files.OwnDialect());
        return new Identified(Basis(
            [
                new("theoretical", theoretical.File, theoretical.Sha256),
                .. Called(program, dialect).Select(c => new ReportInput("called", c.Name, c.Sha256)),
                .. dialect?.Files.Select(f => new ReportInput("dialect", f.File, f.Sha256)) ?? []],
            _request.Base ?? program));
    }

    // What the program calls is known only when it runs.
    private IReadOnlyList<CalledProgram> Called(ReadOnlyMemory<byte> program, NcDialect? dialect) => NcInterpreter.Run(
        NcProgram.Read(program), _files.Job.Counterpart.DialectOf(dialect), _files.Called().Find, CancellationToken.None).CalledPrograms;

    /// <summary>Computes it.</summary>
    public Computation Compute(CancellationToken cancellation)
    {
        if (Refusal() is { } refusal)
        {
            return refusal;
        }

        return MakesProgram ? Match(cancellation) : Record();
    }

    private RefusedComputation? Refusal()
    {
        if (_request.Job.Accumulates && !IsFeedback)
        {
            return new(CorrectionCodes.NotFeedback, Recorded.NotFeedback.With(_request.Job.Name));
        }

        return MakesProgram && IsFeedback && _request.Part is null
            ? new(CorrectionCodes.PartUnmeasured, Recorded.PartUnmeasured.With(_request.Measurement.Name))
            : null;
    }

    private NothingToSend Record()
    {
        var given = new GivenFile(_request.Measurement.Name, _request.Measurement.Bytes);
        var measured = IsOfPart ? _files.Part(given) : _files.Counterpart(given, part: null);
        measured.Require(_files.Job.NeededPoints);
        var basis = ((Identified)Identify()).Basis;
        return IsOfPart
            ? new NothingToSend(basis, CorrectionCodes.PartRecorded, Recorded.PartRecorded.With())
            : CounterpartVerification.Of(_files, _request.Part, measured) switch
            {
                { Report: { } report } => Verified(basis, report),
                var none => new(basis, CorrectionCodes.FirstArticle, Statement.InARow(Recorded.FirstArticle.With(), none.Otherwise)),
            };
    }

    // A list without words, which need no translation.
    private static string Labels(IReadOnlyList<string> points) =>
        string.Join(", ", points.Take(MostNamed)) + (points.Count > MostNamed ? " …" : "");

    private static NothingToSend Verified(CorrectionBasis basis, VerifyReport report)
    {
        var json = VerifyReportJson.Write(report);
        var page = ReportPages.Of(json);
        Statement[] verdict = report.Verdict switch
        {
            { Code: VerifyCode.Outside } v =>
                [Recorded.VerifiedOutside.With(v.Outside.Count, v.Points, Labels(v.Outside))],
            { Code: VerifyCode.Within } v => [Recorded.VerifiedWithin.With(v.Within, v.Points)],
            _ => [],
        };
        return new(basis, CorrectionCodes.FirstArticle, Statement.InARow([Recorded.FirstArticle.With(), .. verdict]))
        {
            Report = json,
            Page = page ?? VerifyReportHtml.Write(report),
            IsPageOfReport = page is not null,
        };
    }

    private Computation Match(CancellationToken cancellation)
    {
        var measured = new GivenFile(_request.Measurement.Name, _request.Measurement.Bytes);
        var outcome = MatingRun.Run(
            _files,
            new()
            {
                Part = IsFeedback ? new(_request.Part!.Name, _request.Part.Bytes) : measured,
                Counterpart = IsFeedback ? measured : null,
                Program = Base,
                Previous = IsFeedback && _request.Previous is { } previous ? new(previous.Name, previous.Bytes) : null,
                ToolChanged = IsFeedback && _request is { Previous: not null, ToolChanged: true },
                MayBeginAnew = true,
                Gain = _policy.Gain,
                OffsetsFile = _request.SlotProgram,
            },
            cancellation);
        if (outcome.Result is not { } matched)
        {
            return CorrectionComputer.Refused(outcome.Refusals);
        }

        var offset = IsByOffset ? matched.Match.Correction : null;
        if (IsByOffset && offset is not { Program: not null, Undo: not null })
        {
            return new RefusedComputation(CorrectionCodes.OffsetNotWritten, RecordedOffset.NotWritten.With(_request.Job.Name));
        }

        var steps = Steps(matched);
        var sums = _request.Sums.Plus(steps);
        var (mm, at, block) = LargestMove.Of(matched);
        var limits = new DisplacementLimits(_policy, _files.Job.Compensation.LimitMm);
        if (limits.OfStep(mm, at, block) is { } overStep)
        {
            return overStep;
        }

        if (SinceOriginal(matched, sums, (mm, at, block)) is not { } sum)
        {
            return new RefusedComputation(CorrectionCodes.JobChanged, Recorded.OriginalChanged.With(_files.Job.Counterpart.Program));
        }

        // The page shows the numbers of the recorded report, with its decimals: so the store can draw it again.
        var json = matched.ReportJson();
        var page = ReportPages.Of(json);
        return (_request.Job.Accumulates ? limits.OfSum(sum.Mm, sum.At, sum.Block) : null) ?? (Computation)new ComputedProgram
        {
            Basis = Basis(matched.Report.Inputs, _request.Base ?? matched.Match.Input.Program),
            ProgramName = matched.Name,
            Program = offset?.Program ?? matched.Program,
            Offset = offset is null ? null : RecordedOffset.Of(offset),
            Undo = offset is { Undo: { } undo } ? undo : default(ReadOnlyMemory<byte>?),
            Report = json,
            Page = page ?? matched.ReportHtml(),
            IsPageOfReport = page is not null,
            LargestMm = mm,
            LargestAt = at,
            Corrections = steps,
            Sums = sums,
            SumMm = sum.Mm,
            ChangedBlocks = matched.Report.Program.ChangedBlocks,
            ChangedWords = matched.Report.Program.ChangedWords,
            Warnings = [.. matched.Report.Warnings.Select(WarningForms.StatementOf)],
        };
    }

    private CorrectionBasis Basis(IReadOnlyList<ReportInput> inputs, ReadOnlyMemory<byte> program)
    {
        var baseSha256 = ContentHash.Sha256(program.Span);
        string[] measurements = MakesProgram && IsFeedback
            ? [_request.Measurement.Sha256, _request.Part!.Sha256, .. _request.Previous is { } p ? [p.Sha256] : Array.Empty<string>()]
            : [_request.Measurement.Sha256];
        return new(
            CorrectionIdentity.Of(measurements, CorrectionIdentity.OfJob(_files.Job.Sha256, inputs), baseSha256, _policy.Gain),
            _files.Job.Sha256,
            _job,
            baseSha256,
            program,
            _files.Job.WorkOrder);
    }

    // Corrections below half an increment change no word, and what is not in the program is not added to a sum.
    private static IReadOnlyList<PointCorrection> Steps(MatchedProgram matched) => matched.Match.Correction is { IsOffset: true } offset
        ? OffsetMove.AtPoints(matched.Match, offset.StepRadiusMm, offset.StepMove)
        : [
            .. matched.Report.KeyPoints.Select(
                p => matched.Match.Rewrite is null
                    ? new PointCorrection(p.Point, 0, 0, 0)
                    : new(p.Point, p.Correction.X, p.Correction.Y, 0))];

    // The largest distance from the original program: of the sums at the points, or between or next to them as measured on the program
    // itself. Null if the two programs cannot be compared.
    private (double Mm, Statement At, string? Block)? SinceOriginal(
        MatchedProgram matched, CorrectionSums sums, (double Mm, Statement At, string? Block) step)
    {
        if (!_request.Job.Accumulates || _request.Base is null)
        {
            return step;
        }

        var match = matched.Match;
        if (IsByOffset && match.Correction is { } offset)
        {
            var all = OffsetMove.Largest(match, offset.TotalRadiusMm, offset.TotalMove);
            return (all.Mm, all.At, all.Block);
        }

        if (DistanceFromOriginal.Largest(
            (match.Input with { Program = _files.Program(null).Bytes }).Interpret(), match.After, match.Maps) is not { } elsewhere)
        {
            return null;
        }

        (double Mm, Statement At) atPoints =
            sums.Largest is { } largest ? (largest.LengthMm, Recorded.AtPoint.With(largest.Point)) : (0, "");
        if (elsewhere.Mm <= atPoints.Mm + match.LeastIncrementMm)
        {
            return (atPoints.Mm, atPoints.At, null);
        }

        var name = match.After.Program.NameOf(match.After.Program[elsewhere.Block]);
        return (elsewhere.Mm, Recorded.AtBlock.With(name), name);
    }
}
