namespace ErrorMatching.Freeform;

/// <summary>What a probing program follows, which cut the surface just before.</summary>
/// <param name="MeasurementSha256">The measurement that the program follows which cut, in capitals, or <see cref="Damaged"/>; null if it carries no marker.</param>
internal sealed record ProbedBehind(string? MeasurementSha256)
{
    /// <summary>Stands for a measurement whose hash cannot be read any more.</summary>
    public const string Damaged = "DAMAGED";
}
