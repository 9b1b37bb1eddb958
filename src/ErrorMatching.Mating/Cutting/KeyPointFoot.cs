using ErrorMatching.Geometry;

namespace ErrorMatching.Mating;

/// <summary>The place of a key point on the path of its feature's blocks.</summary>
/// <param name="Label">Name of the key point.</param>
/// <param name="Motion">Position of the nearest motion in the path.</param>
/// <param name="Fraction">Position of the foot on that motion, 0 to 1.</param>
/// <param name="DistanceMm">Distance of the theoretical key point from the path.</param>
/// <param name="Normal">Unit normal at the foot, from the counterpart's material to its tool, in the program's frame: of the motion, or
/// on a corner from the point to the vertex.</param>
/// <param name="MaterialIsLeft">True if the material is to the left of travel.</param>
/// <param name="OnCorner">True if the point is beside an end of the motion, where the tool's circle about a vertex forms the boundary,
/// which follows both adjacent elements.</param>
public sealed record KeyPointFoot(
    string Label, int Motion, double Fraction, double DistanceMm, Vector2 Normal, bool MaterialIsLeft, bool OnCorner)
{
    /// <summary>Distance of the point beyond that end, along the motion, mm. Moved this far away from the corner, it would be beside the
    /// motion, where it says something about that element alone. 0 unless <see cref="OnCorner"/>.</summary>
    public double BeyondEndMm { get; init; }
}
