namespace ErrorMatching.Mating;

/// <summary>A quantity of a feature as designed and as measured.</summary>
/// <param name="Name">What it is, its unit at the end, such as <c>lengthMm</c>: one of <see cref="FeatureKind.Quantities"/>.</param>
/// <param name="Theoretical">Its value by the theoretical points.</param>
/// <param name="Actual">Its value by the measured points.</param>
/// <param name="StandardUncertainty">Standard uncertainty of the actual value, from the residuals and the gauge's uncertainty, to first
/// order.</param>
public sealed record FeatureQuantity(string Name, double Theoretical, double Actual, double StandardUncertainty)
{
    /// <summary>The direction of cutting along something straight.</summary>
    internal const string Direction = "directionDeg";

    /// <summary>Theoretical - actual, as the paper's tables print it; of directions in (-180, 180] degrees.</summary>
    public double Deviation =>
        Name == Direction ? Geometry.Angle.FromDegrees(Theoretical - Actual).Normalized.Degrees : Theoretical - Actual;
}
