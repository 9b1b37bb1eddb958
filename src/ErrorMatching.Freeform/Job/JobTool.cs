namespace ErrorMatching.Freeform;

/// <summary>A ball end mill with its speed and feed.</summary>
/// <param name="DiameterMm">Diameter of the ball.</param>
/// <param name="Flutes">Number of cutting edges.</param>
/// <param name="SpindleRpm">Revolutions per minute.</param>
/// <param name="FeedMmPerMin">Feed along the path.</param>
public sealed record JobTool(double DiameterMm, int Flutes, double SpindleRpm, double FeedMmPerMin)
{
    /// <summary>Radius of the ball in millimeters.</summary>
    public double RadiusMm => DiameterMm / 2;
}
