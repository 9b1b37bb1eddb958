namespace ErrorMatching.Hmi;

/// <summary>A length or an angle of a feature in a kept report.</summary>
/// <param name="Name">What it is, its unit at the end, such as <c>lengthMm</c>.</param>
/// <param name="Theoretical">As designed.</param>
/// <param name="Actual">As measured.</param>
/// <param name="Corrected">As the corrected counterpart is predicted to have it; null where it has none.</param>
public sealed record KeptQuantity(string Name, double Theoretical, double? Actual, double? Corrected)
{
    /// <summary>True for an angle in degrees, false for a length in mm.</summary>
    public bool IsAngle => Name.EndsWith("Deg", StringComparison.Ordinal);
}
