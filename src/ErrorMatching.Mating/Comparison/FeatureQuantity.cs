namespace ErrorMatching.Mating;

/// <summary>A quantity of a feature as designed and as measured.</summary>
/// <param name="Name">What it is, its unit at the end: <c>lengthMm</c>, <c>directionDeg</c>, <c>apexXMm</c>, <c>apexYMm</c>, <c>angleDeg</c>, <c>firstFlankMm</c>, <c>secondFlankMm</c>, <c>chordMm</c>, <c>arcLengthMm</c>.</param>
/// <param name="Theoretical">Its value by the theoretical points.</param>
/// <param name="Actual">Its value by the measured points.</param>
/// <param name="StandardUncertainty">Standard uncertainty of the actual value, from the residuals and the gauge's uncertainty, to first order.</param>
public sealed record FeatureQuantity(string Name, double Theoretical, double Actual, double StandardUncertainty)
{
    /// <summary>Theoretical - actual, as the paper's tables print it; of directions in (-180, 180] degrees.</summary>
    public double Deviation => Name == Direction ? Geometry.Angle.FromDegrees(Theoretical - Actual).Normalized.Degrees : Theoretical - Actual;

    internal const string Length = "lengthMm";
    internal const string Direction = "directionDeg";
    internal const string ApexX = "apexXMm";
    internal const string ApexY = "apexYMm";
    internal const string IncludedAngle = "angleDeg";
    internal const string FirstFlank = "firstFlankMm";
    internal const string SecondFlank = "secondFlankMm";
    internal const string Chord = "chordMm";
    internal const string ArcLength = "arcLengthMm";
}
