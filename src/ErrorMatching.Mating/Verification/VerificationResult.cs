namespace ErrorMatching.Mating;

/// <summary>How well two counterparts, without and with compensation, fit one part.</summary>
/// <param name="Points">The key points in the order of cutting.</param>
/// <param name="Features">Feature by feature its quantities, then the job's comparisons.</param>
public sealed record VerificationResult(IReadOnlyList<VerifiedPoint> Points, IReadOnlyList<VerifiedFeature> Features)
{
    /// <summary>The largest mating error along a normal before, without sign.</summary>
    public double MaxBeforeMm => Points.Max(p => Math.Abs(p.BeforeError.NormalMm));

    /// <summary>The largest mating error along a normal after, without sign.</summary>
    public double MaxAfterMm => Points.Max(p => Math.Abs(p.AfterError.NormalMm));

    /// <summary>The root mean square of the mating errors along the normals before.</summary>
    public double RmsBeforeMm => Rms(p => p.BeforeError);

    /// <summary>The root mean square of the mating errors along the normals after.</summary>
    public double RmsAfterMm => Rms(p => p.AfterError);

    /// <summary>By how much the root mean square became smaller, in percent; negative where it grew, null where there was none.</summary>
    public double? RmsImprovementPercent => RmsBeforeMm > 0 ? 100 * (RmsBeforeMm - RmsAfterMm) / RmsBeforeMm : null;

    private double Rms(Func<VerifiedPoint, MatingError> error) => Math.Sqrt(Points.Average(p => error(p).NormalMm * error(p).NormalMm));
}
