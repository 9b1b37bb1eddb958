using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>Finds the smallest kind of correction that suffices: the tool's radius, the work offset, or blocks.</summary>
/// <remarks>An offset suffices if the error that is expected of it, over all that may have moved the boundary (<see cref="Causes"/>), is
/// above that of the best way by no more than a tenth or what the job allows, both as a root mean square and at the worst place (method,
/// section 13). Likeness to blocks is no yardstick: blocks copy the noise of the gauge, and leave features within their limits where they
/// are. An offset must not drive a measured point out of its limits that blocks leave within.</remarks>
internal sealed class OffsetChooser
{
    // What may be lost for a smaller change.
    private const double ShareOfError = 0.1;

    private const int RotationDecimals = 6;

    private readonly MatingJob _job;
    private readonly NcPath _path;
    private readonly IReadOnlyList<FeatureMap> _maps;
    private readonly OffsetTotals? _before;
    private readonly string _file;
    private readonly Marker _marker;
    private readonly IReadOnlyList<ComparedPlace> _places;
    private readonly double[] _now;
    private readonly double[] _byBlocks;
    private readonly double[] _way;
    private readonly Causes _causes;
    private readonly bool _canBeBlocks;

    // Of a boundary that is right, where blocks cannot follow.
    private readonly ExpectedError _ofBlocks;
    private readonly List<KindRefused> _refused = [];
    private readonly OffsetUse _use;

    /// <summary>Prepares the choice.</summary>
    /// <param name="job">The job; it allows an offset.</param>
    /// <param name="path">The program before.</param>
    /// <param name="maps">The features on it.</param>
    /// <param name="decision">The decisions on them.</param>
    /// <param name="piece">The estimate of the measured piece.</param>
    /// <param name="blocks">The program corrected by blocks; null if that is not possible, and then the boundary should be right.</param>
    /// <param name="before">The corrections by offsets with which the measured counterpart was cut; null in feed-forward, which starts
    /// from none.</param>
    /// <param name="file">Name of the file that the program of the offsets gets.</param>
    /// <param name="marker">The comment in the program of the offsets that names its sources.</param>
    public OffsetChooser(
        MatingJob job,
        NcPath path,
        IReadOnlyList<FeatureMap> maps,
        MatingDecision decision,
        PieceEstimate piece,
        NcPath? blocks,
        OffsetTotals? before,
        string file,
        Marker marker)
    {
        (_job, _path, _maps, _before, _file, _marker, _use) = (job, path, maps, before, file, marker, new(job.Correction, path, maps));
        _places = piece.Places();
        var (was, by) = (Cuts(r => r.Run.On(path)), blocks is null ? null : Cuts(r => r.Run.On(blocks)));
        _now = [.. _places.Select(p => p.ErrorOn(was(p.Run)))];
        _byBlocks = [
            .. _places.Select((p, k) => by is not null ? p.ErrorOn(by(p.Run))
                : decision.Features[p.Feature].Decision == Decision.Compensated ? 0 : _now[k])];
        _way = [
            .. _places.Select((p, k) => decision.Features[p.Feature].Decision != Decision.Compensated ? -_now[k]
                : job.Compensation.Amount == CompensationAmount.Whole ? -job.Compensation.Gain * _now[k]
                : _byBlocks[k] - _now[k])];
        _causes = new(_places, _way, decision.Features[0].StandardUncertaintyMm);
        (_canBeBlocks, _ofBlocks) = (blocks is not null, Expected(_byBlocks));
    }

    /// <summary>The cuts of each run by the chosen offset; null if none is chosen.</summary>
    public Func<RunEstimate, RunPath>? Chosen { get; private set; }

    /// <summary>Chooses.</summary>
    /// <param name="compensates">False if nothing is compensated.</param>
    public CorrectionChoice Choose(bool compensates)
    {
        if (!compensates)
        {
            return Made(null, null, null, null);
        }

        return Radius(_use.NotByRadius) ?? Work(_use.NotByWorkOffset) ?? Made(CorrectionKind.Blocks, null, null, null);
    }

    private CorrectionChoice? Radius(string? reason)
    {
        if (!_job.Correction.Allows(CorrectionKind.ToolWear))
        {
            return null;
        }

        if (reason is not null)
        {
            return Refuse(CorrectionKind.ToolWear, reason);
        }

        OffsetTry? best = null;
        foreach (var fitted in Fitted(_ => [1]))
        {
            var step = Rounded(fitted[0], _path.Dialect.MetricDecimals);
            if (step == 0)
            {
                continue;
            }

            var total = (_before?.RadiusMm ?? 0) + step;
            if (BeyondLimits((step, total)) is { } beyond)
            {
                return Refuse(CorrectionKind.ToolWear, beyond);
            }

            if (Beside((double)step, out var cuts) is { } stop)
            {
                return Refuse(CorrectionKind.ToolWear, stop);
            }

            best = Better(best, Tried(cuts, total, default));
        }

        if (best is null || !Suffices(best))
        {
            return Refuse(CorrectionKind.ToolWear, TooFar(best));
        }

        Chosen = best.Cuts;
        return Made(CorrectionKind.ToolWear, best.RadiusMm, null, best);
    }

    private CorrectionChoice? Work(string? reason)
    {
        if (!_job.Correction.Allows(CorrectionKind.WorkOffset))
        {
            return null;
        }

        if (reason is not null)
        {
            return Refuse(CorrectionKind.WorkOffset, reason);
        }

        OffsetTry? best = null;
        var turns = _use.NotByTurn;
        var middle = new Point2(_places.Average(p => p.Place.X), _places.Average(p => p.Place.Y));
        foreach (var isTurned in turns is null ? [false, true] : (bool[])[false])
        {
            foreach (var fitted in Fitted(isTurned ? p => Turned(p, middle) : Shifted))
            {
                var degrees = isTurned ? Rounded(fitted[2] * 180 / Math.PI, RotationDecimals) : 0;
                var shift = ShiftAbout(middle, new(fitted[0], fitted[1]), (double)degrees);
                var step = new OffsetShift(
                    Rounded(shift.X, _path.Dialect.MetricDecimals), Rounded(shift.Y, _path.Dialect.MetricDecimals), degrees);
                if (step == default)
                {
                    continue;
                }

                var before = _before?.Work ?? default;
                var total = new OffsetShift(
                    before.XMm + step.XMm, before.YMm + step.YMm, before.RotationDegrees + step.RotationDegrees);
                var move = OffsetFit.Move((double)step.XMm, (double)step.YMm, (double)step.RotationDegrees);
                best = Better(best, Tried(Cuts(r => r.Run.On(_path).Moved(move)), 0, total) with
                {
                    Beyond = BeyondLimits((step.XMm, total.XMm), (step.YMm, total.YMm)) ?? BeyondTurn(step, total)
                });
            }

            // Without a turn, if that is enough.
            if (best is not null && Suffices(best))
            {
                break;
            }
        }

        if (best is null || !Suffices(best))
        {
            return Refuse(CorrectionKind.WorkOffset, turns is null ? TooFar(best) : $"{TooFar(best)}; {turns}");
        }

        if (best.Beyond is { } tooMuch)
        {
            return Refuse(CorrectionKind.WorkOffset, tooMuch);
        }

        Chosen = best.Cuts;
        return Made(CorrectionKind.WorkOffset, null, best.Work, best);
    }

    private static double[] Shifted(ComparedPlace place) => [place.Normal.X, place.Normal.Y];

    // A small turn moves a place at right angles to its way from the middle: about the far origin, turn and shift would hardly differ.
    private static double[] Turned(ComparedPlace place, Point2 middle) =>
        [place.Normal.X, place.Normal.Y, place.Normal.Dot((place.Place - middle).Left)];

    // The shift after a turn about the origin that does what a turn about a place and a shift do.
    private static Vector2 ShiftAbout(Point2 place, Vector2 shift, double degrees) =>
        shift + (place - OffsetFit.Move(0, 0, degrees).Apply(place));

    // By what the noise of the key points asks for, and by the least largest error.
    private IEnumerable<double[]> Fitted(Func<ComparedPlace, double[]> row)
    {
        double[][] rows = [.. _places.Select(row)];
        yield return OffsetFit.LeastSquares(rows, _way, [.. _places.Select(p => p.Point >= 0 ? 1.0 : 0)]);
        yield return OffsetFit.LeastLargest(rows, _way);
    }

    private OffsetTry Tried(Func<RunEstimate, RunPath> cuts, decimal radiusMm, OffsetShift work)
    {
        double[] errors = [.. _places.Select(p => p.ErrorOn(cuts(p.Run)))];
        return new(
            cuts,
            radiusMm,
            work,
            Expected(errors),
            errors.Select((e, k) => Math.Min(Math.Abs(e - _byBlocks[k]), Math.Abs(e))).Max(),
            Enumerable.Range(0, errors.Length).Any(k => IsDrivenOut(_places[k], _byBlocks[k], errors[k])));
    }

    private static OffsetTry Better(OffsetTry? one, OffsetTry other) =>
        one is null || (one.DrivesOut, one.Expected.LargestMm).CompareTo((other.DrivesOut, other.Expected.LargestMm)) > 0 ? other : one;

    private ExpectedError Expected(double[] errors) => _causes.Of([.. errors.Zip(_now, (e, n) => e - n)]);

    private bool Suffices(OffsetTry tried) => !tried.DrivesOut
        && IsNearly(tried.Expected.RmsMm, _ofBlocks.RmsMm)
        && IsNearly(tried.Expected.LargestMm, _ofBlocks.LargestMm);

    private bool IsNearly(double error, double ofBlocks) =>
        error <= ofBlocks + Math.Max(ShareOfError * ofBlocks, _job.Correction.WithinMm) + 1e-9;

    // Noise or not: what blocks would leave within its limits must not end up outside of them. Limits without width say nothing.
    private bool IsDrivenOut(ComparedPlace place, double byBlocks, double byOffset) =>
        LimitsOf(place) is { WidthMm: > 0 } limits && limits.Contains(byBlocks) && !limits.Contains(byOffset);

    // The limits of the mating error at a place.
    private ToleranceBand LimitsOf(ComparedPlace place) => _maps[place.Feature].Feature.Tolerance.Band.Opposite();

    // The boundary beside the programmed one by a distance, and whether the control still follows it with the tool.
    private string? Beside(double distance, out Func<RunEstimate, RunPath> cuts)
    {
        cuts = r => r.Run.On(_path);
        var tool = CompensatedPath.Of(_path, ToolRadii.Of((_job.Counterpart.ToolDiameterMm / 2) + distance));
        var boundary = CompensatedPath.Of(_path, ToolRadii.Of(distance));
        if ((tool.Refusal ?? boundary.Refusal) is { } refusal)
        {
            return $"the path of the tool's center cannot be followed with it: {refusal.Message}";
        }

        var found = new Dictionary<RunEstimate, RunPath>(ReferenceEqualityComparer.Instance);
        foreach (var run in _places.Select(p => p.Run).Distinct())
        {
            if (RunPath.Beside(boundary, run.Run.First, run.Run.Last) is not { } beside)
            {
                return "the path of the tool's center cannot be followed with it";
            }

            found.Add(run, beside);
        }

        cuts = r => found[r];
        return null;
    }

    private string? BeyondLimits(params ReadOnlySpan<(decimal Step, decimal Total)> changes)
    {
        var limits = _job.Correction.Limits;
        foreach (var (step, total) in changes)
        {
            if (Math.Abs(step) > limits.StepMm || Math.Abs(total) > limits.TotalMm)
            {
                return string.Create(
                    CultureInfo.InvariantCulture,
                    $"a step of {step:0.0000} mm to {total:0.0000} mm in all is beyond {limits.StepMm} and {limits.TotalMm} mm");
            }
        }

        return null;
    }

    private string? BeyondTurn(OffsetShift step, OffsetShift total)
    {
        var limits = _job.Correction.Limits;
        return Math.Abs(step.RotationDegrees) > limits.StepDegrees || Math.Abs(total.RotationDegrees) > limits.TotalDegrees
            ? string.Create(
                CultureInfo.InvariantCulture,
                $"a turn of {step.RotationDegrees:0.0000} to {total.RotationDegrees:0.0000} degrees in all is beyond "
                    + $"{limits.StepDegrees} and {limits.TotalDegrees} degrees")
            : null;
    }

    private string TooFar(OffsetTry? tried) => tried is null
        ? "what it could correct is below its increment"
        : string.Create(
            CultureInfo.InvariantCulture,
            $"the boundary would be up to {tried.DifferenceMm:0.0000} mm from where blocks bring it, and an error of "
                + $"{tried.Expected.RmsMm:0.0000} mm (rms) is expected instead of {_ofBlocks.RmsMm:0.0000}");

    private CorrectionChoice? Refuse(CorrectionKind kind, string reason)
    {
        _refused.Add(new(kind, reason));
        return null;
    }

    // Offsets that are not needed are set to what they were (in feedback) or to nothing (in feed-forward, which starts from there).
    private CorrectionChoice Made(CorrectionKind? kind, decimal? radiusTotal, OffsetShift? workTotal, OffsetTry? tried)
    {
        var job = _job.Correction;
        var radius = job.Allows(CorrectionKind.ToolWear) && _use.RadiusNumber is { } d
            ? new RadiusCorrection(d, job.Tool ?? 0, radiusTotal ?? _before?.RadiusMm ?? 0, _before?.RadiusMm)
            : null;
        var work = job.Allows(CorrectionKind.WorkOffset) && _use.WorkOffsetNumber is { } w
            ? new WorkOffsetCorrection(w, workTotal ?? _before?.Work ?? default, _before?.Work)
            : null;
        return new(
            kind,
            radius,
            work,
            tried?.DifferenceMm ?? 0,
            _refused,
            Program(radius, work))
        {
            Expected = tried?.Expected,
            ExpectedByBlocks = tried is null || !_canBeBlocks ? null : _ofBlocks,

            // Back to the offsets before, which in feed-forward are none, whatever the control has of the piece before.
            Undo = Program(
                radius is { BeforeMm: { } radiusBefore } ? radius with { TotalMm = radiusBefore, BeforeMm = radius.TotalMm }
                    : radius is null ? null : radius with { TotalMm = 0 },
                work is { Before: { } workBefore } ? work with { Total = workBefore, Before = work.Total }
                    : work is null ? null : work with { Total = default }),
        };
    }

    private byte[]? Program(RadiusCorrection? radius, WorkOffsetCorrection? work) => radius is null && work is null
        ? null
        : _marker.InsertInto(NcProgram.Read(
            OffsetProgram.Write(
                _path.Dialect,
                radius,
                work,
                _job.Correction.Limits,
                _job.Correction.FirstVariable,
                _job.Correction.ProgramNumber,
                _file),
            _path.Dialect.Syntax));

    private static Func<RunEstimate, RunPath> Cuts(Func<RunEstimate, RunPath> of)
    {
        var made = new Dictionary<RunEstimate, RunPath>(ReferenceEqualityComparer.Instance);
        return run => made.TryGetValue(run, out var cuts) ? cuts : made[run] = of(run);
    }

    private static decimal Rounded(double value, int decimals) =>
        Math.Abs(value) < 1000 ? Math.Round((decimal)value, decimals, MidpointRounding.AwayFromZero) : 1000;

    // An offset that was tried. DrivesOut: a measured point leaves its limits that blocks keep within. Beyond: why it is too large.
    private sealed record OffsetTry(
        Func<RunEstimate, RunPath> Cuts, decimal RadiusMm, OffsetShift Work, ExpectedError Expected, double DifferenceMm, bool DrivesOut)
    {
        public string? Beyond { get; init; }
    }
}
