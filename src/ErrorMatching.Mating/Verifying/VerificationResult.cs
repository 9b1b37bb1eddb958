namespace ErrorMatching.Mating;

/// <summary>The fit of two counterparts, without and with compensation, to one part.</summary>
/// <param name="Points">The key points in the order of cutting.</param>
/// <param name="Features">The quantities of each feature, then the job's comparisons.</param>
public sealed record VerificationResult(IReadOnlyList<VerifiedPoint> Points, IReadOnlyList<VerifiedFeature> Features)
{
    /// <summary>The largest mating error along a normal before compensation, without sign.</summary>
    public double MaxBeforeMm => Points.Max(p => Math.Abs(p.BeforeError.NormalMm));

    /// <summary>The largest mating error along a normal after compensation, without sign.</summary>
    public double MaxAfterMm => Points.Max(p => Math.Abs(p.AfterError.NormalMm));

    /// <summary>The root mean square of the mating errors along the normals before compensation.</summary>
    public double RmsBeforeMm => Rms(p => p.BeforeError);

    /// <summary>The root mean square of the mating errors along the normals after compensation.</summary>
    public double RmsAfterMm => Rms(p => p.AfterError);

    /// <summary>Reduction of the root mean square, in percent; negative if it grew, null if it was zero.</summary>
    public double? RmsImprovementPercent => RmsBeforeMm > 0 ? 100 * (RmsBeforeMm - RmsAfterMm) / RmsBeforeMm : null;

    private double Rms(Func<VerifiedPoint, MatingError> error) => Math.Sqrt(Points.Average(p => error(p).NormalMm * error(p).NormalMm));
}
