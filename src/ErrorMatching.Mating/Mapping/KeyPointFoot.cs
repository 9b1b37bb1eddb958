using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>Where a key point belongs on the path of its feature's blocks.</summary>
/// <param name="Label">Name of the key point.</param>
/// <param name="Motion">Position of the nearest motion in the path.</param>
/// <param name="Fraction">Where on that motion the foot lies, 0 to 1.</param>
/// <param name="DistanceMm">Distance of the theoretical key point from the path.</param>
/// <param name="Normal">Unit normal at the foot, from the counterpart's material to its tool, in the program's frame.</param>
/// <param name="MaterialIsLeft">True if the material lies to the left of travel.</param>
/// <param name="OnCorner">True if the point lies beside an end of the motion, where the tool's circle about a vertex makes the boundary: it
/// follows both elements that meet there.</param>
public sealed record KeyPointFoot(
    string Label, int Motion, double Fraction, double DistanceMm, Vector2 Normal, bool MaterialIsLeft, bool OnCorner)
{
    /// <summary>How far beyond that end the point lies, along the motion, mm: so much further from the corner it lies beside the motion,
    /// where its own deviation can be met; 0 unless <see cref="OnCorner"/>.</summary>
    public double BeyondEndMm { get; init; }
}
