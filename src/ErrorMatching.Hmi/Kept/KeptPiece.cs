using ErrorMatching.Cell;
using ErrorMatching.Mating;

namespace ErrorMatching.Hmi;

/// <summary>Fit of a piece and its counterpart, without and with compensation: measured on the counterpart cut for it, or
/// predicted until then.</summary>
/// <param name="Correction">The correction that produced the counterpart's program.</param>
/// <param name="Counterpart">The measurement of the counterpart cut with it; null while the result is predicted.</param>
/// <param name="JobName">Name of the job.</param>
/// <param name="Result">The mating errors.</param>
/// <param name="Boundaries">The boundaries of the features.</param>
/// <param name="IsBeforeMeasured">True if the counterpart without compensation was measured, false if its nominal shape is used.</param>
public sealed record KeptPiece(
    Correction Correction,
    Correction? Counterpart,
    string JobName,
    VerificationResult Result,
    IReadOnlyList<VerifiedBoundary> Boundaries,
    bool IsBeforeMeasured)
{
    /// <summary>True if the counterpart cut with the compensation was measured.</summary>
    public bool IsMeasured => Counterpart is not null;

    /// <summary>The number of the last measurement.</summary>
    public long LastId => Counterpart?.Id ?? Correction.Id;

    /// <summary>True if every mating error with compensation is within its limits.</summary>
    public bool IsWithin => Outside.Count == 0;

    /// <summary>The key points whose mating error with compensation is outside its limits, in the order of cutting.</summary>
    public IReadOnlyList<string> Outside => Limits.Points;

    /// <summary>The points of <see cref="Outside"/> that are within their limits without compensation: the compensation makes
    /// them worse, for example next to a corner that follows its neighbors.</summary>
    public IReadOnlyList<string> PushedOut => Limits.DrivenOut;

    /// <summary>True if a mating error is outside the limits of its key point.</summary>
    public bool IsOutside(string point, double errorMm) => BandOf(point) is { } band && !band.Contains(errorMm);

    /// <summary>The match that the counterpart was cut by; null if it is not in the store.</summary>
    public KeptReport? Match { get; init; }

    /// <summary>The counterpart that the errors without compensation are based on; null if its nominal shape is used.</summary>
    public KeptBase? Before { get; init; }

    /// <summary>The measured errors compared with the predicted ones, in the order of cutting; empty while nothing is measured,
    /// or if no prediction is known.</summary>
    public IReadOnlyList<PredictionMiss> Misses
    {
        get
        {
            if (!IsMeasured || Match is null)
            {
                return [];
            }

            var measured = Result.Points.ToDictionary(p => p.Label, p => p.AfterError.NormalMm, StringComparer.Ordinal);
            var uncertainty = Match.Features.ToDictionary(f => f.Name, f => f.UncertaintyMm, StringComparer.Ordinal);
            return [
                .. Match.Points.Where(p => measured.ContainsKey(p.Point)).Select(p => new PredictionMiss(
                    p.Point, p.PredictedMm, measured[p.Point], uncertainty[p.Feature]))];
        }
    }

    private OutsideLimits Limits =>
        OutsideLimits.Of(Result.Points.Select(p => (p.Label, BandOf(p.Label), p.BeforeError.NormalMm, p.AfterError.NormalMm)));

    /// <summary>The boundary of a key point.</summary>
    public VerifiedBoundary? BoundaryOf(string point) => Boundaries.FirstOrDefault(b => b.Points.Any(p => p.Label == point));

    /// <summary>The limits of the mating error at a key point.</summary>
    public ToleranceBand? BandOf(string point) => BoundaryOf(point)?.ErrorBand;

    /// <summary>The prediction in a match report: the deviation that was the basis of the decision, and what is predicted to
    /// remain.</summary>
    public static KeptPiece Predicted(Correction correction, KeptReport report)
    {
        ArgumentNullException.ThrowIfNull(report);
        VerifiedPoint[] points = [
            .. report.Points.Select(p => new VerifiedPoint(
                p.Point, p.Actual, p.Actual + (-p.DecidedMm * p.Normal), p.Actual + (p.PredictedMm * p.Normal), p.Normal))];
        var byLabel = points.ToDictionary(p => p.Label, StringComparer.Ordinal);
        var boundaries = report.Features
            .Select(f => new VerifiedBoundary(
                f.Name,
                new(f.LowerMm, f.UpperMm),
                [.. report.Points.Where(p => p.Feature == f.Name).Select(p => (p.Point, p.Theoretical))],
                f.Outline))
            .ToArray();
        return new(
            correction,
            null,
            report.JobName,
            new(points, [.. boundaries.Select(b => VerifiedFeature.DeviationOf(b.Name, [.. b.Points.Select(p => byLabel[p.Label])]))]),
            boundaries,
            correction.Piece == "counterpart")
        {
            Match = report,
            Before = correction.Piece == "counterpart" ? new(correction.FileName, correction.MeasurementSha256) : null,
        };
    }
}
