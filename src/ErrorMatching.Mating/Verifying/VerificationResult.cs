using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>The fit of two counterparts, without and with compensation, to one part.</summary>
/// <param name="Points">The key points in the order of cutting.</param>
/// <param name="Features">The quantities of each feature, then the job's comparisons.</param>
public sealed record VerificationResult(IReadOnlyList<VerifiedPoint> Points, IReadOnlyList<VerifiedFeature> Features)
{
    /// <summary>The boundaries of the features, with the limits of their points.</summary>
    public IReadOnlyList<VerifiedBoundary> Boundaries { get; init; } = [];

    /// <summary>The point with the largest mating error along its normal before compensation.</summary>
    public VerifiedPoint WorstBefore => Points.MaxBy(p => Math.Abs(p.BeforeError.NormalMm))!;

    /// <summary>The point with the largest mating error along its normal after compensation.</summary>
    public VerifiedPoint WorstAfter => Points.MaxBy(p => Math.Abs(p.AfterError.NormalMm))!;

    /// <summary>The largest mating error along a normal before compensation, without sign.</summary>
    public double MaxBeforeMm => Math.Abs(WorstBefore.BeforeError.NormalMm);

    /// <summary>The largest mating error along a normal after compensation, without sign.</summary>
    public double MaxAfterMm => Math.Abs(WorstAfter.AfterError.NormalMm);

    /// <summary>The root mean square of the mating errors along the normals before compensation.</summary>
    public double RmsBeforeMm => Rms(p => p.BeforeError);

    /// <summary>The root mean square of the mating errors along the normals after compensation.</summary>
    public double RmsAfterMm => Rms(p => p.AfterError);

    /// <summary>Reduction of the root mean square, in percent; negative if it grew, null if it was zero.</summary>
    public double? RmsImprovementPercent => RmsBeforeMm > 0 ? 100 * (RmsBeforeMm - RmsAfterMm) / RmsBeforeMm : null;

    /// <summary>The points whose mating error after compensation is outside its limits.</summary>
    public OutsideLimits Outside =>
        OutsideLimits.Of(Points.Select(p => new LimitedPoint(p.Label, BandOf(p.Label), p.BeforeError.NormalMm, p.AfterError.NormalMm)));

    /// <summary>The boundary of a point; null if it has none.</summary>
    public VerifiedBoundary? BoundaryOf(string point) => Boundaries.FirstOrDefault(b => b.Points.Any(p => p.Label == point));

    /// <summary>The limits of the mating error at a point; null if it has none.</summary>
    public ToleranceBand? BandOf(string point) => BoundaryOf(point)?.ErrorBand;

    /// <summary>True if a mating error is outside the limits of a point.</summary>
    public bool IsOutside(string point, double errorMm) => BandOf(point) is { } band && !band.Contains(errorMm);

    private double Rms(Func<VerifiedPoint, MatingError> error) => Math.Sqrt(Points.Average(p => error(p).NormalMm * error(p).NormalMm));
}
