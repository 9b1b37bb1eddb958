using ErrorMatching.Geometry;

namespace ErrorMatching.Nc;

/// <summary>The place that a block of its own states for later arcs and polar ends (CC).</summary>
/// <param name="Place">The place in its plane, in programmed coordinates, mm.</param>
/// <param name="Plane">The plane of the two axes that it names.</param>
/// <param name="Frame">The layers of coordinates in which it was stated; it is known in these only.</param>
/// <param name="IsKnown">False if there is none, or if only the machine knows it.</param>
internal readonly record struct ArcPole(Point2 Place, CoordinatePlane Plane, int Frame, bool IsKnown)
{
    /// <summary>True if both are equal to the last bit.</summary>
    public bool SameAs(in ArcPole other) => Plane == other.Plane && Frame == other.Frame && IsKnown == other.IsKnown
        && BitConverter.DoubleToInt64Bits(Place.X) == BitConverter.DoubleToInt64Bits(other.Place.X)
        && BitConverter.DoubleToInt64Bits(Place.Y) == BitConverter.DoubleToInt64Bits(other.Place.Y);
}
