namespace ErrorMatching.Hmi;

/// <summary>A length or an angle of a feature in a stored report.</summary>
/// <param name="Name">Its name with the unit at the end, such as <c>lengthMm</c>.</param>
/// <param name="Theoretical">Nominal value.</param>
/// <param name="Actual">Measured value.</param>
/// <param name="Corrected">Predicted value of the corrected counterpart; null if there is none.</param>
public sealed record KeptQuantity(string Name, double Theoretical, double? Actual, double? Corrected)
{
    /// <summary>True for an angle in degrees, false for a length in mm.</summary>
    public bool IsAngle => Name.EndsWith("Deg", StringComparison.Ordinal);
}
