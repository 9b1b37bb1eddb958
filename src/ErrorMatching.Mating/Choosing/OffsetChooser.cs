using System.Globalization;
using ErrorMatching.Geometry;
using ErrorMatching.Nc;

namespace ErrorMatching.Mating;

/// <summary>Finds the smallest kind of correction that suffices: the tool's radius, the work offset, or blocks.</summary>
/// <remarks>An offset suffices if every key point, and the boundary between them, ends up as near to where blocks would bring it as the
/// job asks, or as near to where it should be; between key points, as near as its course is known. It also suffices if what it leaves at
/// the key points cannot be told from the gauge's noise (chi-square of all of them, and the largest of them, each at 5 %) and is nowhere
/// more than a tenth of the tolerance: then the difference is one that blocks would only copy from the noise.</remarks>
internal sealed class OffsetChooser
{
    // Between key points, a course is known no better than this many standard deviations.
    private const double Coverage = 2;

    private const double ErrorRate = 0.05;
    private const double ShareOfTolerance = 0.1;
    private const int RotationDecimals = 6;

    private readonly MatingJob _job;
    private readonly NcPath _path;
    private readonly IReadOnlyList<FeatureMap> _maps;
    private readonly OffsetTotals? _before;
    private readonly string _file;
    private readonly Marker _marker;
    private readonly double _uncertaintyMm;
    private readonly IReadOnlyList<ComparedPlace> _places;
    private readonly double[] _wanted;
    private readonly double[] _now;
    private readonly List<KindRefused> _refused = [];
    private readonly OffsetUse _use;

    /// <summary>Prepares the choice.</summary>
    /// <param name="job">The job; it allows an offset.</param>
    /// <param name="path">The program before.</param>
    /// <param name="maps">The features on it.</param>
    /// <param name="decision">The decisions on them.</param>
    /// <param name="estimator">The estimate, after a prediction.</param>
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
        CourseEstimator estimator,
        NcPath? blocks,
        OffsetTotals? before,
        string file,
        Marker marker)
    {
        (_job, _path, _maps, _before, _file, _marker, _use) = (job, path, maps, before, file, marker, new(job.Correction, path, maps));
        _uncertaintyMm = decision.Features[0].StandardUncertaintyMm;
        _places = estimator.Places();
        var (was, by) = (Cuts(r => r.OnCuts(path)), blocks is null ? null : Cuts(r => r.OnCuts(blocks)));
        _now = [.. _places.Select(p => p.ErrorOn(was(p.Run)))];
        _wanted = [
            .. _places.Select((p, k) => by is not null ? p.ErrorOn(by(p.Run))
                : decision.Features[p.Feature].Decision == Decision.Compensated ? 0 : _now[k])];
    }

    /// <summary>The cuts of each run by the chosen offset; null if none is chosen.</summary>
    public Func<RunEstimate, RunPath>? Chosen { get; private set; }

    /// <summary>Chooses.</summary>
    /// <param name="compensates">False if nothing is compensated.</param>
    public CorrectionChoice Choose(bool compensates)
    {
        if (!compensates)
        {
            return Made(null, null, null, 0, false);
        }

        return Radius(_use.NotByRadius) ?? Work(_use.NotByWorkOffset) ?? Made(CorrectionKind.Blocks, null, null, 0, false);
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

        var best = double.PositiveInfinity;
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

            if (Suffices(cuts, out var difference, out var isNoise))
            {
                Chosen = cuts;
                return Made(CorrectionKind.ToolWear, total, null, difference, isNoise);
            }

            best = Math.Min(best, difference);
        }

        return Refuse(CorrectionKind.ToolWear, TooFar(best));
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

        var best = double.PositiveInfinity;
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
                var cuts = Cuts(r => r.OnCuts(_path).Moved(move));
                var suffices = Suffices(cuts, out var difference, out var isNoise);
                best = Math.Min(best, difference);
                if (!suffices)
                {
                    continue;
                }

                if ((BeyondLimits((step.XMm, total.XMm), (step.YMm, total.YMm)) ?? BeyondTurn(step, total)) is { } beyond)
                {
                    return Refuse(CorrectionKind.WorkOffset, beyond);
                }

                Chosen = cuts;
                return Made(CorrectionKind.WorkOffset, null, total, difference, isNoise);
            }
        }

        return Refuse(CorrectionKind.WorkOffset, turns is null ? TooFar(best) : $"{TooFar(best)}; {turns}");
    }

    private static double[] Shifted(ComparedPlace place) => [place.Normal.X, place.Normal.Y];

    // A small turn moves a place at right angles to its way from the middle: about the far origin, turn and shift would hardly differ.
    private static double[] Turned(ComparedPlace place, Point2 middle) =>
        [place.Normal.X, place.Normal.Y, place.Normal.Dot((place.Place - middle).Left)];

    // The shift after a turn about the origin that does what a turn about a place and a shift do.
    private static Vector2 ShiftAbout(Point2 place, Vector2 shift, double degrees) =>
        shift + (place - OffsetFit.Move(0, 0, degrees).Apply(place));

    // By what the noise of the key points asks for, and by the least largest difference.
    private IEnumerable<double[]> Fitted(Func<ComparedPlace, double[]> row)
    {
        double[] way = [.. _wanted.Zip(_now, (w, n) => w - n)];
        double[][] rows = [.. _places.Select(row)];
        yield return OffsetFit.LeastSquares(rows, way, [.. _places.Select(p => p.Point >= 0 ? 1.0 : 0)]);
        yield return OffsetFit.LeastLargest(rows, way);
    }

    private bool Suffices(Func<RunEstimate, RunPath> cuts, out double differenceMm, out bool isNoise)
    {
        double[] errors = [.. _places.Select(p => p.ErrorOn(cuts(p.Run)))];
        double[] differences = [.. errors.Zip(_wanted, (e, w) => Math.Min(Math.Abs(e - w), Math.Abs(e)))];
        differenceMm = differences.Max();
        isNoise = differences.Where(
            (d, k) => d > Math.Max(_job.Correction.WithinMm, Coverage * _places[k].StandardDeviationMm) + 1e-9).Any();
        return !isNoise || IsNoise(errors, differences);
    }

    private bool IsNoise(double[] errors, double[] differences)
    {
        double[] left = [.. errors.Zip(_wanted, (e, w) => e - w).Where((_, k) => _places[k].Point >= 0)];
        if (_uncertaintyMm <= 0 || left.Length < 2)
        {
            return false;
        }

        var squares = left.Sum(r => r * r) / (_uncertaintyMm * _uncertaintyMm);
        var most = left.Max(Math.Abs) / _uncertaintyMm;
        return ChiSquaredDistribution.Above(squares, left.Length - 1) >= ErrorRate
            && NormalDistribution.Below(-most) >= ErrorRate / (2 * left.Length)
            && !_places.Where((p, k) => differences[k] > ShareOfTolerance * LimitsOf(p).WidthMm || IsDrivenOut(p, _wanted[k], errors[k]))
                .Any();
    }

    // Noise or not: what blocks would leave within its limits must not end up outside of them.
    private bool IsDrivenOut(ComparedPlace place, double byBlocks, double byOffset) =>
        LimitsOf(place) is var limits && limits.Contains(byBlocks) && !limits.Contains(byOffset);

    // The limits of the mating error at a place.
    private ToleranceBand LimitsOf(ComparedPlace place) => _maps[place.Feature].Feature.Tolerance.Band.Opposite();

    // The boundary beside the programmed one by a distance, and whether the control still follows it with the tool.
    private string? Beside(double distance, out Func<RunEstimate, RunPath> cuts)
    {
        cuts = r => r.OnCuts(_path);
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

    private static string TooFar(double differenceMm) => double.IsInfinity(differenceMm)
        ? "what it could correct is below its increment"
        : string.Create(CultureInfo.InvariantCulture, $"the boundary would be up to {differenceMm:0.0000} mm from where blocks bring it");

    private CorrectionChoice? Refuse(CorrectionKind kind, string reason)
    {
        _refused.Add(new(kind, reason));
        return null;
    }

    // Offsets that are not needed are set to what they were (in feedback) or to nothing (in feed-forward, which starts from there).
    private CorrectionChoice Made(CorrectionKind? kind, decimal? radiusTotal, OffsetShift? workTotal, double difference, bool isNoise)
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
            difference,
            isNoise,
            _refused,
            Program(radius, work))
        {
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
}
