namespace ErrorMatching.Mating;

/// <summary>A quantity of a feature as designed and as measured.</summary>
/// <param name="Name">Its name with the unit at the end, such as <c>lengthMm</c>: one of <see cref="FeatureKind.Quantities"/>.</param>
/// <param name="Theoretical">Its value from the theoretical points.</param>
/// <param name="Actual">Its value from the measured points.</param>
/// <param name="StandardUncertainty">First-order standard uncertainty of the actual value, from residuals and gauge uncertainty.</param>
public sealed record FeatureQuantity(string Name, double Theoretical, double Actual, double StandardUncertainty)
{
    /// <summary>The direction of cutting along a straight element.</summary>
    internal const string Direction = "directionDeg";

    /// <summary>True for an angle in degrees, false for a length in mm.</summary>
    public bool IsAngle => Name.EndsWith("Deg", StringComparison.Ordinal);

    /// <summary>Theoretical - actual, as in the paper's tables; directions are in (-180, 180] degrees.</summary>
    public double Deviation =>
        Name == Direction ? Geometry.Angle.FromDegrees(Theoretical - Actual).Normalized.Degrees : Theoretical - Actual;
}
