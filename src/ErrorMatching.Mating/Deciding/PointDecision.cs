using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>The effect of a decision at one key point.</summary>
/// <param name="Point">The key point.</param>
/// <param name="ExcessMm">Signed part of its normal deviation beyond the limit; zero inside the tolerance.</param>
/// <param name="Correction">Displacement of the boundary there, in the part's frame, gain included; zero if the feature is not
/// compensated.</param>
public sealed record PointDecision(BoundaryPoint Point, double ExcessMm, Vector2 Correction)
{
    /// <summary>Signed length of the correction along the point's normal.</summary>
    public double CorrectionNormalMm => Correction.Dot(Point.Normal);
}
