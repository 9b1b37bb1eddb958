using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>What a decision means at one key point.</summary>
/// <param name="Point">The key point.</param>
/// <param name="ExcessMm">What of its normal deviation lies beyond the limit, signed; zero inside the tolerance.</param>
/// <param name="Correction">By what the boundary is to be displaced there, in the part's frame, gain included;
/// zero where the feature is not compensated.</param>
public sealed record PointDecision(BoundaryPoint Point, double ExcessMm, Vector2 Correction)
{
    /// <summary>Signed length of the correction along the point's normal.</summary>
    public double CorrectionNormalMm => Correction.Dot(Point.Normal);
}
