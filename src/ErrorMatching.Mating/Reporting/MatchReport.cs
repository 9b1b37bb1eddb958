using ErrorMatching.Geometry;
using ErrorMatching.Reporting;

namespace ErrorMatching.Mating;

/// <summary>The contents of a match report: what was measured, decided, changed and proved. Source of <c>report.json</c> and
/// <c>report.html</c>.</summary>
public sealed record MatchReport
{
    /// <summary>The job.</summary>
    public required ReportJob Job { get; init; }

    /// <summary>The input files.</summary>
    public required IReadOnlyList<ReportInput> Inputs { get; init; }

    /// <summary>The alignment of each measurement: the part's, then the counterpart's if it was used.</summary>
    public required IReadOnlyList<ReportAlignment> Alignments { get; init; }

    /// <summary>The check of the origin; null if the job has none.</summary>
    public OriginCheck? OriginCheck { get; init; }

    /// <summary>The compensation that the job requests.</summary>
    public required JobCompensation Compensation { get; init; }

    /// <summary>The rule by which points are accepted near their limits; null in reports older than decision rules.</summary>
    public DecisionRule? Rule { get; init; }

    /// <summary>The probability that every point of the pair is within its limits without compensation, if their errors are independent;
    /// null if no feature has limits with a width, and in reports older than decision rules.</summary>
    public double? ProbabilityBefore { get; init; }

    /// <summary>The same probability with the program as written; null if no feature has limits with a width, and in reports of earlier
    /// versions.</summary>
    public double? ProbabilityAfter { get; init; }

    /// <summary>What the measured points say about each other; null in reports of earlier versions.</summary>
    public MeasurementTrust? Trust { get; init; }

    /// <summary>Labels of the key points that somebody took out of the job.</summary>
    public IReadOnlyList<string> Without { get; init; } = [];

    /// <summary>The gauge's uncertainty and its contributions.</summary>
    public required UncertaintyBudget Uncertainty { get; init; }

    /// <summary>The tolerance chain; null if the job has none.</summary>
    public ReportChain? Chain { get; init; }

    /// <summary>The features in the order of cutting.</summary>
    public required IReadOnlyList<ReportFeature> Features { get; init; }

    /// <summary>The key points in the order of cutting.</summary>
    public required IReadOnlyList<ReportKeyPoint> KeyPoints { get; init; }

    /// <summary>The key points that the program is predicted to leave outside their limits.</summary>
    public OutsideLimits Outside => OutsideOf(KeyPoints);

    /// <summary>The verdict on the pair.</summary>
    public MatchVerdict Verdict => MatchVerdict.Judge(this);

    /// <summary>What became of a program that the verdict says not to cut.</summary>
    public Acceptance Acceptance { get; init; } = Acceptance.None;

    /// <summary>The part put into the counterpart that the program will cut; null if the outline does not tell, and in reports of earlier
    /// versions.</summary>
    public PairAssembly? Pair { get; init; }

    /// <summary>The program that was written.</summary>
    public required ReportProgram Program { get; init; }

    /// <summary>The proof of that program.</summary>
    public required ReportProof Proof { get; init; }

    /// <summary>The times.</summary>
    public required ReportTime Time { get; init; }

    /// <summary>The tool-radius wear value equivalent to the whole correction (<see cref="UniformOffset"/>), or null.</summary>
    public double? RadiusWearMm { get; init; }

    /// <summary>By what the correction is made; null if the job allows blocks alone, and in older reports.</summary>
    public ReportCorrection? Correction { get; init; }

    /// <summary>In feedback, the counterparts measured so far, for the next match; null in feed-forward and in older reports.</summary>
    public CounterpartLot? Lot { get; init; }

    /// <summary>Warnings to read before using the program, in sentences.</summary>
    public IReadOnlyList<ReportWarning> Warnings { get; init; } = [];

    /// <summary>Additional information.</summary>
    public IReadOnlyList<string> Notes { get; init; } = [];

    /// <summary>The files that are cut with: the program of the offsets, if there is one, and the program.</summary>
    public IReadOnlyList<string> Targets => [.. Correction?.File is { } offsets ? [offsets] : Array.Empty<string>(), Program.File];

    /// <summary>True if the program is the original, byte for byte.</summary>
    public bool IsUnchanged => Program.ChangedBlocks == 0 && Proof.Marker is null;

    /// <summary>True if something is corrected, by the program or by an offset.</summary>
    public bool IsCorrected => !IsUnchanged || Correction is { Choice.IsOffset: true };

    /// <summary>The key points that a warning reports on rounded corners: each says something about both elements.</summary>
    public IReadOnlyList<string> OnCorners =>
        [.. Warnings.Where(w => w.Code == WarningForms.PointOnCorner.Name && w.Values.Count > 0).Select(w => w.Values[0])];

    /// <summary>The prediction in the form of a verification: without compensation, the deviation that the decision is based on; with it,
    /// what the program as written is predicted to leave.</summary>
    public VerificationResult Prediction
    {
        get
        {
            VerifiedPoint[] points = [
                .. KeyPoints.Select(p => new VerifiedPoint(
                    p.Point, p.Actual, p.Actual + (p.UncompensatedMm * p.Normal), p.Actual + (p.PredictedMm * p.Normal), p.Normal))];
            var byFeature = points.Zip(KeyPoints).ToLookup(p => p.Second.Feature, p => p.First, StringComparer.Ordinal);
            return new(points, [.. Features.Select(f => VerifiedFeature.DeviationOf(f.Name, [.. byFeature[f.Name]]))])
            {
                Boundaries = [
                    .. Features.Select(f => new VerifiedBoundary(
                        f.Name, f.Tolerance.Band, [.. PointsOf(f).Select(p => (p.Point, CutPlace(f, p)))], f.TheoreticalOutline))],
            };
        }
    }

    // Where the original program cuts the boundary at a key point, to which its outline belongs: beside the theoretical point by what it
    // does differently.
    private static Point2 CutPlace(ReportFeature feature, ReportKeyPoint point) => feature.BaseMm is null
        ? point.Theoretical
        : point.Theoretical + ((point.UncompensatedMm + point.NormalMm - feature.GapMm) * point.Normal);

    /// <summary>The key points of a feature, in the order of cutting.</summary>
    public IEnumerable<ReportKeyPoint> PointsOf(ReportFeature feature) => KeyPoints.Where(p => p.Feature == feature.Name);

    /// <summary>The key points of a feature that the program is predicted to leave outside their limits.</summary>
    public OutsideLimits OutsideOf(ReportFeature feature) => OutsideOf(PointsOf(feature));

    /// <summary>The key points of a feature whose deviation is outside the tolerance, the furthest first.</summary>
    public IReadOnlyList<ReportKeyPoint> BeyondTolerance(ReportFeature feature) =>
        [.. PointsOf(feature).Where(p => p.ExcessMm != 0).OrderByDescending(p => Math.Abs(p.ExcessMm))];

    /// <summary>The measured mating errors of the counterpart compared with the predicted ones, in the order of cutting.</summary>
    public IReadOnlyList<PredictionMiss> MissesOf(VerificationResult measured)
    {
        ArgumentNullException.ThrowIfNull(measured);
        var errors = measured.Points.ToDictionary(p => p.Label, p => p.AfterError.NormalMm, StringComparer.Ordinal);
        var uncertainty = Features.ToDictionary(f => f.Name, f => f.UncertaintyMm, StringComparer.Ordinal);
        return [
            .. KeyPoints.Where(p => errors.ContainsKey(p.Point)).Select(
                p => new PredictionMiss(p.Point, p.PredictedMm, errors[p.Point], uncertainty[p.Feature]))];
    }

    private OutsideLimits OutsideOf(IEnumerable<ReportKeyPoint> points)
    {
        var bands = Features.ToDictionary(f => f.Name, f => f.Tolerance.Band.Opposite(), StringComparer.Ordinal);
        return OutsideLimits.Of(points.Select(
            p => new LimitedPoint(p.Point, bands.GetValueOrDefault(p.Feature), p.UncompensatedMm, p.PredictedMm)));
    }
}
