namespace ErrorMatching.Freeform;

/// <summary>The cutting program that a probing program follows in a merged file.</summary>
/// <param name="MeasurementSha256">The measurement that the cutting program followed, in capitals, or <see cref="Damaged"/>; null if it
/// carries no marker.</param>
internal sealed record ProbedBehind(string? MeasurementSha256)
{
    /// <summary>Replaces a hash that cannot be read.</summary>
    public const string Damaged = "DAMAGED";
}
